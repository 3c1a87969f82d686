// SPDX-License-Identifier: MIT
// Polygons to triangles by clipping ears (Meisters 1975), in the polygon's own plane.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/math.hpp"

namespace vitrine {

/// Reused from polygon to polygon, because most are small and there are many.
class Triangulator {
  public:
    /// At most `earTests` point-in-triangle tests in its life; a polygon of n corners takes about
    /// n times the number of its inward corners.
    explicit Triangulator(uint64_t earTests) : budget_(earTests) {}

    /// Appends n - 2 triangles, as indices into `polygon`, that wind as the polygon does. Polygons
    /// that cross themselves or have no plane are cut up somehow; corners in one line may give
    /// triangles without area.
    void triangulate(std::span<const glm::vec3> polygon, std::vector<glm::uvec3>& triangles);

    /// True if the budget ran out; polygons are cut up as fans since then.
    [[nodiscard]] bool exhausted() const { return budget_ == 0; }

  private:
    struct Corner {
        glm::dvec2 at;
        uint32_t previous, next;
        size_t queuedAt;
        bool clipped;
    };

    void project(std::span<const glm::vec3> polygon);
    [[nodiscard]] double turn(uint32_t corner) const;
    [[nodiscard]] bool isEar(uint32_t corner);
    void enqueue(uint32_t corner);
    void clip(uint32_t corner, std::vector<glm::uvec3>& triangles);
    void findInward();

    uint64_t budget_;
    std::vector<Corner> ring_;
    std::vector<uint32_t> inward_, queue_;
};

}  // namespace vitrine
