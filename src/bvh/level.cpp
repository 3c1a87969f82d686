// SPDX-License-Identifier: MIT
#include "bvh/level.hpp"

#include <cassert>

namespace vitrine {
namespace {

void collect(const Bvh& bvh, uint32_t index, int level, std::vector<uint32_t>& out) {
    const BvhNode& node = bvh.nodes[index];
    if (level == 0 || node.leaf()) {
        out.push_back(index);
        return;
    }
    collect(bvh, node.first, level - 1, out);
    collect(bvh, node.first + 1, level - 1, out);
}

}  // namespace

std::vector<uint32_t> nodesOfLevel(const Bvh& bvh, int level) {
    assert(level >= 0);
    std::vector<uint32_t> result;
    if (!bvh.empty()) collect(bvh, 0, level, result);
    return result;
}

ItemRange itemsBelow(const Bvh& bvh, uint32_t node) {
    uint32_t left = node, right = node;
    while (!bvh.nodes[left].leaf()) left = bvh.nodes[left].first;
    while (!bvh.nodes[right].leaf()) right = bvh.nodes[right].first + 1;
    const BvhNode& last = bvh.nodes[right];
    const uint32_t first = bvh.nodes[left].first;
    return {first, last.first + last.count - first};
}

}  // namespace vitrine
