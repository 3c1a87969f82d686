// SPDX-License-Identifier: MIT
// Cameras, and the lights of KHR_lights_punctual.
#include <fmt/format.h>

#include <cmath>

#include "gltf/read_nodes.hpp"

namespace vitrine {
namespace {

// A camera that sees nothing or all around has no picture plane.
constexpr float kMinFov = 1e-3f;
constexpr float kMaxFov = 3.14f;

GltfCamera readCamera(const JsonValue& camera, size_t number) {
    GltfCamera result;
    if (!camera.exists()) return result;
    result.name = nameOf(camera, "camera", number);
    const std::string type = camera.text("type");
    result.isPerspective = type == "perspective";
    if (type == "orthographic") camera.warning("orthographic cameras are not supported; left out");
    if (!result.isPerspective && type != "orthographic")
        camera.error("type", inQuotes(type) + " is neither perspective nor orthographic");
    if (!result.isPerspective) return result;

    const JsonValue lens = camera.object("perspective");
    for (const char* key : {"yfov", "znear"})
        if (!lens.has(key)) lens.error(fmt::format("'{}' is missing", key));
    result.yfov = lens.number("yfov", 1, kMinFov, kMaxFov);
    result.aspectRatio = lens.number("aspectRatio", 0, 0);
    result.znear = lens.number("znear", 0, 0);
    result.zfar = lens.number("zfar", 0, 0);
    if (lens.has("zfar") && result.zfar <= result.znear) {
        lens.warning("zfar", "not beyond znear; taken as infinite");
        result.zfar = 0;
    }
    return result;
}

GltfLight readLight(const JsonValue& light, size_t number) {
    GltfLight result;
    if (!light.exists()) return result;
    result.name = nameOf(light, "light", number);
    const std::string type = light.text("type");
    if (type == "directional")
        result.type = GltfLightType::kDirectional;
    else if (type == "spot")
        result.type = GltfLightType::kSpot;
    else if (type != "point")
        light.error("type", inQuotes(type) + " is none of directional, point and spot");
    result.color = light.vector<3>("color", result.color, 0);
    result.intensity = light.number("intensity", result.intensity, 0);
    result.range = light.number("range", result.range, 0);
    const JsonValue spot = light.object("spot");
    result.outerConeAngle = spot.number("outerConeAngle", result.outerConeAngle, kMinFov, kPi / 2);
    result.innerConeAngle =
        spot.number("innerConeAngle", result.innerConeAngle, 0, result.outerConeAngle);
    return result;
}

}  // namespace

void readCameras(ReadContext& context) {
    const JsonValue cameras = context.root.array("cameras");
    for (size_t i = 0; i < cameras.size(); ++i)
        context.model.cameras.push_back(readCamera(cameras.objectAt(i), i));
}

void readLights(ReadContext& context) {
    const JsonValue lights =
        context.root.object("extensions").object("KHR_lights_punctual").array("lights");
    for (size_t i = 0; i < lights.size(); ++i)
        context.model.lights.push_back(readLight(lights.objectAt(i), i));
}

}  // namespace vitrine
