// SPDX-License-Identifier: MIT
#include "pack/pack_light.hpp"

#include <cmath>

namespace vitrine {

static_assert(static_cast<int>(LightType::kSpot) == VITRINE_LIGHT_SPOT);
static_assert(static_cast<int>(LightType::kRect) == VITRINE_LIGHT_RECT);

PackedLight packLight(const Light& light) {
    const bool rect = light.type == LightType::kRect, sun = light.type == LightType::kSun;
    const glm::vec3 axis = travelOf(light);
    glm::vec3 edgeX(0), edgeY(0);
    if (rect) {
        // Its width lies level.
        const glm::vec3 up = std::abs(axis.y) > 0.999f ? glm::vec3(0, 0, 1) : glm::vec3(0, 1, 0);
        const glm::vec3 right = glm::normalize(glm::cross(axis, up));
        edgeX = 0.5f * light.size.x * right;
        edgeY = 0.5f * light.size.y * glm::cross(right, axis);
    }
    // By the half angle: one minus a cosine near one has few digits.
    const double half = std::sin(glm::radians(static_cast<double>(light.radius)) / 2);
    const auto narrowness = static_cast<float>(sun ? 2 * half * half : 0);
    const bool seen = light.type == LightType::kSphere || rect;
    PackedLight packed;
    packed.texels = {glm::vec4(light.at, static_cast<float>(light.type)),
                     glm::vec4(light.color.rgb * light.intensity, light.range),
                     glm::vec4(axis, sun ? 0 : light.radius),
                     glm::vec4(std::cos(glm::radians(light.innerAngle)),
                               std::cos(glm::radians(light.outerAngle)), narrowness, seen),
                     glm::vec4(edgeX, 0),
                     glm::vec4(edgeY, 0)};
    packed.sized = rect || light.radius > 0;
    return packed;
}

Light sunOfSky(const SkyAsset::Sun& sun, const Environment& environment) {
    const float up = glm::radians(environment.sunElevation);
    const float around = glm::radians(environment.sunAzimuth + environment.rotation);
    Light light;
    light.type = LightType::kSun;
    light.direction =
        -glm::vec3(std::cos(up) * std::sin(around), std::sin(up), std::cos(up) * std::cos(around));
    light.color.rgb = sun.irradiance;
    light.intensity = environment.intensity;
    light.radius = sun.radius;
    return light;
}

}  // namespace vitrine
