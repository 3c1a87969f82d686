// SPDX-License-Identifier: MIT
#include "bvh/nine.hpp"

#include <array>

namespace vitrine {
namespace {

enum class Way { kNone, kBins, kMiddle, kMedian };

/// One of the nine, and what it costs.
struct Cut {
    float cost = std::numeric_limits<float>::infinity();
    Way way = Way::kNone;
    int axis = 0;
    int position = 0;  ///< of bins
    uint32_t left = 0;

    /// Costs of empty sides are infinite or NaN and never win; of equal ones the first stays.
    void offer(const Cut& other) {
        if (other.cost < cost) *this = other;
    }
};

float costOf(const Box4& left, uint32_t leftCount, const Box4& right, uint32_t rightCount) {
    return left.halfArea() * float(leftCount) + right.halfArea() * float(rightCount);
}

/// Centres are doubled, and so is the middle.
glm::vec3 middleOf(const Range& range) {
    return toVec3(range.bounds.box.min + range.bounds.box.max);
}

void offerMiddles(const Range& range, Cut& best) {
    struct Side {
        Box4 box = Box4::empty();
        uint32_t count = 0;
    };
    std::array<std::array<Side, 2>, 3> sides;
    const glm::vec3 middle = middleOf(range);
    for (const Reference& reference : range.span()) {
        const glm::vec3 centre = toVec3(reference.centre());
        for (int axis = 0; axis < 3; ++axis) {
            Side& side = sides[axis][centre[axis] < middle[axis] ? 0 : 1];
            side.box.grow(reference.box());
            ++side.count;
        }
    }
    for (int axis = 0; axis < 3; ++axis) {
        const auto& [left, right] = sides[axis];
        if (left.count == 0 || right.count == 0) continue;
        best.offer({costOf(left.box, left.count, right.box, right.count), Way::kMiddle, axis, 0,
                    left.count});
    }
}

void offerMedians(const Range& range, Cut& best) {
    for (int axis = 0; axis < 3; ++axis) {
        const uint32_t left = orderAtMedian(range.span(), axis);
        const Box4 leftBox = boundsOf(range.span().first(left)).box;
        const Box4 rightBox = boundsOf(range.span().subspan(left)).box;
        best.offer(
            {costOf(leftBox, left, rightBox, range.count - left), Way::kMedian, axis, 0, left});
    }
}

/// Moves the references into the other buffer, left ones first, keeping their order.
template <typename F>
void moveSides(const Range& range, uint32_t left, const F& isLeft) {
    Reference* sides[2] = {range.spare + left, range.spare};
    for (const Reference& reference : range.span()) *sides[isLeft(reference) ? 1 : 0]++ = reference;
}

Children childrenOf(const Range& range, uint32_t left, bool moved) {
    const auto child = [&](uint32_t first, uint32_t size) {
        Range part = range.part(first, size, moved, {});
        part.bounds = boundsOf(part.span());
        return part;
    };
    return {child(0, left), child(left, range.count - left)};
}

}  // namespace

bool NineDivider::operator()(const Range& range, Children& out) const {
    // Few items: all cuts along the three axes are looked at, and the nine are some of them.
    if (range.count <= kExactSize) return Divider(rules_)(range, out);
    return divideLarge(range, out);
}

bool NineDivider::divideLarge(const Range& range, Children& out) const {
    const int binCount = rules_.options.bins;
    const BinMap map(boundsOf(range.span()).centres, binCount);
    Bins bins;
    bins.clear(binCount);
    fillBins(range.span(), map, bins);
    const Split split = bins.best(binCount);
    Cut best;
    if (split.axis >= 0)
        best.offer({split.cost, Way::kBins, split.axis, split.position,
                    bins.count(split.axis, 0, split.position)});
    offerMiddles(range, best);
    offerMedians(range, best);

    if (rules_.isLeaf(range.bounds.box.halfArea(), range.count, best.cost)) return false;
    if (!rules_.accepts(range, best.cost, best.left)) return divideAtMedian(range, out);
    const int axis = best.axis;
    if (best.way == Way::kMedian) {
        orderAtMedian(range.span(), axis);
        out = childrenOf(range, best.left, false);
        return true;
    }
    if (best.way == Way::kBins) {
        moveSides(range, best.left, [&](const Reference& r) {
            int32_t bin[4];
            store(bin, map(r.centre()));
            return bin[axis] < best.position;
        });
    } else {
        const float middle = middleOf(range)[axis];
        moveSides(range, best.left,
                  [&](const Reference& r) { return toVec3(r.centre())[axis] < middle; });
    }
    out = childrenOf(range, best.left, true);
    return true;
}

}  // namespace vitrine
