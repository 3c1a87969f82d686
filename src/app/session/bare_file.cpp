// SPDX-License-Identifier: MIT
#include "app/session/bare_file.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/file.hpp"
#include "base/text.hpp"
#include "mesh/obj.hpp"
#include "sdf/snippet.hpp"

namespace vitrine {
namespace {

constexpr uint64_t kMaxSnippetBytes = 64u << 10;

/// The object is scaled to a radius of 1, whatever its unit is, and its box stands on the plinth's
/// top at y = 0.
constexpr const char* kScene = R"([scene]
title = '{name}'
[render]
bounces = 3
[[camera]]
eye = [{eyeX}, {eyeY}, {eyeZ}]
target = [0, {targetY}, 0]
focal_length = 50
[environment]
zenith = [0.42, 0.52, 0.70]
horizon = [0.90, 0.88, 0.86]
ground = [0.20, 0.19, 0.18]
[[light]]
name = "key"
type = "sun"
direction = [-0.55, -0.9, -0.6]
color = [1.0, 0.95, 0.88]
intensity = 3
[material.body]
base_color = [0.72, 0.70, 0.67]
roughness = 0.35
[material.plinth]
base_color = [0.05, 0.052, 0.056]
roughness = 0.08
[material.floor]
base_color = [0.36, 0.35, 0.34]
roughness = 0.6
[shape.object]
{kind} = '{name}'
[shape.plinth]
cylinder = {{ radius = {plinthRadius}, height = {plinthHeight} }}
[shape.floor]
plane = {{ size = [{floorSize}, 0, {floorSize}] }}
[[node]]
name = "object"
shape = "object"
material = "body"
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
    return endsWith(file.string(), ".obj") || endsWith(file.string(), ".sdf.glsl");
}

std::optional<std::string> sceneAround(const std::filesystem::path& file, FieldProber& prober,
                                       Diagnostics& diagnostics) {
    const std::string name = file.filename().string();
    if (name.find_first_of("'\n\r") != std::string::npos)
        throw InputError({file.string()}, "the file's name has a quote or a line end in it");
    const std::optional<Aabb> box = boundsOf(file, prober, diagnostics);
    if (!box) return {};
    // Half of a nanometre or a million kilometres still make a picture.
    const float scale = 1 / std::clamp(0.5f * glm::length(box->extent()), 2e-9f, 1e18f);
    const glm::vec3 size = box->extent() * scale;
    const glm::vec3 centre = box->centre() * scale;
    const float plinthRadius = 1.12f * 0.5f * std::hypot(size.x, size.z) + 0.05f;
    const float plinthHeight = 0.35f;
    const glm::vec3 toEye = glm::normalize(glm::vec3(0.62f, 0.42f, 1.0f)) * 4.4f;
    using namespace fmt::literals;
    return fmt::format(kScene, "name"_a = name, "kind"_a = endsWith(name, ".obj") ? "mesh" : "sdf",
                       "eyeX"_a = toEye.x, "eyeY"_a = toEye.y + 0.5f * size.y, "eyeZ"_a = toEye.z,
                       "targetY"_a = 0.46f * size.y, "x"_a = -centre.x, "y"_a = -box->min.y * scale,
                       "z"_a = -centre.z, "plinthRadius"_a = plinthRadius,
                       "plinthHeight"_a = plinthHeight, "plinthY"_a = -0.5f * plinthHeight,
                       "floorY"_a = -plinthHeight, "floorSize"_a = 60, "scale"_a = scale);
}

}  // namespace vitrine
