// SPDX-License-Identifier: MIT
// What sampling has found out about a distance field, and how to say it.
#pragma once

#include <optional>
#include <string>

#include "base/error.hpp"
#include "sdf/field_samples.hpp"

namespace vitrine {

/// A slope up to here passes for a true distance: sampling and floats are no better.
inline constexpr float kCleanSlope = 1.02f;

/// A place that stands out, and the number for which it does.
struct FieldPlace {
    glm::vec3 point{0};
    float time = 0;
    FieldSetting setting;
    float value = 0;
};

struct FieldReport {
    /// Of the object, as written by the user or found; no place outside of it was asked.
    Aabb bounds;
    bool boundsFound = false;

    /// Largest slope where the field is positive, which is where rays walk, and where it is not.
    FieldPlace steepest, steepestInside;
    /// The slope has no bound at `steepest`: the field jumps there, by about this much. 0: it does
    /// not. `steepest` then says what was measured over the coarsest steps.
    float jump = 0;
    FieldPlace jumpPlace;
    /// Parts of all evenly spread samples.
    double steepShare = 0, negativeShare = 0;
    size_t samples = 0;
    /// Samples that were no finite numbers, and the first of them.
    size_t notFinite = 0;
    FieldPlace notFinitePlace;
    /// The least distance from zero that was found.
    float nearest = 0;
    /// The field is negative on a face of the bounds: the place, and whether with the settings in
    /// use or only at some end of a slider.
    std::optional<FieldPlace> cut;
    bool cutInUse = false;
    /// Bounds that hold the whole surface, where those given cut it.
    std::optional<Aabb> suggestedBounds;

    /// Slope for which the steps are made: at least 1, a little above the steepest, rounded up so
    /// that two drivers agree.
    float lipschitz = 1;

    [[nodiscard]] bool hasSurface() const;
    [[nodiscard]] bool isSolid() const { return negativeShare == 1; }
};

/// `slope` with a margin, on the grid. At least 1, at most the 1000 that an annotation may say.
float safeLipschitz(float slope);

/// "(0.1, 0.2, 0.3), time 2.5 s, cells 16": what differs from the defaults.
std::string describePlace(const FieldPlace& place, const Snippet& snippet);
/// "bounds[-1, -1, -1,  1, 1, 1]"
std::string describeBounds(const Aabb& box);
/// One line: bounds, slope, parts, as a teacher would read it out.
std::string describeField(const FieldReport& report, const Snippet& snippet);

/// Adds warnings about what makes holes or nothing at all in pictures, placed at the annotation
/// they concern.
void judgeField(const FieldReport& report, const Snippet& snippet, Diagnostics& diagnostics);

}  // namespace vitrine
