// SPDX-License-Identifier: MIT
// How steep a distance field is. Sphere tracing (Hart 1996) never passes through a surface if the
// steps are divided by the field's Lipschitz constant; authors get that constant wrong.
#pragma once

#include "sdf/field_report.hpp"

namespace vitrine {

/// Samples the domain: evenly first, then, in rounds, closer and closer around the steepest places
/// of each scale and around the surface, because creases are narrow. About 70,000 samples. What is
/// found is a lower bound of the constant; steeper places smaller than some thousandths of the
/// domain may hide. Fills all of the report but what concerns bounds that were found or suggested.
FieldReport measureSlope(const FieldDomain& domain, const FieldEvaluator& evaluate);

}  // namespace vitrine
