// SPDX-License-Identifier: MIT
#include "pack/albedo_table.hpp"

#include <algorithm>
#include <cmath>

#include "shared/limits.glsl"

namespace vitrine {
namespace {

constexpr int kSamples = 16;  // along each axis
constexpr float kLeastCosine = 0.01f;

/// Both parts of a GGX lobe, by sampling the normals that the viewer sees (Heitz 2018): what is
/// averaged is the share of light that later microfacets do not block.
glm::vec2 ggxAlbedo(float nDotV, float alpha) {
    if (alpha < 1e-4f) {
        const float power = std::pow(1 - nDotV, 5.0f);
        return {1 - power, power};
    }
    const glm::vec3 v(std::sqrt(1 - nDotV * nDotV), 0, nDotV);
    const glm::vec3 stretched = glm::normalize(glm::vec3(alpha * v.x, 0, v.z));
    const glm::vec3 across(0, 1, 0), up = glm::cross(stretched, across);
    const float a2 = alpha * alpha;
    const float maskedV = std::sqrt(nDotV * nDotV * (1 - a2) + a2);
    glm::dvec2 sum(0);
    for (int i = 0; i < kSamples; ++i)
        for (int k = 0; k < kSamples; ++k) {
            const float r = std::sqrt((static_cast<float>(i) + 0.5f) / kSamples);
            const float angle = 2 * kPi * (static_cast<float>(k) + 0.5f) / kSamples;
            const float p1 = r * std::cos(angle);
            const float s = 0.5f * (1 + stretched.z);
            const float p2 =
                (1 - s) * std::sqrt(std::max(0.0f, 1 - p1 * p1)) + s * r * std::sin(angle);
            const float p3 = std::sqrt(std::max(0.0f, 1 - p1 * p1 - p2 * p2));
            const glm::vec3 m = p1 * across + p2 * up + p3 * stretched;
            const glm::vec3 h =
                glm::normalize(glm::vec3(alpha * m.x, alpha * m.y, std::max(1e-6f, m.z)));
            const float vDotH = glm::dot(v, h);
            const float nDotL = 2 * vDotH * h.z - nDotV;
            if (nDotL <= 0) continue;
            const float maskedL = std::sqrt(nDotL * nDotL * (1 - a2) + a2);
            const float seen = nDotL * (nDotV + maskedV) / (nDotV * maskedL + nDotL * maskedV);
            const float power = std::pow(std::max(0.0f, 1 - vDotH), 5.0f);
            sum += glm::dvec2(seen * (1 - power), seen * power);
        }
    return glm::vec2(sum / static_cast<double>(kSamples * kSamples));
}

/// Over the hemisphere, evenly in the polar angle: the lobe has its weight at grazing directions.
float sheenAlbedo(float nDotV, float alpha) {
    const glm::vec3 v(std::sqrt(1 - nDotV * nDotV), 0, nDotV);
    double sum = 0;
    for (int i = 0; i < kSamples; ++i)
        for (int k = 0; k < kSamples; ++k) {
            const float polar = 0.5f * kPi * (static_cast<float>(i) + 0.5f) / kSamples;
            const float angle = kPi * (static_cast<float>(k) + 0.5f) / kSamples;
            const glm::vec3 l(std::sin(polar) * std::cos(angle), std::sin(polar) * std::sin(angle),
                              std::cos(polar));
            const glm::vec3 h = glm::normalize(l + v);
            const float sine2 = std::max(0.0f, 1 - h.z * h.z);
            const float distribution = (2 + 1 / alpha) * std::pow(sine2, 0.5f / alpha) / (2 * kPi);
            sum += distribution / (4 * (l.z + nDotV - l.z * nDotV)) * l.z * std::sin(polar);
        }
    return static_cast<float>(sum) * (0.5f * kPi / kSamples) * (2 * kPi / kSamples);
}

std::vector<glm::vec4> integrate() {
    std::vector<glm::vec4> table;
    for (int row = 0; row < VITRINE_ALBEDO_ROUGHNESSES; ++row)
        for (int column = 0; column < VITRINE_ALBEDO_COSINES; ++column) {
            const float roughness = static_cast<float>(row) / (VITRINE_ALBEDO_ROUGHNESSES - 1);
            const float cosine =
                std::max(static_cast<float>(column) / (VITRINE_ALBEDO_COSINES - 1), kLeastCosine);
            const float alpha = roughness * roughness;
            const glm::vec2 ggx = ggxAlbedo(cosine, alpha);
            table.emplace_back(ggx, sheenAlbedo(cosine, std::max(alpha, 0.01f)), 0.0f);
        }
    return table;
}

}  // namespace

const std::vector<glm::vec4>& albedoTable() {
    static const std::vector<glm::vec4> table = integrate();
    return table;
}

}  // namespace vitrine
