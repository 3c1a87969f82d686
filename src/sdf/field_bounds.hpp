// SPDX-License-Identifier: MIT
// Bounds for a field whose author wrote none.
#pragma once

#include "sdf/field_samples.hpp"

namespace vitrine {

struct FoundBounds {
    enum class Outcome {
        kFound,
        kNothing,   ///< nowhere zero or negative
        kInfinite,  ///< it is, as far out as anybody looks
    };
    Outcome outcome = Outcome::kNothing;
    Aabb box;
};

/// Half of the edge of the largest cube around the origin that is searched. Surfaces beyond half of
/// it count as infinite.
inline constexpr float kFarthestBounds = 1024;

/// Looks for the surface in cubes around the origin, each twice as large as the one before;
/// Newton's method leads from their samples to the surface, so that small things far away are found
/// where the field is anything like a distance. Then presses outwards from the outermost points
/// found, and adds a margin. `domain.box` is not read.
FoundBounds findBounds(const FieldDomain& domain, const FieldEvaluator& evaluate);

}  // namespace vitrine
