// SPDX-License-Identifier: MIT
// The recursion of the builders that never cut an item: what divides a range is their own matter.
// Two buffers of references take turns: dividing a range reads one and writes the other.
//
// Determinism. What happens to a range depends on its references alone. Large ranges are worked on
// in chunks of fixed size whose results are joined in order; subtrees below kTaskSize are built by
// one thread into a region of node slots that only its number of items decides. The slots are in
// depth-first order with gaps, and the gaps are closed at the end.
//
// Depth. Let D = max(maxDepth, ceil(log2(n))). A node at depth d has at most 2^(D-d) items: true
// for the root, and a cut that leaves a child with more than 2^(D-d-1) is replaced by the median,
// whose halves have at most ceil(2^(D-d) / 2) = 2^(D-d-1). At depth D one item is left: a leaf.
#include "bvh/build.hpp"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <memory>
#include <mutex>

#include "bvh/divide.hpp"
#include "bvh/nine.hpp"
#include "bvh/spatial.hpp"

namespace vitrine {
namespace {

constexpr uint32_t kTaskSize = 2048;  ///< subtrees from this size on are tasks of their own

template <class Divide>
class Builder {
  public:
    Builder(uint32_t count, const BuildOptions& options)
        : divide_({options, std::max(options.maxDepth, int(std::bit_width(count - 1)))}),
          references_(std::make_unique_for_overwrite<Reference[]>(2 * size_t(count))),
          slots_(std::make_unique_for_overwrite<BvhNode[]>(2 * size_t(count))),
          count_(count) {
        assert(count <= 1u << 31 && "node slots are numbered by 32 bits");
        items_.resize(count);
    }

    /// `referenceOf(i)` makes the reference of item i.
    template <typename F>
    Bvh build(const F& referenceOf) {
        std::vector<Bounds> bounds(chunkCount(count_));
        forChunks(count_, [&](uint32_t chunk, uint32_t begin, uint32_t size) {
            for (uint32_t i = begin; i < begin + size; ++i) references_[i] = referenceOf(i);
            bounds[chunk] = boundsOf({&references_[begin], size});
        });
        Range root{&references_[0], &references_[count_], 0, count_, 0, {}};
        for (const Bounds& b : bounds) root.bounds.grow(b);
        segments_.push_back({0, 1});
        buildTask(root, 0, 1);
        return {compacted(), std::move(items_)};
    }

  private:
    /// Slots [begin, begin + size) that are in use.
    struct Segment {
        uint32_t begin;
        uint32_t size;
    };

    // A subtree of n items owns 2n-2 slots for the nodes below its root: two for the children,
    // 2l-2 for what is below the left one, then 2r-2 for what is below the right one.
    void buildTask(const Range& range, uint32_t slot, uint32_t region) {
        if (range.count < kTaskSize) {
            uint32_t next = region;
            buildSubtree(range, slot, next);
            addSegment(region, next - region);
            return;
        }
        Children children;
        if (!divide_(range, children)) return makeLeaf(range, slot);
        makeInner(range, slot, region);
        addSegment(region, 2);
        tbb::parallel_invoke(
            [&] { buildTask(children.left, region, region + 2); },
            [&] { buildTask(children.right, region + 1, region + 2 * children.left.count); });
    }

    void buildSubtree(const Range& range, uint32_t slot, uint32_t& next) {
        Children children;
        if (!divide_(range, children)) return makeLeaf(range, slot);
        const uint32_t pair = next;
        next += 2;
        makeInner(range, slot, pair);
        buildSubtree(children.left, pair, next);
        buildSubtree(children.right, pair + 1, next);
    }

    void makeInner(const Range& range, uint32_t slot, uint32_t first) {
        slots_[slot] = {toVec3(range.bounds.box.min), first, toVec3(range.bounds.box.max), 0};
    }

    void makeLeaf(const Range& range, uint32_t slot) {
        slots_[slot] = {toVec3(range.bounds.box.min), range.begin, toVec3(range.bounds.box.max),
                        range.count};
        for (uint32_t i = 0; i < range.count; ++i)
            items_[range.begin + i] = range.references[i].item();
    }

