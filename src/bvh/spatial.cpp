// SPDX-License-Identifier: MIT
// After Stich, Friedrich and Dietrich 2009. At each node the best cut of the items is compared with
// the best plane that cuts the triangles themselves; references to both sides of a cut triangle
// carry the boxes of its parts.
//
// Duplicates. A subtree may make as many as its budget says. What the node itself does not use goes
// to the children by their share of area times items, and what the left one leaves over to the
// right one: so the tree does not depend on more than the order of the input. One thread.
//
// Depth. The proof of build.cpp holds: D is taken for all references that there may ever be, and a
// plane that would give a side more than 2^(D-d-1) of them is not taken.
#include "bvh/spatial.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <utility>

#include "bvh/divide.hpp"
#include "bvh/plane_cut.hpp"

namespace vitrine {
namespace {

/// The best cut of the items, by their centres.
struct ItemCut {
    double cost = std::numeric_limits<double>::infinity();  ///< area times references of the sides
    int axis = -1;
    int position = 0;
    Ranks ranks;  ///< of few items; else:
    BinMap map{Box4::empty(), 2};
    double overlap = 0;  ///< area that both sides share
};

class SpatialBuilder {
  public:
    SpatialBuilder(std::span<const glm::vec3> positions, std::span<const glm::uvec3> triangles,
                   const BuildOptions& options)
        : planes_(positions, triangles, options.bins), options_(options) {}

    Bvh build(References references) {
        const auto budget = uint64_t(double(options_.maxDuplicates) * double(references.size()));
        const uint64_t most = references.size() + budget;
        assert(most <= 1u << 31);
        rules_ = {options_, std::max(options_.maxDepth, int(std::bit_width(most - 1)))};
        out_.items.reserve(most);
        out_.nodes.resize(1);
        rootArea_ = areaOf(aabbOf(boundsOf(references).box));
        buildNode(std::move(references), 0, 0, budget);
        return std::move(out_);
    }

  private:
    /// Returns what is left of the budget.
    uint64_t buildNode(References references, uint32_t slot, int depth, uint64_t budget) {
        const Aabb box = aabbOf(boundsOf(references).box);
        Side left, right;
        if (!divide(references, box, depth, budget, left, right)) {
            const auto first = uint32_t(out_.items.size());
            out_.nodes[slot] = {box.min, first, box.max, uint32_t(references.size())};
            for (const Reference& reference : references) out_.items.push_back(reference.item());
            return budget;
        }
        budget -= left.references.size() + right.references.size() - references.size();
        references = {};  // the recursion would keep those of all levels
        const auto pair = uint32_t(out_.nodes.size());
        out_.nodes[slot] = {box.min, pair, box.max, 0};
        out_.nodes.resize(out_.nodes.size() + 2);
        const double leftShare = areaOf(left.box) * double(left.references.size());
        const double all = leftShare + areaOf(right.box) * double(right.references.size());
        const auto forLeft =
            all > 0 ? uint64_t(double(budget) * std::min(leftShare / all, 1.0)) : 0;
        budget -= forLeft;
        budget += buildNode(std::move(left.references), pair, depth + 1, forLeft);
        return buildNode(std::move(right.references), pair + 1, depth + 1, budget);
    }

    /// False if the references are better left in one leaf.
    bool divide(References& references, const Aabb& box, int depth, uint64_t budget, Side& left,
                Side& right) const {
        const auto count = uint32_t(references.size());
        if (count == 1) return false;
        const ItemCut items = bestItemCut(references);
        PlaneCut plane;
        if (budget > 0 && items.overlap > double(options_.minOverlap) * rootArea_)
            plane = planes_.best(references, box);
        const double area = areaOf(box);
        const double best = std::min(items.cost, plane.cost);
        if (count <= uint32_t(options_.maxLeafSize) &&
            !(double(options_.traversalCost) * area + double(options_.intersectionCost) * best <
              double(options_.intersectionCost) * area * count))
            return false;
        const double gainless = (1 - 1e-6) * area * count;
        if (plane.cost < items.cost && plane.cost < gainless) {
            planes_.cut(plane, references, left, right);
            const size_t l = left.references.size(), r = right.references.size();
            if (l > 0 && r > 0 && l + r - count <= budget &&
                rules_.fits(depth, uint32_t(l), uint32_t(r)))
                return true;
            left = right = {};
        }
        if (items.cost < gainless) {
            divideItems(items, references, left, right);
            if (rules_.fits(depth, uint32_t(left.references.size()),
                            uint32_t(right.references.size())))
                return true;
            left = right = {};
        }
        divideAtMedian(references, left, right);
        return true;
    }

    [[nodiscard]] ItemCut bestItemCut(const References& references) const {
        ItemCut result;
        Bins bins;
        int binCount = options_.bins;
        if (references.size() <= kExactSize) {
            binCount = int(references.size());
            rank(references, result.ranks);
            for (int i = 0; i < binCount; ++i) {
                bins.counts[i].fill(1);
                for (int axis = 0; axis < 3; ++axis)
                    bins.boxes[result.ranks[i][axis]][axis] = references[i].box();
            }
        } else {
            result.map = BinMap(boundsOf(references).centres, binCount);
            bins.clear(binCount);
            fillBins(references, result.map, bins);
        }
        const Split split = bins.best(binCount);
        if (split.axis < 0) return result;
        result.axis = split.axis;
        result.position = split.position;
        const Aabb left = aabbOf(bins.box(split.axis, 0, split.position));
        const Aabb right = aabbOf(bins.box(split.axis, split.position, binCount));
        result.cost = areaOf(left) * bins.count(split.axis, 0, split.position) +
                      areaOf(right) * bins.count(split.axis, split.position, binCount);
        result.overlap = areaOf({glm::max(left.min, right.min), glm::min(left.max, right.max)});
        return result;
    }

    static void divideItems(const ItemCut& cut, const References& references, Side& left,
                            Side& right) {
        for (size_t i = 0; i < references.size(); ++i) {
            int32_t place[4];
            if (references.size() <= kExactSize)
                std::copy_n(cut.ranks[i].begin(), 4, place);
            else
                store(place, cut.map(references[i].centre()));
            (place[cut.axis] < cut.position ? left : right).add(references[i]);
        }
    }

    /// By the widest axis of the centres, as the other builders do it.
    static void divideAtMedian(References& references, Side& left, Side& right) {
        Children halves;
        const auto count = uint32_t(references.size());
        vitrine::divideAtMedian({references.data(), nullptr, 0, count, 0, {}}, halves);
        for (const Reference& r : halves.left.span()) left.add(r);
        for (const Reference& r : halves.right.span()) right.add(r);
    }

    PlaneCutter planes_;
    BuildOptions options_;
    CutRules rules_{};
    double rootArea_ = 0;
    Bvh out_;
};

}  // namespace

Bvh buildSpatial(std::span<const glm::vec3> positions, std::span<const glm::uvec3> triangles,
                 std::vector<Reference> references, const BuildOptions& options) {
    return SpatialBuilder(positions, triangles, options).build(std::move(references));
}

}  // namespace vitrine
