// SPDX-License-Identifier: MIT
// How the builder divides one range of boxes in two: the inner loops. Private to the builder.
//
// A range is an array of references, 32 bytes each, moved as a whole so that every pass reads
// memory in order. Centres are kept as min + max: twice the centre, which orders the same.
#pragma once

#include <array>
#include <limits>
#include <span>

#include "bvh/float4.hpp"

namespace vitrine {

struct Box4 {
    Float4 min;
    Float4 max;

    static Box4 empty() {
        constexpr float kInfinity = std::numeric_limits<float>::infinity();
        return {Float4::splat(kInfinity), Float4::splat(-kInfinity)};
    }
    void grow(const Box4& other) {
        min = vitrine::min(min, other.min);
        max = vitrine::max(max, other.max);
    }
    [[nodiscard]] float halfArea() const {
        const glm::vec3 extent = toVec3(max - min);
        return extent.x * (extent.y + extent.z) + extent.y * extent.z;
    }
    /// Lanes that are NaN do not grow.
    void grow(Float4 p) {
        min = vitrine::min(p, min);
        max = vitrine::max(p, max);
    }
};

/// A box and the number of its item. The number travels in the fourth lanes, 16 bits in each, as
/// mantissas of ordinary floats: a raw integer would be a denormal, which some CPUs add slowly.
struct Reference {
    Float4 min;
    Float4 max;

    static Reference of(const glm::vec3& min, const glm::vec3& max, uint32_t item) {
        const float low = std::bit_cast<float>(kExponent | (item & 0xffffu));
        const float high = std::bit_cast<float>(kExponent | (item >> 16));
        return {Float4::of(min.x, min.y, min.z, low), Float4::of(max.x, max.y, max.z, high)};
    }
    [[nodiscard]] uint32_t item() const {
        float low[4];
        float high[4];
        store(low, min);
        store(high, max);
        return (std::bit_cast<uint32_t>(low[3]) & 0xffffu) |
               ((std::bit_cast<uint32_t>(high[3]) & 0xffffu) << 16);
    }
    [[nodiscard]] Float4 centre() const { return min + max; }
    [[nodiscard]] Box4 box() const { return {min, max}; }

  private:
    static constexpr uint32_t kExponent = 0x40000000;  // of 2.0f
};
static_assert(sizeof(Reference) == 32);

/// Where a range may be cut: before bin `position` along `axis`. Axis -1: nowhere.
struct Split {
    float cost = std::numeric_limits<float>::infinity();  ///< area times items, both sides
    int axis = -1;
    int position = 0;
};

inline constexpr int kMaxBins = 32;
/// Ranges up to this size get a bin per item: every possible cut is looked at.
inline constexpr uint32_t kExactSize = 16;

/// Boxes and counts by bin, of the three axes side by side, so that one sweep serves all.
struct Bins {
    std::array<std::array<Box4, 3>, kMaxBins> boxes;
    std::array<std::array<int32_t, 4>, kMaxBins> counts;

    void clear(int bins);
    void add(const Bins& other, int bins);
    [[nodiscard]] Split best(int bins) const;
    /// What lies in bins [begin, end) of an axis.
    [[nodiscard]] Box4 box(int axis, int begin, int end) const;
    [[nodiscard]] uint32_t count(int axis, int begin, int end) const;
};

/// The linear map from centres to bins. Always within [0, bins), whatever the input.
struct BinMap {
    Float4 origin;
    Float4 scale;
    Float4 last;

    BinMap(const Box4& centres, int bins);
    [[nodiscard]] Float4 scaled(Float4 centre) const { return (centre - origin) * scale; }
    [[nodiscard]] Int4 operator()(Float4 centre) const {
        return toInt(max(min(scaled(centre), last), Float4::splat(0)));
    }
};

void fillBins(std::span<const Reference> references, const BinMap& map, Bins& bins);

/// Where the next reference of either side goes, and the boxes of the centres so far.
struct Partition {
    Reference* left;
    Reference* right;
    Box4 leftCentres = Box4::empty();
    Box4 rightCentres = Box4::empty();
};

/// Sends each reference to its side, keeping the order.
void partition(std::span<const Reference> references, const BinMap& map, const Split& split,
               Partition& out);

/// The number of each reference in the order along each axis, stored as four lanes; equal centres
/// keep their order. Precondition: at most kExactSize references.
using Ranks = std::array<std::array<int32_t, 4>, kExactSize>;
void rank(std::span<const Reference> references, Ranks& ranks);

}  // namespace vitrine
