// SPDX-License-Identifier: MIT
#include "bvh/plane_cut.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace vitrine {
namespace {

Aabb joined(Aabb a, const Aabb& b) {
    a.grow(b);
    return a;
}

/// Slabs of a box along an axis: what is in each, and how many references begin and end there.
struct SpaceBins {
    struct Bin {
        Aabb box;
        uint32_t begins = 0, ends = 0;
    };

    SpaceBins(const Aabb& box, int alongAxis, int binCount)
        : axis(alongAxis), count(binCount), low(box.min[axis]) {
        const float extent = box.max[axis] - low;
        scale = float(count) / extent;
        for (int i = 0; i <= count; ++i) planes[i] = low + extent * (float(i) / float(count));
    }

    /// The last bin that begins at or below `value`; the linear map is put right by the planes
    /// themselves, so that no rounding puts a part beside its bin.
    [[nodiscard]] int binOf(float value) const {
        int bin = std::clamp(int((value - low) * scale), 0, count - 1);
        while (bin > 0 && value < planes[bin]) --bin;
        while (bin + 1 < count && value >= planes[bin + 1]) ++bin;
        return bin;
    }
    /// The same for an end: what ends at a plane does not reach the next bin.
    [[nodiscard]] int binOfEnd(float value) const {
        const int bin = binOf(value);
        return bin > 0 && value == planes[bin] ? bin - 1 : bin;
    }

    int axis, count;
    float low, scale;
    std::array<float, kMaxBins + 1> planes;
    std::array<Bin, kMaxBins> bins;
};

void offerPlanes(const SpaceBins& space, PlaneCut& best) {
    const auto& bins = space.bins;
    std::array<Aabb, kMaxBins + 1> rightBoxes;
    std::array<size_t, kMaxBins + 1> rightCounts{};
    for (int i = space.count - 1; i > 0; --i) {
        rightBoxes[i] = joined(rightBoxes[i + 1], bins[i].box);
        rightCounts[i] = rightCounts[i + 1] + bins[i].ends;
    }
    Aabb left;
    size_t leftCount = 0;
    for (int i = 1; i < space.count; ++i) {
        left.grow(bins[i - 1].box);
        leftCount += bins[i - 1].begins;
        if (leftCount == 0 || rightCounts[i] == 0) continue;
        const double cost =
            areaOf(left) * double(leftCount) + areaOf(rightBoxes[i]) * double(rightCounts[i]);
        if (!(cost < best.cost)) continue;
        best = {cost, space.axis, space.planes[i], left, rightBoxes[i], leftCount, rightCounts[i]};
    }
}

}  // namespace

double areaOf(const Aabb& box) {
    if (box.empty()) return 0;
    const glm::dvec3 e = glm::dvec3(box.max) - glm::dvec3(box.min);
    return e.x * e.y + e.y * e.z + e.z * e.x;
}

PlaneCutter::PlaneCutter(std::span<const glm::vec3> positions,
                         std::span<const glm::uvec3> triangles, int bins)
    : positions_(positions), triangles_(triangles), clippable_(triangles.size()), bins_(bins) {
    for (uint32_t i = 0; i < triangles.size(); ++i) clippable_[i] = isClippable(cornersOf(i));
}

PlaneCut PlaneCutter::best(const References& references, const Aabb& box) const {
    PlaneCut best;
    // Clipping few triangles at many planes is most of the work, and gains next to nothing.
    const int count = std::min(bins_, std::max(4, int(references.size() / 4)));
    for (int axis = 0; axis < 3; ++axis) {
        const float extent = box.max[axis] - box.min[axis];
        // An extent so small or large that the map to bins is none.
        if (!std::isnormal(extent) || !std::isnormal(float(count) / extent)) continue;
        SpaceBins bins(box, axis, count);
        for (const Reference& reference : references) fill(bins, reference);
        offerPlanes(bins, best);
    }
    return best;
}

/// Adds the parts of the reference to the bins that it reaches.
template <class Bins>
void PlaneCutter::fill(Bins& space, const Reference& reference) const {
    Aabb rest = aabbOf(reference.box());
    const int axis = space.axis;
    const int first = space.binOf(rest.min[axis]);
    const int last = space.binOfEnd(rest.max[axis]);
    const uint32_t triangle = reference.item();
    if (first >= last || !clippable_[triangle]) {
        auto& bin = space.bins[space.binOf(0.5f * rest.min[axis] + 0.5f * rest.max[axis])];
        bin.box.grow(rest);
        ++bin.begins;
        ++bin.ends;
        return;
    }
    const Corners corners = cornersOf(triangle);
    int begin = -1, end = first;
    for (int i = first; i <= last && !rest.empty(); ++i) {
        const ClippedBoxes parts =
            i < last ? clip(corners, rest, axis, space.planes[i + 1]) : ClippedBoxes{rest, {}};
        rest = parts.right;
        if (parts.left.empty()) continue;
        space.bins[i].box.grow(parts.left);
        if (begin < 0) begin = i;
        end = i;
    }
    ++space.bins[std::max(begin, first)].begins;
    ++space.bins[end].ends;
}

void PlaneCutter::cut(const PlaneCut& cut, const References& references, Side& left,
                      Side& right) const {
    Aabb leftBox = cut.left, rightBox = cut.right;
    auto leftCount = double(cut.leftCount), rightCount = double(cut.rightCount);
    for (const Reference& reference : references) {
        const Aabb box = aabbOf(reference.box());
        const float low = box.min[cut.axis], high = box.max[cut.axis];
        const uint32_t triangle = reference.item();
        if (high <= cut.plane || low >= cut.plane || !clippable_[triangle]) {
            const bool isLeft = 0.5f * low + 0.5f * high < cut.plane;
            (isLeft ? left : right).add(reference);
            continue;
        }
        const ClippedBoxes parts = clip(cornersOf(triangle), box, cut.axis, cut.plane);
        if (parts.left.empty() || parts.right.empty()) {
            (parts.right.empty() ? left : right).add(reference);
            continue;
        }
        // Cutting may cost more than it gains ("reference unsplitting", section 4.4).
        const double asLeft =
            areaOf(joined(leftBox, box)) * leftCount + areaOf(rightBox) * (rightCount - 1);
        const double asRight =
            areaOf(leftBox) * (leftCount - 1) + areaOf(joined(rightBox, box)) * rightCount;
        const double asBoth = areaOf(leftBox) * leftCount + areaOf(rightBox) * rightCount;
        if (asBoth <= std::min(asLeft, asRight)) {
            left.add(Reference::of(parts.left.min, parts.left.max, triangle));
            right.add(Reference::of(parts.right.min, parts.right.max, triangle));
        } else if (asLeft <= asRight) {
            left.add(reference);
            leftBox.grow(box);
            rightCount -= 1;
        } else {
            right.add(reference);
            rightBox.grow(box);
            leftCount -= 1;
        }
    }
}

}  // namespace vitrine
