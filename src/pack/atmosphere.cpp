// SPDX-License-Identifier: MIT
#include "pack/atmosphere.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "pack/sky_map.hpp"

namespace vitrine {
namespace {

using glm::vec3;

// Kilometres.
constexpr float kGround = 6360, kTop = 6460;
constexpr float kEye = kGround + 0.02f;
const vec3 kRayleigh{5.802e-3f, 13.558e-3f, 33.1e-3f};  // scattering at the ground, per km
const vec3 kOzone{0.650e-3f, 1.881e-3f, 0.085e-3f};     // absorption at its densest
constexpr float kMieScattering = 3.996e-3f, kMieAbsorption = 0.44e-3f;  // at turbidity 2
constexpr float kMieForward = 0.8f;                                     // asymmetry of the phase

constexpr int kSkyWidth = 512, kSkyHeight = 256;
constexpr int kSkySteps = 28;

struct Medium {
    vec3 rayleigh;
    float mie;
    vec3 extinction;
};

/// Where a ray at radius r, with cosine mu from the zenith, leaves the sphere of radius `sphere`
/// (the farther crossing); negative if it does not meet it.
float farCrossing(float r, float mu, float sphere) {
    const float inside = r * r * (mu * mu - 1) + sphere * sphere;
    return inside < 0 ? -1 : -r * mu + std::sqrt(inside);
}
/// Where it meets the ground; negative if it does not.
float groundCrossing(float r, float mu) {
    const float inside = r * r * (mu * mu - 1) + kGround * kGround;
    return mu >= 0 || inside < 0 ? -1 : std::max(0.0f, -r * mu - std::sqrt(inside));
}

float hazePhase(float cosine) {
    constexpr float g = kMieForward;  // Henyey and Greenstein 1941
    return (1 - g * g) / (4 * kPi * std::pow(1 + g * g - 2 * g * cosine, 1.5f));
}
float airPhase(float cosine) {
    return 3 / (16 * kPi) * (1 + cosine * cosine);
}

/// A table over the cosine of the sun (or the ray) from the zenith and the height.
class Table {
  public:
    Table(int cosines, int heights)
        : cosines_(cosines), heights_(heights), values_(static_cast<size_t>(cosines) * heights) {}

    template <class F>
    void fill(F&& value) {
        tbb::parallel_for(0, heights_, [&](int row) {
            for (int i = 0; i < cosines_; ++i) {
                // More entries where the light changes, around the horizon.
                const float x = 2 * (static_cast<float>(i) / static_cast<float>(cosines_ - 1)) - 1;
                const float h = static_cast<float>(row) / static_cast<float>(heights_ - 1);
                values_[static_cast<size_t>(row) * cosines_ + i] =
                    value(kGround + (kTop - kGround) * h * h, x * std::abs(x));
            }
        });
    }
    [[nodiscard]] vec3 at(float r, float mu) const {
        const float x = 0.5f + 0.5f * std::copysign(std::sqrt(std::abs(mu)), mu);
        const float y = std::sqrt(std::clamp((r - kGround) / (kTop - kGround), 0.0f, 1.0f));
        const float fx = std::clamp(x, 0.0f, 1.0f) * static_cast<float>(cosines_ - 1);
        const float fy = y * static_cast<float>(heights_ - 1);
        const int ix = std::min(static_cast<int>(fx), cosines_ - 2);
        const int iy = std::min(static_cast<int>(fy), heights_ - 2);
        const auto v = [&](int dx, int dy) {
            return values_[static_cast<size_t>(iy + dy) * cosines_ + ix + dx];
        };
        const float px = fx - static_cast<float>(ix), py = fy - static_cast<float>(iy);
        return glm::mix(glm::mix(v(0, 0), v(1, 0), px), glm::mix(v(0, 1), v(1, 1), px), py);
    }

  private:
    int cosines_, heights_;
    std::vector<vec3> values_;
};

class Air {
  public:
    Air(float turbidity, const vec3& ground)
        : haze_(turbidity - 1), ground_(ground), toSun_(256, 64), further_(32, 16) {
        toSun_.fill([&](float r, float mu) { return integrateTransmittance(r, mu); });
        further_.fill([&](float r, float mu) { return integrateFurther(r, mu); });
    }

