// SPDX-License-Identifier: MIT
// One step of the builder: whether and where to cut a range of references. Private to the builder.
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

class Divider {
  public:
    /// Precondition: no node at depth d has more than 2^(depthLimit - d) items.
    Divider(const BuildOptions& options, int depthLimit)
        : options_(options), depthLimit_(depthLimit) {}

    /// False if the range is better left whole.
    bool operator()(const Range& range, Children& out) const;

  private:
    [[nodiscard]] bool isLeaf(const Range& range, const Split& split) const;
    [[nodiscard]] bool accepts(const Range& range, const Split& split, uint32_t left) const;
    bool dividePair(const Range& range, Children& out) const;
    bool divideExactly(const Range& range, Children& out) const;
    bool divideByBins(const Range& range, Children& out) const;
    bool divideInChunks(const Range& range, const BinMap& map, int binCount, Children& out) const;

    BuildOptions options_;
    int depthLimit_;
};

}  // namespace vitrine
