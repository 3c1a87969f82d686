// SPDX-License-Identifier: MIT
#include "bvh/split.hpp"

#include <algorithm>

namespace vitrine {
namespace {

/// Half areas of three boxes, one a lane. An empty box gives infinity.
Float4 halfAreas(const std::array<Box4, 3>& boxes) {
    Float4 x = boxes[0].max - boxes[0].min;
    Float4 y = boxes[1].max - boxes[1].min;
    Float4 z = boxes[2].max - boxes[2].min;
    transpose3(x, y, z);
    return x * (y + z) + y * z;
}

void grow(std::array<Box4, 3>& boxes, const std::array<Box4, 3>& others) {
    boxes[0].grow(others[0]);
    boxes[1].grow(others[1]);
    boxes[2].grow(others[2]);
}

template <int Axis>
void partitionAlong(std::span<const Reference> references, const BinMap& map, int position,
                    Partition& out) {
    const Float4 origin = splatLane<Axis>(map.origin);
    const Float4 scale = splatLane<Axis>(map.scale);
    const Float4 limit = Float4::splat(float(position));
    // Local copies stay in registers.
    Box4 leftCentres = out.leftCentres;
    Box4 rightCentres = out.rightCentres;
    Reference* sides[2] = {out.right, out.left};
    for (const Reference& reference : references) {
        const Float4 centre = reference.centre();
        // The same product as in BinMap, so both agree on every reference.
        const Float4 scaled = (splatLane<Axis>(centre) - origin) * scale;
        const Float4 isLeft = less(scaled, limit);
        leftCentres.grow(orMask(centre, notLess(scaled, limit)));
        rightCentres.grow(orMask(centre, isLeft));
        // No branch: it would be mispredicted half of the time.
        *sides[firstLane(isLeft)]++ = reference;
    }
    out = {sides[1], sides[0], leftCentres, rightCentres};
}

}  // namespace

void Bins::clear(int bins) {
    for (int bin = 0; bin < bins; ++bin) {
        boxes[bin].fill(Box4::empty());
        counts[bin].fill(0);
    }
}

void Bins::add(const Bins& other, int bins) {
    for (int bin = 0; bin < bins; ++bin) {
        grow(boxes[bin], other.boxes[bin]);
        for (int axis = 0; axis < 3; ++axis) counts[bin][axis] += other.counts[bin][axis];
    }
}

Split Bins::best(int bins) const {
    // A side without items has infinite area and count 0: its cost is NaN, which is never less.
    std::array<Float4, kMaxBins> rightCosts;
    std::array<Box4, 3> side;
    side.fill(Box4::empty());
    Int4 sideCounts = Int4::splat(0);
    for (int bin = bins - 1; bin > 0; --bin) {
        grow(side, boxes[bin]);
        sideCounts = sideCounts + loadInt4(counts[bin].data());
        rightCosts[bin] = halfAreas(side) * toFloat(sideCounts);
    }
    side.fill(Box4::empty());
    sideCounts = Int4::splat(0);
    Float4 bestCosts = Float4::splat(std::numeric_limits<float>::infinity());
    Float4 bestPositions = Float4::splat(0);
    for (int bin = 1; bin < bins; ++bin) {
        grow(side, boxes[bin - 1]);
        sideCounts = sideCounts + loadInt4(counts[bin - 1].data());
        const Float4 costs = halfAreas(side) * toFloat(sideCounts) + rightCosts[bin];
        const Float4 better = less(costs, bestCosts);
        bestCosts = select(better, costs, bestCosts);
        bestPositions = select(better, Float4::splat(float(bin)), bestPositions);
    }

    // Costs are never negative, so their bits are in the order of their values: the cheapest axis
    // is the least of three integers, found without branches.
    float costs[4];
    float positions[4];
    store(costs, bestCosts);
    store(positions, bestPositions);
    const auto key = [&](int axis) {
        return uint64_t(std::bit_cast<uint32_t>(costs[axis])) << 32 | uint64_t(axis) << 8 |
               uint64_t(positions[axis]);
    };
    const uint64_t least = std::min(key(0), std::min(key(1), key(2)));
    Split result;
    result.cost = std::bit_cast<float>(uint32_t(least >> 32));
    result.position = int(least & 0xff);
    if (result.position > 0) result.axis = int(least >> 8 & 0xff);
    return result;
}

Box4 Bins::box(int axis, int begin, int end) const {
    Box4 result = Box4::empty();
    for (int bin = begin; bin < end; ++bin) result.grow(boxes[bin][axis]);
    return result;
}

uint32_t Bins::count(int axis, int begin, int end) const {
    uint32_t result = 0;
    for (int bin = begin; bin < end; ++bin) result += counts[bin][axis];
    return result;
}

BinMap::BinMap(const Box4& centres, int bins)
    : origin(centres.min), last(Float4::splat(float(bins - 1))) {
    const glm::vec3 extent = toVec3(centres.max - centres.min);
    const auto scaleOf = [bins](float length) { return length > 0 ? float(bins) / length : 0.0f; };
    scale = Float4::of(scaleOf(extent.x), scaleOf(extent.y), scaleOf(extent.z), 0);
}

void fillBins(std::span<const Reference> references, const BinMap& map, Bins& bins) {
    for (const Reference& reference : references) {
        int32_t bin[4];
        store(bin, map(reference.centre()));
        const auto grow = [&](int axis) {
            bins.boxes[bin[axis]][axis].grow(reference.box());
            ++bins.counts[bin[axis]][axis];
        };
        grow(0);
        grow(1);
        grow(2);
    }
}

void partition(std::span<const Reference> references, const BinMap& map, const Split& split,
               Partition& out) {
    if (split.axis == 0) partitionAlong<0>(references, map, split.position, out);
    if (split.axis == 1) partitionAlong<1>(references, map, split.position, out);
    if (split.axis == 2) partitionAlong<2>(references, map, split.position, out);
}

void rank(std::span<const Reference> references, Ranks& ranks) {
    std::array<Float4, kExactSize> centres;
    std::array<Int4, kExactSize> sums;
    const int count = int(references.size());
    for (int i = 0; i < count; ++i) {
        centres[i] = references[i].centre();
        Int4 sum = Int4::splat(i);
        for (int j = 0; j < i; ++j) {
            // All bits set is -1: i goes before j.
            const Int4 before = bits(less(centres[i], centres[j]));
            sum = sum + before;
            sums[j] = sums[j] - before;
        }
        sums[i] = sum;
    }
    for (int i = 0; i < count; ++i) store(ranks[i].data(), sums[i]);
}

}  // namespace vitrine
