// SPDX-License-Identifier: MIT
// Untrusted JSON text as a tree of values, with caps on depth and number.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string_view>

#include "gltf/report.hpp"

namespace vitrine {

struct JsonLimits {
    uint64_t values;
    int depth;
};

/// Nothing, with an error in the report, if the text is no JSON (RFC 8259), repeats a key, or is
/// nested deeper or holds more values than allowed. The parser needs no stack for nested values.
/// The text must be the report's.
std::optional<nlohmann::json> parseJson(std::string_view text, const JsonLimits& limits,
                                        Report& report);

}  // namespace vitrine
