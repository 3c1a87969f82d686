// SPDX-License-Identifier: MIT
#include "sdf/field_samples.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace vitrine {
namespace {

/// Long enough for what returns after some seconds, as most animations do.
constexpr float kDuration = 10;

float rounded(const Parameter& parameter, float value) {
    if (parameter.type == ParameterType::kInt) return std::round(value);
    if (parameter.type == ParameterType::kBool) return value < 0.5f ? 0.0f : 1.0f;
    return value;
}

template <class Choose>
glm::vec4 chosen(const Parameter& parameter, const glm::vec4& otherwise, Choose choose) {
    glm::vec4 value = otherwise;
    for (int c = 0; c < componentCount(parameter.type); ++c)
        value[c] = rounded(parameter, choose(c));
    return value;
}

FieldSetting spreadSetting(const FieldDomain& domain, uint32_t index) {
    const uint32_t round = index / 8;
    FieldSetting setting = domain.settings[round % domain.settings.size()];
    if (domain.parameters.empty()) return setting;
    const uint32_t kind = scrambled(index) % 8;
    const size_t alone = scrambled(index ^ 0xa511e9b3u) % domain.parameters.size();
    for (size_t i = 0; i < domain.parameters.size(); ++i) {
        const Parameter& p = domain.parameters[i];
        const bool corner = kind == 6 || (kind == 7 && i == alone);
        if (kind < 3 || (kind == 7 && !corner)) continue;
        setting[i] = chosen(p, setting[i], [&](int c) {
            const uint32_t bits =
                scrambled(index * 0x9e3779b9u + static_cast<uint32_t>(i * 4 + c) + 1);
            const float t = corner ? static_cast<float>(bits >> 31) : unitFloat(bits);
            return glm::mix(p.minimum[c], p.maximum[c], t);
        });
    }
    return setting;
}

}  // namespace

uint32_t scrambled(uint32_t x) {
    x ^= x >> 16;
    x *= 0x7feb352du;
    x ^= x >> 15;
    x *= 0x846ca68bu;
    x ^= x >> 16;
    return x;
}

float unitFloat(uint32_t bits) {
    return static_cast<float>(bits >> 8) * (1.0f / 16777216.0f);
}

void FieldSamples::add(const Place& place, const FieldSetting& setting) {
    settingSize = setting.size();
    places.push_back(place);
    parameters.insert(parameters.end(), setting.begin(), setting.end());
}

void FieldSamples::add(const FieldSamples& other, size_t i) {
    add(other.places[i], other.setting(i));
}

void FieldSamples::append(const FieldSamples& other) {
    settingSize = other.settingSize;
    places.insert(places.end(), other.places.begin(), other.places.end());
    parameters.insert(parameters.end(), other.parameters.begin(), other.parameters.end());
}

FieldSetting FieldSamples::setting(size_t i) const {
    const auto first = parameters.begin() + static_cast<std::ptrdiff_t>(i * settingSize);
    return {first, first + static_cast<std::ptrdiff_t>(settingSize)};
}

FieldDomain domainOf(const Snippet& snippet, const Aabb& box,
                     const std::vector<FieldSetting>& inUse) {
    FieldDomain domain;
    domain.box = box;
    domain.parameters = snippet.parameters;
    domain.duration = snippet.usesTime ? kDuration : 0;
    FieldSetting defaults;
    for (const Parameter& p : snippet.parameters) defaults.push_back(p.defaultValue);
    domain.settings.push_back(std::move(defaults));
    for (const FieldSetting& setting : inUse)
        if (std::find(domain.settings.begin(), domain.settings.end(), setting) ==
            domain.settings.end())
            domain.settings.push_back(setting);
    return domain;
}

void addSpread(const FieldDomain& domain, uint32_t index, float step, FieldSamples& samples) {
    // Powers of 1 / g, where g^5 = g + 1, as fractions of 2^32: exact on every machine.
    static constexpr std::array<uint32_t, 4> kSteps = {3679390609u, 3152041523u, 2700274806u,
                                                       2313257605u};
    std::array<float, 4> unit;
    for (size_t c = 0; c < 4; ++c) unit[c] = unitFloat(0x80000000u + index * kSteps[c]);
    FieldSamples::Place place;
    place.point = domain.box.min + domain.box.extent() * glm::vec3(unit[0], unit[1], unit[2]);
    place.time = domain.duration * unit[3];
    place.step = step;
    samples.add(place, spreadSetting(domain, index));
}

void addNear(const FieldDomain& domain, const FieldSamples& from, size_t i, float reach,
             uint32_t index, float step, FieldSamples& samples) {
    uint32_t state = scrambled(index + 0x68bc21ebu);
    const auto next = [&] { return state = scrambled(state + 0x9e3779b9u); };
    const auto offset = [&] { return reach * (2 * unitFloat(next()) - 1); };
    FieldSamples::Place place = from.places[i];
    const glm::vec3 size = domain.box.extent();
    for (int c = 0; c < 3; ++c)
        place.point[c] =
            std::clamp(place.point[c] + offset() * size[c], domain.box.min[c], domain.box.max[c]);
    place.time = std::clamp(place.time + offset() * domain.duration, 0.0f, domain.duration);
    place.step = step;
    FieldSetting setting = from.setting(i);
    for (size_t k = 0; k < domain.parameters.size(); ++k) {
        if ((next() >> 31) == 0) continue;
        const Parameter& p = domain.parameters[k];
        // A value in use may lie outside of a range that is only a guess.
        setting[k] = chosen(p, setting[k], [&](int c) {
            const float low = std::min(p.minimum[c], setting[k][c]);
            const float high = std::max(p.maximum[c], setting[k][c]);
            return std::clamp(setting[k][c] + offset() * (high - low), low, high);
        });
    }
    samples.add(place, setting);
}

}  // namespace vitrine
