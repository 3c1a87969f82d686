// SPDX-License-Identifier: MIT
#include "app/session/bare_file.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/file.hpp"
#include "base/text.hpp"
#include "gltf/pose.hpp"
#include "import/model_animation.hpp"
#include "mesh/obj.hpp"
#include "scene/references.hpp"
#include "sdf/snippet.hpp"

namespace vitrine {
namespace {

constexpr uint64_t kMaxSnippetBytes = 64u << 10;

/// What stands on the plinth's top at y = 0. Lengths are those of an object with a radius of 1,
/// times `unit`.
constexpr const char* kScene = R"([scene]
title = '{name}'
[render]
bounces = 3
ao_distance = {aoDistance}
[[camera]]
name = "plinth"
eye = [{eyeX}, {eyeY}, {eyeZ}]
target = [0, {targetY}, 0]
focal_length = 50
[environment]
zenith = [0.42, 0.52, 0.70]
horizon = [0.90, 0.88, 0.86]
ground = [0.20, 0.19, 0.18]
{light}[material.plinth]
base_color = [0.05, 0.052, 0.056]
roughness = 0.08
[material.floor]
base_color = [0.36, 0.35, 0.34]
roughness = 0.6
[shape.plinth]
cylinder = {{ radius = {plinthRadius}, height = {plinthHeight} }}
[shape.floor]
plane = {{ size = [{floorSize}, 0, {floorSize}] }}
{object}name = "object"
at = [{x}, {y}, {z}]
scale = {scale}
[[node]]
name = "plinth"
shape = "plinth"
material = "plinth"
at = [0, {plinthY}, 0]
[[node]]
name = "floor"
shape = "floor"
material = "floor"
at = [0, {floorY}, 0]
)";

constexpr const char* kLight = R"([[light]]
name = "key"
type = "sun"
direction = [-0.55, -0.9, -0.6]
color = [1.0, 0.95, 0.88]
intensity = 3
)";

/// Up to `[[node]]`, whose further keys follow. A model brings its own materials.
constexpr const char* kShape = R"([material.body]
base_color = [0.72, 0.70, 0.67]
roughness = 0.35
[shape.object]
{kind} = '{name}'
[[node]]
shape = "object"
material = "body"
)";
constexpr const char* kModel = R"([[node]]
include = '{name}'
)";

/// What is to be shown, before it is on the plinth.
struct Exhibit {
    Aabb box;
    bool isModel = false;  ///< .gltf or .glb: in metres, with materials
    bool hasLights = false;
};

std::optional<Exhibit> readModel(const std::filesystem::path& file, ModelLibrary& library,
                                 Diagnostics& diagnostics) {
    const auto model = library.read(file, diagnostics);
    if (model == nullptr) return {};
    const Aabb box = boundsOverTime(*model);
    if (box.empty()) {
        diagnostics.error({file.string()}, "the model has no triangles to show");
        return {};
    }
    const std::vector<int> nodes = nodesOfScene(*model, model->scene);
    const bool hasLights = std::any_of(nodes.begin(), nodes.end(), [&](int node) {
        return model->nodes[static_cast<size_t>(node)].light != kNoIndex;
    });
    return Exhibit{box, true, hasLights};
}

std::optional<Aabb> boundsOf(const std::filesystem::path& file, FieldProber& prober,
                             Diagnostics& diagnostics) {
    const std::string name = file.string();
    if (endsWith(name, ".obj")) {
        const auto mesh = readObj(readFile(file, kMaxObjBytes), name, diagnostics);
        return mesh ? std::optional(bounds(*mesh)) : std::nullopt;
    }
    auto field =
        parseSnippet(readFile(file, kMaxSnippetBytes), name, SnippetKind::kField, diagnostics);
    if (!field) return {};
    const auto measured =
        prober.measure(std::make_shared<const Snippet>(std::move(*field)), {}, diagnostics);
    return measured ? measured->box() : std::nullopt;
}

}  // namespace

bool isBareFile(const std::filesystem::path& file) {
    const std::string name = file.string();
    return isModelFile(name) || endsWith(name, ".obj") || endsWith(name, ".sdf.glsl");
}

std::optional<std::string> sceneAround(const std::filesystem::path& file, ModelLibrary& library,
                                       FieldProber& prober, Diagnostics& diagnostics) {
    const std::string name = file.filename().string();
    if (name.find_first_of("'\n\r") != std::string::npos)
        throw InputError({file.string()}, "the file's name has a quote or a line end in it");
    std::optional<Exhibit> exhibit;
    if (isModelFile(name))
        exhibit = readModel(file, library, diagnostics);
    else if (const auto box = boundsOf(file, prober, diagnostics))
        exhibit = Exhibit{*box};
    if (!exhibit) return {};
    const Aabb& box = exhibit->box;
    // Half of a nanometre or a million kilometres still make a picture.
    const float radius = std::clamp(0.5f * glm::length(box.extent()), 2e-9f, 1e18f);
    // A model keeps its size, which its lights and its glass depend on, if it has one.
    const bool keepsSize = exhibit->isModel && radius > 1e-3f && radius < 1e3f;
    const float unit = keepsSize ? radius : 1.0f;
    const float scale = keepsSize ? 1.0f : 1 / radius;
    const glm::vec3 size = box.extent() * scale;
    const glm::vec3 centre = box.centre() * scale;
    const float plinthRadius = 1.12f * 0.5f * std::hypot(size.x, size.z) + 0.05f * unit;
    const float plinthHeight = 0.35f * unit;
    const glm::vec3 toEye = glm::normalize(glm::vec3(0.62f, 0.42f, 1.0f)) * 4.4f * unit;
    using namespace fmt::literals;
    const std::string object =
        exhibit->isModel ? fmt::format(kModel, "name"_a = name)
                         : fmt::format(kShape, "name"_a = name,
                                       "kind"_a = endsWith(name, ".obj") ? "mesh" : "sdf");
    return fmt::format(kScene, "name"_a = name, "object"_a = object,
                       "light"_a = exhibit->hasLights ? "" : kLight, "aoDistance"_a = 2 * unit,
                       "eyeX"_a = toEye.x, "eyeY"_a = toEye.y + 0.5f * size.y, "eyeZ"_a = toEye.z,
                       "targetY"_a = 0.46f * size.y, "x"_a = -centre.x, "y"_a = -box.min.y * scale,
                       "z"_a = -centre.z, "plinthRadius"_a = plinthRadius,
                       "plinthHeight"_a = plinthHeight, "plinthY"_a = -0.5f * plinthHeight,
                       "floorY"_a = -plinthHeight, "floorSize"_a = 60 * unit, "scale"_a = scale);
}

}  // namespace vitrine
