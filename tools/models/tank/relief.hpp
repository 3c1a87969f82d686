// SPDX-License-Identifier: MIT
// What is too fine for triangles: weld beads, grooves, rivets, and the grain of each material, as a
// height over the surface.
#pragma once

#include "models/tank/marks.hpp"
#include "models/tank/segment_grid.hpp"

namespace vitrine::tank {

/// How strongly a point is part of a mark, 0 to 1, and the height that marks give it, in metres.
struct Marked {
    double height = 0.0, weld = 0.0, groove = 0.0, rivet = 0.0;
};

class MarkField {
  public:
    explicit MarkField(const Marks& marks);
    /// `p` in the coordinates of the marks.
    [[nodiscard]] Marked at(const Vec3& p) const;

  private:
    static constexpr double kReach = 0.03;
    const std::vector<Mark>& marks_;
    SegmentGrid grid_{kReach};
};

/// The material's own roughness, in metres. Castings are rougher than plates.
double grain(Material material, bool cast, const Vec3& p);

}  // namespace vitrine::tank
