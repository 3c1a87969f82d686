// SPDX-License-Identifier: MIT
// The edges that stand out, where paint wears off first.
#pragma once

#include <vector>

#include "models/tank/segment_grid.hpp"

namespace vitrine::tank {

/// Of one solid. An edge counts if its sides meet at more than 25 degrees and it is meant to be an
/// edge: the flats of a tube that has few sides are not.
class OuterEdges {
  public:
    static constexpr double kReach = 0.030;

    explicit OuterEdges(const Solid& solid);
    /// Metres to the nearest edge, at most kReach.
    [[nodiscard]] double distance(const Vec3& p) const;

  private:
    std::vector<std::array<Vec3, 2>> edges_;
    SegmentGrid grid_{kReach};
};

}  // namespace vitrine::tank
