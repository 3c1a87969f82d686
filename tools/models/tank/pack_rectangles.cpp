// SPDX-License-Identifier: MIT
#include "models/tank/pack_rectangles.hpp"

#include <algorithm>

namespace vitrine::tank {
namespace {

/// A level stretch of the skyline, up to the next one's x.
struct Step {
    double x, y;
};

class Skyline {
  public:
    explicit Skyline(double side) : side_(side) {}

    /// Where a box of this size is lowest, then leftmost.
    [[nodiscard]] std::optional<Vec2> find(const Vec2& size) const {
        std::optional<Vec2> best;
        for (size_t i = 0; i < steps_.size(); ++i) {
            const double x = steps_[i].x;
            if (x + size.x > side_) break;
            double y = 0.0;
            for (size_t k = i; k < steps_.size() && steps_[k].x < x + size.x; ++k)
                y = std::max(y, steps_[k].y);
            if (y + size.y <= side_ && (!best || y < best->y)) best = Vec2(x, y);
        }
        return best;
    }
    void put(const Vec2& at, const Vec2& size) {
        const double end = at.x + size.x;
        std::vector<Step> next;
        double under = 0.0;  // height of the last step that begins before the box ends
        for (const Step& s : steps_) {
            if (s.x < end) under = s.y;
            if (s.x < at.x) next.push_back(s);
        }
        next.push_back({at.x, at.y + size.y});
        const auto after =
            std::ranges::find_if(steps_, [end](const Step& s) { return s.x >= end; });
        if (end < side_ && (after == steps_.end() || after->x > end)) next.push_back({end, under});
        next.insert(next.end(), after, steps_.end());
        steps_ = std::move(next);
    }

  private:
    double side_;
    std::vector<Step> steps_{{0.0, 0.0}};
};

}  // namespace

std::optional<std::vector<PackedRectangle>> packRectangles(const std::vector<Vec2>& sizes,
                                                           int side) {
    std::vector<size_t> order(sizes.size());
    for (size_t i = 0; i < order.size(); ++i) order[i] = i;
    const auto longest = [&sizes](size_t i) { return std::max(sizes[i].x, sizes[i].y); };
    std::ranges::stable_sort(order, std::greater{}, longest);
    std::vector<PackedRectangle> result(sizes.size());
    Skyline skyline(side);
    for (const size_t i : order) {
        const Vec2 flat = sizes[i], upright(flat.y, flat.x);
        const std::optional<Vec2> a = skyline.find(flat), b = skyline.find(upright);
        if (!a && !b) return {};
        const bool onSide = !a || (b && b->y + upright.y < a->y + flat.y);
        result[i] = {onSide ? *b : *a, onSide};
        skyline.put(result[i].at, onSide ? upright : flat);
    }
    return result;
}

}  // namespace vitrine::tank
