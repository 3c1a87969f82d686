// SPDX-License-Identifier: MIT
// What the readers of a glTF file's parts share.
#pragma once

#include <filesystem>
#include <string>

#include "gltf/json_value.hpp"
#include "gltf/model.hpp"
#include "gltf/read.hpp"
#include "gltf/report.hpp"

namespace vitrine {

struct ReadContext {
    std::filesystem::path folder;
    Report& report;
    const GltfLimits& limits;
    JsonValue root;
    GltfModel& model;
    GltfLimits left = limits;  ///< what may still be used

    /// Takes `amount` off a limit. False, with an error at `place`, if that is more than is left;
    /// to be asked before the memory is.
    bool spend(uint64_t GltfLimits::*limit, uint64_t amount, std::string_view what,
               const JsonValue& place);

    /// The bytes that a URI stands for. Throws std::invalid_argument if the URI is not allowed, and
    /// InputError if the file cannot be read or is too large.
    std::string loadUri(const std::string& uri);
};

/// The name of an object of the file, or "mesh 3" if it has none.
std::string nameOf(const JsonValue& object, std::string_view kind, size_t number);

}  // namespace vitrine