    [[nodiscard]] Medium medium(float r) const {
        const float height = std::max(0.0f, r - kGround);
        const float haze = haze_ * std::exp(-height / 1.2f);
        const vec3 rayleigh = kRayleigh * std::exp(-height / 8);
        const float ozone = std::max(0.0f, 1 - std::abs(height - 25) / 15);
        return {rayleigh, kMieScattering * haze,
                rayleigh + (kMieScattering + kMieAbsorption) * haze + kOzone * ozone};
    }

    /// What of the sun's light arrives; nothing behind the ground.
    [[nodiscard]] vec3 sunlight(float r, float mu) const { return toSun_.at(r, mu); }

    /// Radiance of a ray from the radius r for a sun of unit irradiance. `mu` and `sunMu` are
    /// cosines from the zenith, `cosine` is that between ray and sun.
    struct Seen {
        vec3 radiance{0}, transmittance{1};
        bool ground = false;
    };
    [[nodiscard]] Seen look(float r, float mu, float sunMu, float cosine, int steps) const {
        Seen seen;
        const float down = groundCrossing(r, mu);
        seen.ground = down >= 0;
        const float end = seen.ground ? down : farCrossing(r, mu, kTop);
        const float air = airPhase(cosine), haze = hazePhase(cosine);
        float before = 0;
        for (int i = 0; i < steps; ++i) {
            // Shorter steps near the eye, where the air is dense.
            const float s = static_cast<float>(i + 1) / static_cast<float>(steps);
            const float t = end * s * s;
            const float middle = 0.5f * (before + t), length = t - before;
            before = t;
            const float at = std::sqrt(r * r + middle * middle + 2 * r * mu * middle);
            const float sunThere = std::clamp((r * sunMu + middle * cosine) / at, -1.0f, 1.0f);
            const Medium m = medium(at);
            const vec3 scattered =
                (m.rayleigh * air + vec3(m.mie * haze)) * sunlight(at, sunThere) +
                (m.rayleigh + m.mie) * further_.at(at, sunThere);
            // The integral over the step, the medium being constant along it.
            const vec3 passed = glm::exp(-m.extinction * length);
            seen.radiance += seen.transmittance * scattered * (1.0f - passed) /
                             glm::max(m.extinction, vec3(1e-9f));
            seen.transmittance *= passed;
        }
        return seen;
    }

  private:
    [[nodiscard]] vec3 integrateTransmittance(float r, float mu) const {
        if (groundCrossing(r, mu) > 0 || (r <= kGround && mu < 0)) return vec3(0);
        constexpr int kSteps = 64;
        const float end = farCrossing(r, mu, kTop);
        vec3 depth(0);
        float before = 0;
        for (int i = 0; i < kSteps; ++i) {
            const float s = static_cast<float>(i + 1) / kSteps;
            const float t = end * s * s, middle = 0.5f * (before + t);
            depth += medium(std::sqrt(r * r + middle * middle + 2 * r * mu * middle)).extinction *
                     (t - before);
            before = t;
        }
        return glm::exp(-depth);
    }

    /// Light that has been scattered twice or more, as if it came evenly from all sides, per unit
    /// of irradiance: second order by sampling, the rest as a geometric series.
    [[nodiscard]] vec3 integrateFurther(float r, float sunMu) const {
        constexpr int kDirections = 64, kSteps = 16;
        const float sunSine = std::sqrt(std::max(0.0f, 1 - sunMu * sunMu));
        vec3 second(0), passedOn(0);
        for (int i = 0; i < kDirections; ++i) {
            const float mu = 1 - (2 * static_cast<float>(i) + 1) / kDirections;
            const float angle = 2.39996323f * static_cast<float>(i);  // the golden angle
            const float cosine = mu * sunMu + std::sqrt(1 - mu * mu) * sunSine * std::cos(angle);
            const float down = groundCrossing(r, mu);
            const float end = down >= 0 ? down : std::max(0.0f, farCrossing(r, mu, kTop));
            vec3 transmittance(1);
            for (int k = 0; k < kSteps; ++k) {
                const float length = end / kSteps, t = length * (static_cast<float>(k) + 0.5f);
                const float at = std::sqrt(r * r + t * t + 2 * r * mu * t);
                const float sunThere = std::clamp((r * sunMu + t * cosine) / at, -1.0f, 1.0f);
                const Medium m = medium(at);
                const vec3 scattering = m.rayleigh + m.mie;
                const vec3 passed = glm::exp(-m.extinction * length);
                const vec3 part = transmittance * scattering * (1.0f - passed) /
                                  glm::max(m.extinction, vec3(1e-9f));
                second += part * sunlight(at, sunThere) / (4 * kPi);
                passedOn += part;
                transmittance *= passed;
            }
            if (down < 0) continue;
            const float at = kGround;
            const float sunThere = std::clamp((r * sunMu + end * cosine) / at, -1.0f, 1.0f);
            second += transmittance * ground_ / kPi * std::max(0.0f, sunThere) *
                      sunlight(at + 0.001f, sunThere);
        }
        second /= static_cast<float>(kDirections);
        passedOn /= static_cast<float>(kDirections);
        return second / (1.0f - passedOn);
    }

