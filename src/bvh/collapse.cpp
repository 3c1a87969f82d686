// SPDX-License-Identifier: MIT
#include "bvh/collapse.hpp"

#include <algorithm>

namespace vitrine {
namespace {

/// The up to four nodes of the binary tree that become the children of the wide node of `root`.
struct Frontier {
    std::array<uint32_t, kWideWidth> nodes{};
    int size = 0;
};

Frontier openLargest(const Bvh& bvh, uint32_t root) {
    Frontier result{{root}, 1};
    while (result.size < kWideWidth) {
        int largest = -1;
        float largestArea = -1;
        for (int i = 0; i < result.size; ++i) {
            const BvhNode& node = bvh.nodes[result.nodes[i]];
            if (node.leaf() || node.box().halfArea() <= largestArea) continue;
            largest = i;
            largestArea = node.box().halfArea();
        }
        if (largest < 0) break;
        const uint32_t first = bvh.nodes[result.nodes[largest]].first;
        result.nodes[largest] = first;
        result.nodes[result.size++] = first + 1;
    }
    return result;
}

uint32_t collapse(const Bvh& bvh, uint32_t root, std::vector<WideNode>& out) {
    const auto index = uint32_t(out.size());
    const Frontier frontier = openLargest(bvh, root);
    out.emplace_back().childCount = frontier.size;
    for (int i = 0; i < frontier.size; ++i) {
        const BvhNode& node = bvh.nodes[frontier.nodes[i]];
        WideChild child{node.box(), node.leaf(), node.first, node.count};
        if (!child.leaf) child.first = collapse(bvh, frontier.nodes[i], out);
        out[index].children[i] = child;
    }
    return index;
}

}  // namespace

std::vector<WideNode> collapse4(const Bvh& bvh) {
    std::vector<WideNode> result;
    if (bvh.empty()) return result;
    result.reserve(bvh.nodes.size() / 3 + 1);
    collapse(bvh, 0, result);
    return result;
}

int wideStackBound(std::span<const WideNode> nodes) {
    // Parents come before children, so one pass backwards knows the bound of every subtree.
    std::vector<int> bound(nodes.size(), 0);
    for (size_t i = nodes.size(); i-- > 0;) {
        int below = 0;
        for (int c = 0; c < nodes[i].childCount; ++c) {
            const WideChild& child = nodes[i].children[c];
            if (!child.leaf) below = std::max(below, bound[child.first]);
        }
        bound[i] = nodes[i].childCount - 1 + below;
    }
    return bound.empty() ? 0 : bound[0];
}

}  // namespace vitrine
