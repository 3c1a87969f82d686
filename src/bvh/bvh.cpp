// SPDX-License-Identifier: MIT
#include "bvh/bvh.hpp"

#include <algorithm>

namespace vitrine {

BvhStatistics measure(const Bvh& bvh, float traversalCost, float intersectionCost) {
    BvhStatistics result;
    result.nodes = bvh.nodes.size();
    result.references = bvh.items.size();
    if (bvh.empty()) return result;

    // Parents come before children, so one pass forward knows every depth.
    std::vector<int> depth(bvh.nodes.size(), 0);
    double cost = 0;
    for (size_t i = 0; i < bvh.nodes.size(); ++i) {
        const BvhNode& node = bvh.nodes[i];
        result.depth = std::max(result.depth, depth[i]);
        const double area = node.box().halfArea();
        if (!node.leaf()) {
            cost += area * traversalCost;
            depth[node.first] = depth[node.first + 1] = depth[i] + 1;
            continue;
        }
        cost += area * intersectionCost * node.count;
        ++result.leaves;
        result.maxLeaf = std::max(result.maxLeaf, int(node.count));
        ++result.leafSizes[std::min<size_t>(node.count, result.leafSizes.size() - 1)];
    }
    result.meanLeaf = double(bvh.items.size()) / double(result.leaves);
    // A root without area (all items in one point or line) is hit by no ray: its cost is 0.
    const double rootArea = bvh.box().halfArea();
    result.sahCost = rootArea > 0 ? cost / rootArea : 0;
    return result;
}

}  // namespace vitrine
