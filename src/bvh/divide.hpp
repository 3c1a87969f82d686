// SPDX-License-Identifier: MIT
// One step of the binned builder: whether and where to cut a range of references; and the rules
// that all builders share. Private to the builders.
#pragma once

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstdint>
#include <span>

#include "bvh/build.hpp"
#include "bvh/split.hpp"

namespace vitrine {

struct Bounds {
    Box4 box = Box4::empty();
    Box4 centres = Box4::empty();

    void grow(const Bounds& other) {
        box.grow(other.box);
        centres.grow(other.centres);
    }
};

/// References [begin, begin + count) of the whole; `spare` is the same place in the other buffer.
/// `bounds.centres` is known only above kExactSize.
struct Range {
    Reference* references;
    Reference* spare;
    uint32_t begin;
    uint32_t count;
    int depth;
    Bounds bounds;

    [[nodiscard]] std::span<Reference> span() const { return {references, count}; }
    /// The part [first, first + size), with the buffers' roles swapped if it was moved.
    [[nodiscard]] Range part(uint32_t first, uint32_t size, bool moved, const Bounds& b) const {
        Reference* here = (moved ? spare : references) + first;
        Reference* there = (moved ? references : spare) + first;
        return {here, there, begin + first, size, depth + 1, b};
    }
};

struct Children {
    Range left;
    Range right;
};

Bounds boundsOf(std::span<const Reference> references);

/// Loops over the references of large ranges go in chunks of fixed size, whatever the number of
/// threads: work(chunk, begin, size).
inline constexpr uint32_t kChunkSize = 4096;

inline uint32_t chunkCount(uint32_t count) {
    return (count + kChunkSize - 1) / kChunkSize;
}

template <typename F>
void forChunks(uint32_t count, F&& work) {
    tbb::parallel_for(0u, chunkCount(count), [&](uint32_t chunk) {
        const uint32_t begin = chunk * kChunkSize;
        work(chunk, begin, std::min(kChunkSize, count - begin));
    });
}

/// Which cuts are worth it. `cost` is the area times the items of both sides, as in Split.
struct CutRules {
    BuildOptions options;
    int depthLimit;  ///< no node at depth d has more than 2^(depthLimit - d) items

    [[nodiscard]] bool isLeaf(float area, uint32_t count, float cost) const {
        if (count > uint32_t(options.maxLeafSize)) return false;
        return !(options.traversalCost * area + options.intersectionCost * cost <
                 options.intersectionCost * area * float(count));
    }
    [[nodiscard]] bool fits(int depth, uint32_t left, uint32_t right) const {
        const uint64_t most = uint64_t(1) << (depthLimit - depth - 1);
        return left <= most && right <= most;
    }
    /// Whether the cut is worth more than the median, and the depth limit allows both sides.
    [[nodiscard]] bool accepts(const Range& range, float cost, uint32_t left) const {
        // Boxes that all cover the same: any cut is as good, and an even one keeps the tree low.
        const float gainless = (1 - 1e-6f) * range.bounds.box.halfArea() * float(range.count);
        return cost < gainless && fits(range.depth, left, range.count - left);
    }
};

/// Orders the references such that the first half comes before the second by centre along the
/// axis; equal centres by number. Returns the size of the first half.
uint32_t orderAtMedian(std::span<Reference> references, int axis);

/// Half of the items on either side, by centre along the widest axis, or by number if all
/// centres are equal.
bool divideAtMedian(const Range& range, Children& out);

class Divider {
  public:
    explicit Divider(const CutRules& rules) : rules_(rules) {}

    /// False if the range is better left whole.
    bool operator()(const Range& range, Children& out) const;

  private:
    bool dividePair(const Range& range, Children& out) const;
    bool divideExactly(const Range& range, Children& out) const;
    bool divideByBins(const Range& range, Children& out) const;
    bool divideInChunks(const Range& range, const BinMap& map, int binCount, Children& out) const;

    CutRules rules_;
};

}  // namespace vitrine
