// SPDX-License-Identifier: MIT
#include "gltf/read.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "base/file.hpp"
#include "gltf/glb.hpp"
#include "gltf/json_document.hpp"
#include "gltf/read_animations.hpp"
#include "gltf/read_materials.hpp"
#include "gltf/read_meshes.hpp"
#include "gltf/read_nodes.hpp"
#include "gltf/read_textures.hpp"

namespace vitrine {
namespace {

constexpr std::string_view kQuantization = "KHR_mesh_quantization";
constexpr std::array<std::string_view, 11> kExtensions{
    "KHR_lights_punctual",
    "KHR_materials_clearcoat",
    "KHR_materials_emissive_strength",
    "KHR_materials_ior",
    "KHR_materials_sheen",
    "KHR_materials_specular",
    "KHR_materials_transmission",
    "KHR_materials_unlit",
    "KHR_materials_volume",
    kQuantization,
    "KHR_texture_transform",
};

/// "2.0" to {2, 0}; nothing if it looks otherwise.
std::optional<std::pair<int, int>> parseVersion(const std::string& text) {
    int major = 0, minor = 0;
    char rest = 0;
    if (std::sscanf(text.c_str(), "%3d.%3d%c", &major, &minor, &rest) != 2) return {};
    return std::pair(major, minor);
}

/// False, with an error, if this reader is too old or the file too old for it.
bool checkVersion(const JsonValue& root) {
    const JsonValue asset = root.object("asset");
    if (!asset.exists()) {
        root.error("'asset' is missing: this is no glTF");
        return false;
    }
    for (const char* key : {"version", "minVersion"}) {
        const bool isRequired = key[0] == 'v';
        if (!isRequired && !asset.has(key)) continue;
        const std::string text = asset.text(key);
        const auto version = parseVersion(text);
        // Any 2.x can be read as 2.0 unless minVersion says otherwise.
        if (version && version->first == 2 && (isRequired || version->second == 0)) continue;
        asset.error(key, fmt::format("version {} is not supported, only 2.0 is", inQuotes(text)));
        return false;
    }
    return true;
}

/// The names in extensionsUsed and extensionsRequired, after warnings and errors about those that
/// are not supported.
std::vector<std::string> checkExtensions(const JsonValue& root) {
    const auto isSupported = [](const std::string& name) {
        return std::find(kExtensions.begin(), kExtensions.end(), name) != kExtensions.end();
    };
    const JsonValue used = root.array("extensionsUsed"),
                    required = root.array("extensionsRequired");
    std::vector<std::string> names, requiredNames;
    for (size_t i = 0; i < required.size(); ++i) {
        requiredNames.push_back(required.textAt(i));
        if (!isSupported(requiredNames.back()))
            required.error(
                fmt::format("the file cannot be shown without the extension {}, which is "
                            "not supported",
                            inQuotes(requiredNames.back())));
    }
    for (size_t i = 0; i < used.size(); ++i) {
        names.push_back(used.textAt(i));
        const bool isRequired = std::find(requiredNames.begin(), requiredNames.end(),
                                          names.back()) != requiredNames.end();
        if (!isSupported(names.back()) && !isRequired)
            used.warnOnce(fmt::format("the extension {} is not supported and ignored",
                                      inQuotes(names.back())));
    }
    names.insert(names.end(), requiredNames.begin(), requiredNames.end());
    return names;
}

void readModel(ReadContext& context, std::optional<std::string_view> binary) {
    if (!checkVersion(context.root)) return;
    const std::vector<std::string> extensions = checkExtensions(context.root);
    if (context.report.hasErrors()) return;
    const Buffers buffers(context, binary);
    const Accessors accessors(context, buffers);
    readTextures(context, buffers);
    readMaterials(context);
    readMeshes(context, accessors,
               std::find(extensions.begin(), extensions.end(), kQuantization) != extensions.end());
    readCameras(context);
    readLights(context);
    if (!readNodes(context)) return;
    readAnimations(context, accessors);
    skipUnusableNodes(context);
}

void readBytes(const std::string& bytes, const std::filesystem::path& file,
               const GltfLimits& limits, Report& report, GltfModel& model) {
    GlbChunks chunks{bytes, 0, {}};
    if (isGlb(bytes)) {
        const auto split = splitGlb(bytes, report);
        if (!split) return;
        chunks = *split;
    }
    report.setJson(chunks.json, chunks.jsonByte);
    if (chunks.json.size() > limits.jsonBytes) {
        report.error("", fmt::format("{} bytes of JSON are too many: at most {} are read",
                                     chunks.json.size(), limits.jsonBytes));
        return;
    }
    const auto json = parseJson(chunks.json, {limits.jsonValues, limits.jsonDepth}, report);
    if (!json) return;
    if (!json->is_object()) {
        report.error("", "the JSON must be an object");
        return;
    }
    ReadContext context{file.parent_path(), report, limits, JsonValue(&*json, "", report), model};
    context.left.bytes -= bytes.size();
    readModel(context, chunks.binary);
}

}  // namespace

std::optional<GltfModel> readGltf(const std::filesystem::path& file, Diagnostics& diagnostics,
                                  const GltfLimits& limits) {
    Report report(file.string(), diagnostics, limits.messages);
    GltfModel model;
    try {
        readBytes(readFile(file, limits.bytes), file, limits, report, model);
    } catch (const InputError& e) {
        diagnostics.append(e.diagnostics());
        return {};
    } catch (const Report::Flood&) {
        return {};
    }
    if (report.hasErrors()) return {};
    return model;
}

}  // namespace vitrine
