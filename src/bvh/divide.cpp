// SPDX-License-Identifier: MIT
#include "bvh/divide.hpp"

#include <vector>

namespace vitrine {
namespace {

constexpr uint32_t kParallelSize = 16384;  ///< ranges from this size on are looped over by all

void finish(const Range& range, const Bins& bins, const Split& split, int binCount, uint32_t left,
            const Partition& sides, Children& out) {
    const Box4 leftBox = bins.box(split.axis, 0, split.position);
    const Box4 rightBox = bins.box(split.axis, split.position, binCount);
    out.left = range.part(0, left, true, {leftBox, sides.leftCentres});
    out.right = range.part(left, range.count - left, true, {rightBox, sides.rightCentres});
}

}  // namespace

Bounds boundsOf(std::span<const Reference> references) {
    Bounds result;
    for (const Reference& reference : references) {
        result.box.grow(reference.box());
        result.centres.grow(reference.centre());
    }
    return result;
}

uint32_t orderAtMedian(std::span<Reference> references, int axis) {
    const auto half = uint32_t(references.size() / 2);
    std::nth_element(references.begin(), references.begin() + half, references.end(),
                     [axis](const Reference& a, const Reference& b) {
                         const float ca = toVec3(a.centre())[axis];
                         const float cb = toVec3(b.centre())[axis];
                         return ca != cb ? ca < cb : a.item() < b.item();
                     });
    return half;
}

bool divideAtMedian(const Range& range, Children& out) {
    const Bounds all = boundsOf(range.span());
    const glm::vec3 extent = toVec3(all.centres.max - all.centres.min);
    int axis = extent.y > extent.x ? 1 : 0;
    if (extent.z > extent[axis]) axis = 2;
    const uint32_t left = range.count / 2;
    if (extent[axis] > 0) orderAtMedian(range.span(), axis);
    const auto half = [&](uint32_t first, uint32_t size) {
        return range.part(first, size, false, boundsOf(range.span().subspan(first, size)));
    };
    out = {half(0, left), half(left, range.count - left)};
    return true;
}

bool Divider::operator()(const Range& range, Children& out) const {
    if (range.count == 1) return false;
    if (range.count == 2) return dividePair(range, out);
    return range.count <= kExactSize ? divideExactly(range, out) : divideByBins(range, out);
}

/// Nearly half of all cuts are of two items, and there is only one.
bool Divider::dividePair(const Range& range, Children& out) const {
    const Box4 left = range.references[0].box();
    const Box4 right = range.references[1].box();
    const float area = range.bounds.box.halfArea();
    if (rules_.isLeaf(area, 2, left.halfArea() + right.halfArea())) return false;
    out = {range.part(0, 1, false, {left}), range.part(1, 1, false, {right})};
    return true;
}

bool Divider::divideExactly(const Range& range, Children& out) const {
    const int count = int(range.count);
    Ranks ranks;
    rank(range.span(), ranks);
    Bins bins;
    for (int i = 0; i < count; ++i) {
        bins.counts[i].fill(1);
        for (int axis = 0; axis < 3; ++axis)
            bins.boxes[ranks[i][axis]][axis] = range.references[i].box();
    }
    const Split split = bins.best(count);
    if (rules_.isLeaf(range.bounds.box.halfArea(), range.count, split.cost)) return false;
    if (!rules_.accepts(range, split.cost, split.position)) return divideAtMedian(range, out);
    for (int i = 0; i < count; ++i) range.spare[ranks[i][split.axis]] = range.references[i];
    const uint32_t left = split.position;
    out.left = range.part(0, left, true, {bins.box(split.axis, 0, split.position)});
    out.right =
        range.part(left, range.count - left, true, {bins.box(split.axis, split.position, count)});
    return true;
}

bool Divider::divideByBins(const Range& range, Children& out) const {
    // Few bins serve small ranges as well: their sides are looked at more closely later.
    const int binCount = std::min(rules_.options.bins, int(std::max(8u, range.count / 8)));
    const BinMap map(range.bounds.centres, binCount);
    if (range.count >= kParallelSize) return divideInChunks(range, map, binCount, out);

    Bins bins;
    bins.clear(binCount);
    fillBins(range.span(), map, bins);
    const Split split = bins.best(binCount);
    if (rules_.isLeaf(range.bounds.box.halfArea(), range.count, split.cost)) return false;
    const uint32_t left = split.axis < 0 ? 0 : bins.count(split.axis, 0, split.position);
    if (!rules_.accepts(range, split.cost, left)) return divideAtMedian(range, out);
    Partition sides{range.spare, range.spare + left};
    partition(range.span(), map, split, sides);
    finish(range, bins, split, binCount, left, sides, out);
    return true;
}

bool Divider::divideInChunks(const Range& range, const BinMap& map, int binCount,
                             Children& out) const {
    std::vector<Bins> chunks(chunkCount(range.count));
    forChunks(range.count, [&](uint32_t chunk, uint32_t begin, uint32_t size) {
        chunks[chunk].clear(binCount);
        fillBins(range.span().subspan(begin, size), map, chunks[chunk]);
    });
    Bins bins;
    bins.clear(binCount);
    for (const Bins& chunk : chunks) bins.add(chunk, binCount);
    const Split split = bins.best(binCount);
    if (rules_.isLeaf(range.bounds.box.halfArea(), range.count, split.cost)) return false;
    const uint32_t left = split.axis < 0 ? 0 : bins.count(split.axis, 0, split.position);
    if (!rules_.accepts(range, split.cost, left)) return divideAtMedian(range, out);

    std::vector<Partition> sides;
    sides.reserve(chunks.size());
    Reference* nextLeft = range.spare;
    Reference* nextRight = range.spare + left;
    for (const Bins& chunk : chunks) {
        sides.push_back({nextLeft, nextRight});
        nextLeft += chunk.count(split.axis, 0, split.position);
        nextRight += chunk.count(split.axis, split.position, binCount);
    }
    forChunks(range.count, [&](uint32_t chunk, uint32_t begin, uint32_t size) {
        partition(range.span().subspan(begin, size), map, split, sides[chunk]);
    });
    for (size_t i = 1; i < sides.size(); ++i) {
        sides[0].leftCentres.grow(sides[i].leftCentres);
        sides[0].rightCentres.grow(sides[i].rightCentres);
    }
    finish(range, bins, split, binCount, left, sides[0], out);
    return true;
}

}  // namespace vitrine
