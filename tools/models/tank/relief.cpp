// SPDX-License-Identifier: MIT
#include "models/tank/relief.hpp"

#include <algorithm>
#include <cmath>

#include "models/tank/noise.hpp"

namespace vitrine::tank {

MarkField::MarkField(const Marks& marks) : marks_(marks.marks) {
    for (uint32_t i = 0; i < marks_.size(); ++i) grid_.add(i, marks_[i].a, marks_[i].b);
}

Marked MarkField::at(const Vec3& p) const {
    // Heights are exaggerated about twice: a texel is as long as half a bead is wide.
    constexpr double kWeldHeight = 0.006, kGrooveDepth = 0.007, kRivetHeight = 0.008;
    constexpr double kRipple = 0.034;  // from scale to scale along a bead, metres
    Marked result;
    for (const uint32_t i : grid_.near(p)) {
        const Mark& mark = marks_[i];
        const Vec3 nearest = glm::mix(mark.a, mark.b, nearestOnSegment(p, mark.a, mark.b));
        const double far = glm::distance(p, nearest) / mark.radius;
        if (far >= 1.6) continue;
        const double dome = std::sqrt(std::max(0.0, 1.0 - far * far));
        if (mark.kind == MarkKind::kWeld) {
            // Scales along the bead, from any coordinate that grows along it.
            const double along = (nearest.x + nearest.y + nearest.z) / kRipple;
            const double scale =
                0.75 + 0.25 * std::abs(std::sin(0.5 * kTau * along + noise(p * 40.0)));
            result.weld = std::max(result.weld, 1.0 - glm::smoothstep(0.6, 1.6, far));
            result.height = std::max(result.height, kWeldHeight * dome * scale);
        } else if (mark.kind == MarkKind::kGroove) {
            const double cut = 1.0 - glm::smoothstep(0.2, 1.4, far);
            result.groove = std::max(result.groove, cut);
            result.height = std::min(result.height, -kGrooveDepth * cut);
        } else {
            result.rivet = std::max(result.rivet, dome);
            result.height = std::max(result.height, kRivetHeight * dome);
        }
    }
    return result;
}

double grain(Material material, bool cast, const Vec3& p) {
    switch (material) {
        case Material::kPaint:
            return cast ? 0.0042 * fractal(p * 22.0, 3) + 0.0010 * noise(p * 110.0)
                        : 0.0022 * fractal(p * 5.0, 2) + 0.0003 * noise(p * 90.0);
        case Material::kTrack:
            return 0.0020 * fractal(p * 60.0, 3);
        case Material::kRubber:
            return 0.0010 * fractal(p * 80.0, 2);
        case Material::kSteel:
            return 0.0006 * fractal(p * 70.0, 2);
        case Material::kWood:
            return 0.0012 * noise(p * Vec3(8.0, 160.0, 160.0));
        case Material::kCanvas:
            return 0.0100 * fractal(p * Vec3(9.0, 16.0, 6.0), 3) + 0.0010 * noise(p * 150.0);
        default:
            return 0.0;
    }
}

}  // namespace vitrine::tank
