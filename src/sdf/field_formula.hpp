// SPDX-License-Identifier: MIT
// For tests: a formula that answers as the GPU does (shaders/pass/probe_field.glsl).
#pragma once

#include <cmath>
#include <functional>

#include "sdf/field_samples.hpp"

namespace vitrine::test {

using Formula = std::function<float(const glm::vec3&, float time, const FieldSetting&)>;

inline FieldEvaluator answering(Formula formula) {
    return [formula = std::move(formula)](const FieldSamples& samples) {
        std::vector<FieldValue> values;
        for (size_t i = 0; i < samples.size(); ++i) {
            const auto& place = samples.places[i];
            const FieldSetting setting = samples.setting(i);
            FieldValue v;
            const auto at = [&](const glm::vec3& p) {
                const float d = formula(p, place.time, setting);
                v.bad += std::isfinite(d) ? 0 : 1;
                return d;
            };
            v.distance = at(place.point);
            const float s = place.step / std::sqrt(3.0f);
            for (const glm::vec3 corner : {glm::vec3(1, 1, 1), glm::vec3(1, -1, -1),
                                           glm::vec3(-1, 1, -1), glm::vec3(-1, -1, 1)})
                v.gradient += corner * at(place.point + s * corner) / (4 * s);
            const float size = glm::length(v.gradient);
            const glm::vec3 along = size > 0 ? v.gradient / size : glm::vec3(1, 0, 0);
            const float ahead = at(place.point + place.step * along);
            const float behind = at(place.point - place.step * along);
            v.slope = std::max({std::abs(ahead - behind) / (2 * place.step),
                                std::abs(ahead - v.distance) / place.step,
                                std::abs(behind - v.distance) / place.step});
            values.push_back(v);
        }
        return values;
    };
}

/// One slider.
inline Parameter slider(const std::string& name, float low, float start, float high) {
    Parameter p;
    p.name = name;
    p.minimum.x = low;
    p.defaultValue.x = start;
    p.maximum.x = high;
    p.ranged = true;
    return p;
}

}  // namespace vitrine::test