    void addSegment(uint32_t begin, uint32_t size) {
        if (size == 0) return;  // a leaf: its node is in the parent's pair
        const std::lock_guard lock(segmentsMutex_);
        segments_.push_back({begin, size});
    }

    /// The used slots without the gaps.
    std::vector<BvhNode> compacted() {
        std::sort(segments_.begin(), segments_.end(),
                  [](const Segment& a, const Segment& b) { return a.begin < b.begin; });
        std::vector<uint32_t> gapsBefore(segments_.size());
        uint32_t used = 0;
        for (size_t i = 0; i < segments_.size(); ++i) {
            gapsBefore[i] = segments_[i].begin - used;
            used += segments_[i].size;
        }
        const auto gapOf = [&](uint32_t slot) {
            const auto after =
                std::upper_bound(segments_.begin(), segments_.end(), slot,
                                 [](uint32_t value, const Segment& s) { return value < s.begin; });
            return gapsBefore[after - segments_.begin() - 1];
        };
        std::vector<BvhNode> nodes(used);
        tbb::parallel_for(size_t(0), segments_.size(), [&](size_t i) {
            const Segment segment = segments_[i];
            for (uint32_t slot = segment.begin; slot < segment.begin + segment.size; ++slot) {
                BvhNode& node = nodes[slot - gapsBefore[i]];
                node = slots_[slot];
                if (node.leaf()) continue;
                const bool here = node.first - segment.begin < segment.size;
                node.first -= here ? gapsBefore[i] : gapOf(node.first);
            }
        });
        return nodes;
    }

    Divide divide_;
    std::unique_ptr<Reference[]> references_;  ///< both buffers, one after the other
    std::unique_ptr<BvhNode[]> slots_;
    uint32_t count_;
    std::vector<uint32_t> items_;
    std::mutex segmentsMutex_;
    std::vector<Segment> segments_;
};

void checkOptions(const BuildOptions& options) {
    assert(options.maxLeafSize >= 1);
    assert(options.maxDuplicates >= 0 && options.minOverlap >= 0);
    assert(options.bins >= 2 && options.bins <= kMaxBins);
    assert(options.maxDepth >= 0 && options.maxDepth <= 63);
    (void)options;
}

Reference checkedReference(const glm::vec3& min, const glm::vec3& max, uint32_t item) {
    assert(isFinite(min) && isFinite(max));
    assert(min.x <= max.x && min.y <= max.y && min.z <= max.z);
    return Reference::of(min, max, item);
}

template <typename F>
Bvh buildUncut(size_t count, const BuildOptions& options, const F& referenceOf) {
    if (options.method == BuildMethod::kNine)
        return Builder<NineDivider>(uint32_t(count), options).build(referenceOf);
    return Builder<Divider>(uint32_t(count), options).build(referenceOf);
}

}  // namespace

Bvh buildBvh(std::span<const Aabb> boxes, const BuildOptions& options) {
    checkOptions(options);
    assert(options.method != BuildMethod::kSpatial);
    if (boxes.empty()) return {};
    return buildUncut(boxes.size(), options, [boxes](uint32_t i) {
        return checkedReference(boxes[i].min, boxes[i].max, i);
    });
}

Bvh buildTriangleBvh(std::span<const glm::vec3> positions, std::span<const glm::uvec3> triangles,
                     const BuildOptions& options) {
    checkOptions(options);
    if (triangles.empty()) return {};
    const auto referenceOf = [&](uint32_t i) {
        assert(glm::all(glm::lessThan(triangles[i], glm::uvec3(uint32_t(positions.size())))));
        const glm::vec3& a = positions[triangles[i].x];
        const glm::vec3& b = positions[triangles[i].y];
        const glm::vec3& c = positions[triangles[i].z];
        return checkedReference(glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c)), i);
    };
    if (options.method != BuildMethod::kSpatial)
        return buildUncut(triangles.size(), options, referenceOf);
    std::vector<Reference> references(triangles.size());
    for (uint32_t i = 0; i < triangles.size(); ++i) references[i] = referenceOf(i);
    return buildSpatial(positions, triangles, std::move(references), options);
}

}  // namespace vitrine
