// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <set>

#include "app/cli/commands.hpp"
#include "app/cli/describe_tree.hpp"
#include "base/file.hpp"
#include "base/text.hpp"
#include "pack/tree_level.hpp"

namespace vitrine {
namespace {

using Json = nlohmann::ordered_json;

Json describeSnippet(const Snippet& snippet) {
    Json json{{"file", snippet.file}, {"entry", snippet.entry}, {"uses_time", snippet.usesTime}};
    if (!snippet.partNames.empty()) json["parts"] = snippet.partNames;
    if (snippet.box()) {
        const Aabb& b = *snippet.box();
        json["bounds"] = {b.min.x, b.min.y, b.min.z, b.max.x, b.max.y, b.max.z};
    }
    if (snippet.lipschitz) json["lipschitz"] = *snippet.lipschitz;
    if (snippet.kind == SnippetKind::kField) json["steps_divided_by"] = snippet.stepDivisor();
    json["parameters"] = Json::array();
    for (const Parameter& p : snippet.parameters) {
        const auto numbers = [&](const glm::vec4& v) {
            Json list = Json::array();
            for (int i = 0; i < componentCount(p.type); ++i) list.push_back(v[i]);
            return list.size() == 1 ? list[0] : list;
        };
        json["parameters"].push_back({{"name", p.name},
                                      {"type", glslName(p.type)},
                                      {"minimum", numbers(p.minimum)},
                                      {"default", numbers(p.defaultValue)},
                                      {"maximum", numbers(p.maximum)},
                                      {"label", p.label}});
    }
    return json;
}

Json describeTextures(const LoadedScene& loaded) {
    std::set<const void*> pictures;
    for (const auto& ofMaterial : loaded.assets.pictures)
        for (const auto& picture : ofMaterial)
            if (picture != nullptr) pictures.insert(picture.get());
    size_t bytes = 0;
    for (const TextureAtlas* atlas : {&loaded.packed.textures.color, &loaded.packed.textures.data})
        for (const TexturePage& page : atlas->pages) bytes += page.texels.size();
    return {{"pictures", pictures.size()}, {"bytes", bytes}};
}

Json describe(const LoadedScene& loaded, bool builders) {
    Json json{{"scene", loaded.scene.file},
              {"title", loaded.scene.title},
              {"triangles", loaded.packed.triangleCount},
              {"instances", loaded.packed.instances.size()},
              {"animations", loaded.scene.animations.size()},
              {"lights", loaded.scene.lights.size()},
              {"materials", loaded.scene.materials.size()},
              {"stack_entries", loaded.packed.stackBound},
              {"tree_bytes", (loaded.packed.slots.size() + loaded.packed.upperSlots.size()) *
                                 sizeof(glm::uvec4)}};
    for (const Camera& camera : loaded.scene.cameras) json["cameras"].push_back(camera.name);
    json["textures"] = describeTextures(loaded);
    json["meshes"] = Json::array();
    json["snippets"] = Json::array();
    std::set<const void*> seen;
    for (size_t i = 0; i < loaded.assets.meshes.size(); ++i) {
        if (const auto& mesh = loaded.assets.meshes[i]; mesh && seen.insert(mesh.get()).second)
            json["meshes"].push_back(
                describeMesh(loaded.scene.shapes[i].name, *mesh, loaded.scene.bvh, builders));
    }
    for (const auto* list : {&loaded.assets.fields, &loaded.assets.materials})
        for (const auto& snippet : *list)
            if (snippet && seen.insert(snippet.get()).second)
                json["snippets"].push_back(describeSnippet(*snippet));
    return json;
}

void print(const Json& json) {
    fmt::print("{}\n{} triangles, {} instances, {} lights, {} materials\n",
               json["scene"].get<std::string>(), json["triangles"].get<size_t>(),
               json["instances"].get<size_t>(), json["lights"].get<size_t>(),
               json["materials"].get<size_t>());
    if (const auto pictures = json["textures"]["pictures"].get<size_t>(); pictures > 0)
        fmt::print("{} pictures, {:.1f} MiB of textures\n", pictures,
                   json["textures"]["bytes"].get<double>() / (1 << 20));
    if (json["cameras"].size() > 1)
        fmt::print("cameras: {}\n",
                   fmt::join(json["cameras"].get<std::vector<std::string>>(), ", "));
    for (const Json& m : json["meshes"]) printMesh(m);
    for (const Json& s : json["snippets"]) {
        fmt::print("snippet {}: {}()\n", s["file"].get<std::string>(),
                   s["entry"].get<std::string>());
        for (const Json& p : s["parameters"])
            fmt::print("  {} {} = {}  ({} to {})  {}\n", p["type"].get<std::string>(),
                       p["name"].get<std::string>(), p["default"].dump(), p["minimum"].dump(),
                       p["maximum"].dump(), p["label"].get<std::string>());
    }
}

}  // namespace

int info(const InfoOptions& options) {
    if (!options.exportBoxes.empty()) {
        if (!endsWith(options.exportBoxes, ".obj"))
            throw UsageError(
                fmt::format("--export-bvh: '{}' must end in .obj", options.exportBoxes));
        checkWritable(options.exportBoxes);
    }
    Diagnostics diagnostics;
    const LoadedScene loaded = loadAll(options.file, options.overrides, diagnostics);
    diagnostics.throwIfErrors();
    if (!options.exportBoxes.empty()) {
        const auto& instances = loaded.packed.instances;
        writeFileAtomically(options.exportBoxes,
                            objOfTreeLevel(instances, treeLevel(instances, options.level)));
    }
    const Json json = describe(loaded, options.builders);
    if (options.json.empty())
        print(json);
    else
        writeJson(options.json, json.dump(2));
    return 0;
}

}  // namespace vitrine
