// SPDX-License-Identifier: MIT
// What a probe asks of a field and what it gets to hear. The search (field_slope.hpp,
// field_bounds.hpp) does not know who answers: a GPU runs the same text as the renderer
// (frame/pass_probe_field.hpp), a test answers with a formula.
#pragma once

#include <functional>
#include <vector>

#include "base/aabb.hpp"
#include "sdf/snippet.hpp"

namespace vitrine {

/// Values of a snippet's parameters, in its order.
using FieldSetting = std::vector<glm::vec4>;

/// Places in object space, each with a time and a setting of all parameters.
struct FieldSamples {
    struct Place {
        glm::vec3 point{0};
        float time = 0;  ///< s
        /// Half of the length over which the slope is measured, object space.
        float step = 1e-3f;
    };
    std::vector<Place> places;
    /// `settingSize` values a place.
    std::vector<glm::vec4> parameters;
    size_t settingSize = 0;

    void add(const Place& place, const FieldSetting& setting);
    /// Adds sample i of `other`.
    void add(const FieldSamples& other, size_t i);
    void append(const FieldSamples& other);
    [[nodiscard]] FieldSetting setting(size_t i) const;
    [[nodiscard]] size_t size() const { return places.size(); }
};

/// What the field says at one place.
struct FieldValue {
    float distance = 0;
    /// Largest |d(p) - d(q)| / |p - q| of some pairs around the place, `step` away from it, among
    /// them those along the gradient: never more than the field's true Lipschitz constant, but for
    /// rounding.
    float slope = 0;
    glm::vec3 gradient{0};
    /// How many of the values asked for were no finite numbers.
    int bad = 0;
};

/// Answers one value a sample. The same samples get the same answers.
using FieldEvaluator = std::function<std::vector<FieldValue>(const FieldSamples&)>;

/// Where a field is asked: a box, the ranges of its parameters, and a span of time.
struct FieldDomain {
    Aabb box;
    std::vector<Parameter> parameters;
    /// Settings that are in use, looked at more closely than others; the defaults come first.
    std::vector<FieldSetting> settings;
    /// Seconds from 0; 0 for a field that stands still.
    float duration = 0;
};

/// The domain of a snippet over `box`: defaults, then the settings in use.
FieldDomain domainOf(const Snippet& snippet, const Aabb& box,
                     const std::vector<FieldSetting>& inUse);

/// A place of the domain, well spread over space and time (Roberts' R sequence); settings alternate
/// between those in use, the corners of the ranges, and their inside. `step` is left to the caller.
void addSpread(const FieldDomain& domain, uint32_t index, float step, FieldSamples& samples);

/// A place near sample i of `from`: moved by up to `reach`, a part of the domain's size, in space,
/// in time and in every second parameter. `index` picks one of the many.
void addNear(const FieldDomain& domain, const FieldSamples& from, size_t i, float reach,
             uint32_t index, float step, FieldSamples& samples);

/// 32 bits without a pattern (Wellons, hash prospector: lowbias32). The same on every machine.
uint32_t scrambled(uint32_t x);
/// [0, 1)
float unitFloat(uint32_t bits);

}  // namespace vitrine
