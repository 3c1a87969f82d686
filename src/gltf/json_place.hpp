// SPDX-License-Identifier: MIT
// From a JSON pointer back to the line of the text, for messages: the parser's values do not know
// where they came from, and a message about one of them is rare enough to look again.
#pragma once

#include <string_view>

namespace vitrine {

/// Both count from 1, columns in bytes.
struct JsonPlace {
    int line = 1;
    int column = 1;
};

/// Where the value begins that `pointer` (RFC 6901) names, or the innermost value around it that
/// exists. `json` must be valid; if it is not, the place is wrong but inside the text.
JsonPlace findJsonPlace(std::string_view json, std::string_view pointer);

/// The line and column of a byte.
JsonPlace placeOfByte(std::string_view text, size_t byte);

}  // namespace vitrine
