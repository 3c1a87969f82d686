// SPDX-License-Identifier: MIT
// The two kinds of URI that a glTF file may use: data inside of it, and files beside it.
// Source: RFC 3986 (percent-encoding), RFC 2397 (data:), RFC 4648 (base64).
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace vitrine {

bool isDataUri(std::string_view uri);

/// What a data: URI may hold at most; for a look before memory is asked for.
size_t maxDataUriBytes(std::string_view uri);

/// The content of a data: URI, which must be in base64. Throws std::invalid_argument with a
/// sentence for the user.
std::string decodeDataUri(std::string_view uri);

/// The name of a file, still to be confined to a folder: percent-decoded, without scheme. Throws
/// std::invalid_argument with a sentence for the user.
std::string decodeFileUri(std::string_view uri);

/// For a message: in quotes, shortened; of a data: URI only its beginning.
std::string uriInQuotes(std::string_view uri);

}  // namespace vitrine
