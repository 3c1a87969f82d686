// SPDX-License-Identifier: MIT
// Finds the line segments near a point. Each lies in every cell that its surroundings touch, so a
// query looks into one cell.
#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "models/tank/solid.hpp"

namespace vitrine::tank {

class SegmentGrid {
  public:
    /// `reach`: how far from a segment it is still found.
    explicit SegmentGrid(double reach) : reach_(reach) {}

    void add(uint32_t number, const Vec3& a, const Vec3& b) {
        // Long slanted segments would fill whole boxes of cells: cut them up.
        const int pieces = static_cast<int>(glm::distance(a, b) / (4.0 * kCell)) + 1;
        for (int i = 0; i < pieces; ++i) {
            const Vec3 p = glm::mix(a, b, double(i) / pieces);
            const Vec3 q = glm::mix(a, b, double(i + 1) / pieces);
            const Vec3 low = glm::floor((glm::min(p, q) - reach_) / kCell);
            const Vec3 high = glm::floor((glm::max(p, q) + reach_) / kCell);
            for (double z = low.z; z <= high.z; z += 1.0)
                for (double y = low.y; y <= high.y; y += 1.0)
                    for (double x = low.x; x <= high.x; x += 1.0) {
                        std::vector<uint32_t>& cell = cells_[key({x, y, z})];
                        if (cell.empty() || cell.back() != number) cell.push_back(number);
                    }
        }
    }
    [[nodiscard]] std::span<const uint32_t> near(const Vec3& p) const {
        const auto found = cells_.find(key(glm::floor(p / kCell)));
        if (found == cells_.end()) return {};
        return found->second;
    }

  private:
    static constexpr double kCell = 0.04;

    /// 21 bits a coordinate: enough for 40 km.
    static uint64_t key(const Vec3& cell) {
        const auto part = [](double v) {
            return static_cast<uint64_t>(static_cast<int64_t>(v) + (1 << 20)) & 0x1fffffu;
        };
        return part(cell.x) | (part(cell.y) << 21) | (part(cell.z) << 42);
    }

    double reach_;
    std::unordered_map<uint64_t, std::vector<uint32_t>> cells_;
};

/// Where on the segment its nearest point to `p` lies, 0 to 1.
inline double nearestOnSegment(const Vec3& p, const Vec3& a, const Vec3& b) {
    const Vec3 d = b - a;
    const double length2 = glm::dot(d, d);
    return length2 == 0.0 ? 0.0 : glm::clamp(glm::dot(p - a, d) / length2, 0.0, 1.0);
}

}  // namespace vitrine::tank
