// SPDX-License-Identifier: MIT
#include "pack/bvh_layout.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>

#include "bvh/collapse.hpp"
#include "shared/limits.glsl"

namespace vitrine {
namespace {

constexpr uint32_t kLeafFlag = 0x80;
constexpr uint32_t kLargestOffset = 0x7e;  // seven bits hold 1 + offset

float stepOf(uint32_t exponent) {
    return std::bit_cast<float>(exponent << 23);
}

glm::uvec3 bitsOf(const glm::vec3& v) {
    return {std::bit_cast<uint32_t>(v.x), std::bit_cast<uint32_t>(v.y),
            std::bit_cast<uint32_t>(v.z)};
}

/// The largest step number whose plane is not above `value`, and the smallest not below, as the
/// shader's float arithmetic places them.
uint32_t lowStep(float origin, float step, float value) {
    auto n = static_cast<int>(std::clamp(std::floor((value - origin) / step), 0.0f, 255.0f));
    while (n > 0 && origin + static_cast<float>(n) * step > value) --n;
    return static_cast<uint32_t>(n);
}

int highStep(float origin, float step, float value) {
    auto n = static_cast<int>(std::clamp(std::ceil((value - origin) / step), 0.0f, 256.0f));
    while (n <= 255 && origin + static_cast<float>(n) * step < value) ++n;
    return n;
}

}  // namespace

QuantisedNode quantise(std::span<const Aabb> children) {
    Aabb box;
    for (const Aabb& child : children) box.grow(child);
    QuantisedNode node{box.min, {}, {}, {}};
    for (int axis = 0; axis < 3; ++axis) {
        // Steps are powers of two: the smallest whose 255 reach across the box, at least 2^-97 so
        // that nothing is denormal.
        uint32_t exponent = 30;
        while (exponent < 254 && highStep(box.min[axis], stepOf(exponent), box.max[axis]) > 255)
            ++exponent;
        node.exponents[axis] = exponent;
        const float step = stepOf(exponent);
        for (size_t i = 0; i < children.size(); ++i) {
            const uint32_t shift = 8 * static_cast<uint32_t>(i);
            node.low[axis] |= lowStep(box.min[axis], step, children[i].min[axis]) << shift;
            node.high[axis] |=
                static_cast<uint32_t>(highStep(box.min[axis], step, children[i].max[axis]))
                << shift;
        }
    }
    return node;
}

Aabb dequantise(const QuantisedNode& node, int child) {
    Aabb box;
    for (int axis = 0; axis < 3; ++axis) {
        const float step = stepOf(node.exponents[axis]);
        const auto plane = [&](uint32_t word) {
            return node.origin[axis] + static_cast<float>((word >> (8 * child)) & 255u) * step;
        };
        box.min[axis] = plane(node.low[axis]);
        box.max[axis] = plane(node.high[axis]);
    }
    return box;
}

/// `writeItem(item, last)` gives the three texels of an item of a leaf.
template <class WriteItem>
uint32_t BvhLayout::add(const Bvh& bvh, int& stackBound, const WriteItem& writeItem) {
    const std::vector<WideNode> wide = collapse4(bvh);
    stackBound = std::max(stackBound, wideStackBound(wide));
    const auto slotCount = [&] {
        return firstSlot_ + static_cast<uint32_t>(texels_.size() / VITRINE_SLOT_TEXELS);
    };
    const auto texelsOf = [&](uint32_t slot) {
        return texels_.begin() + (slot - firstSlot_) * VITRINE_SLOT_TEXELS;
    };
    const auto root = slotCount();
    texels_.resize(texels_.size() + VITRINE_SLOT_TEXELS);
    struct Pending {
        uint32_t node, slot;
    };
    std::vector<Pending> pending{{0, root}};
    while (!pending.empty()) {
        const auto [index, slot] = pending.back();
        pending.pop_back();
        const WideNode& node = wide[index];
        std::array<Aabb, kWideWidth> boxes;
        for (int i = 0; i < node.childCount; ++i) boxes[i] = node.children[i].box;
        const QuantisedNode q = quantise({boxes.data(), static_cast<size_t>(node.childCount)});

        const uint32_t block = slotCount();
        uint32_t offset = 0, entries = 0;
        for (int i = 0; i < node.childCount; ++i) {
            const WideChild& child = node.children[i];
            assert(offset <= kLargestOffset);
            entries |= ((offset + 1) | (child.leaf ? kLeafFlag : 0)) << (8 * i);
            if (!child.leaf) pending.push_back({child.first, block + offset});
            offset += child.leaf ? child.count : 1;
        }
        texels_.resize(texels_.size() + offset * VITRINE_SLOT_TEXELS);
        offset = 0;
        for (int i = 0; i < node.childCount; ++i) {
            const WideChild& child = node.children[i];
            for (uint32_t k = 0; child.leaf && k < child.count; ++k) {
                const auto item = writeItem(bvh.items[child.first + k], k + 1 == child.count);
                std::copy(item.begin(), item.end(), texelsOf(block + offset + k));
            }
            offset += child.leaf ? child.count : 1;
        }
        const auto texel = texelsOf(slot);
        texel[0] = {bitsOf(q.origin), q.exponents.x | q.exponents.y << 8 | q.exponents.z << 16};
        texel[1] = {q.low.x, q.high.x, q.low.y, q.high.y};
        texel[2] = {q.low.z, q.high.z, block, entries};
    }
    return root;
}

uint32_t BvhLayout::addMesh(const Bvh& bvh, std::span<const glm::vec3> positions,
                            std::span<const glm::uvec3> triangles) {
    return add(bvh, meshStack_, [&](uint32_t item, bool last) {
        const glm::uvec3& t = triangles[item];
        return std::array<glm::uvec4, VITRINE_SLOT_TEXELS>{
            glm::uvec4(bitsOf(positions[t.x]), item | (last ? VITRINE_LAST_TRIANGLE_BIT : 0u)),
            glm::uvec4(bitsOf(positions[t.y]), 0u), glm::uvec4(bitsOf(positions[t.z]), 0u)};
    });
}

uint32_t BvhLayout::addInstances(const Bvh& bvh, std::span<const uint32_t> instances) {
    return add(bvh, instanceStack_, [&](uint32_t item, bool) {
        return std::array<glm::uvec4, VITRINE_SLOT_TEXELS>{glm::uvec4(instances[item], 0u, 0u, 0u)};
    });
}

void BvhLayout::clear() {
    texels_.clear();
    meshStack_ = instanceStack_ = 0;
}

}  // namespace vitrine
