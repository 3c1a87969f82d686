// SPDX-License-Identifier: MIT
// A distance field cut through, as on a blackboard: lines of equal distance, the surface bold,
// places where the field is steeper than a distance can be hatched in red.
#pragma once

#include "image/image.hpp"
#include "sdf/field_report.hpp"

namespace vitrine {

/// Cuts through the steepest place if the field is too steep, else through the middle of the
/// bounds, across the axis along which the field changes least there. With a legend.
ImageRgba8 drawFieldSlice(const FieldReport& report, const Snippet& snippet,
                          const FieldEvaluator& evaluate);

}  // namespace vitrine