    float haze_;
    vec3 ground_;
    Table toSun_, further_;
};

/// The part of the sun's disc that is above the horizon.
float partRisen(float elevationDegrees) {
    return glm::smoothstep(-kSunRadiusDegrees, kSunRadiusDegrees, elevationDegrees);
}

}  // namespace

Atmosphere makeAtmosphere(const AtmosphereRequest& request) {
    const Air air(request.turbidity, request.ground);
    const float elevation = glm::radians(request.sunElevation);
    const vec3 toSun(std::cos(elevation), std::sin(elevation), 0);
    Atmosphere out;
    // Just above the horizon at the lowest: of a setting sun only a part is seen.
    out.sunIrradiance =
        air.sunlight(kEye, std::max(toSun.y, 0.0005f)) * partRisen(request.sunElevation);

    // The sky is the same on both sides of the sun.
    out.sky = ImageRgba32f(kSkyWidth, kSkyHeight);
    const auto put = [&](int x, int y, const vec3& radiance) {
        for (const int column : {x, kSkyWidth - 1 - x}) {
            const auto pixel = out.sky.at(column, y);
            for (int c = 0; c < 3; ++c) pixel[static_cast<size_t>(c)] = radiance[c];
            pixel[3] = 1;
        }
    };
    std::vector<vec3> transmittances(static_cast<size_t>(kSkyWidth / 2) * kSkyHeight, vec3(0));
    tbb::parallel_for(0, kSkyHeight, [&](int y) {
        for (int x = 0; x < kSkyWidth / 2; ++x) {
            const vec3 d = skyDirection((static_cast<float>(x) + 0.5f) / kSkyWidth,
                                        (static_cast<float>(y) + 0.5f) / kSkyHeight);
            const Air::Seen seen = air.look(kEye, d.y, toSun.y, glm::dot(d, toSun), kSkySteps);
            put(x, y, seen.radiance);
            if (seen.ground)
                transmittances[static_cast<size_t>(y) * (kSkyWidth / 2) + x] = seen.transmittance;
        }
    });
    // The ground in the light of all that stands above it.
    vec3 fromSky(0);
    float scalar = 0;
    for (int y = 0; y < kSkyHeight / 2; ++y)
        for (int x = 0; x < kSkyWidth; ++x) {
            const float up = kPi * (0.5f - (static_cast<float>(y) + 0.5f) / kSkyHeight);
            const float angle = std::cos(up) * (kPi / kSkyHeight) * (2 * kPi / kSkyWidth);
            const auto p = out.sky.at(x, y);
            const vec3 radiance(p[0], p[1], p[2]);
            fromSky += radiance * angle * std::sin(up);
            scalar += luminance(radiance) * angle * std::sin(up);
        }
    const vec3 lit = request.ground / kPi * (fromSky + out.sunIrradiance * std::max(0.0f, toSun.y));
    for (int y = kSkyHeight / 2; y < kSkyHeight; ++y)
        for (int x = 0; x < kSkyWidth / 2; ++x) {
            const auto p = out.sky.at(x, y);
            put(x, y,
                vec3(p[0], p[1], p[2]) +
                    transmittances[static_cast<size_t>(y) * (kSkyWidth / 2) + x] * lit);
        }

    // Half of the sun, for things turn to it at all angles, and the sky; the number is that of a
    // high sun in clear air. The eye makes up for three quarters of what is missing, in stops;
    // nights stay dark.
    constexpr float kNoon = 0.53f, kAdaptation = 0.75f, kMost = 400;
    const float light = 0.5f * luminance(out.sunIrradiance) + scalar;
    out.adaptation = std::clamp(std::pow(kNoon / std::max(light, 1e-6f), kAdaptation), 1.0f, kMost);
    const float scale = kSunIrradiance * out.adaptation;
    out.sunIrradiance *= scale;
    for (size_t i = 0; i < out.sky.pixels.size(); ++i)
        if (i % 4 != 3) out.sky.pixels[i] *= scale;
    return out;
}

}  // namespace vitrine
