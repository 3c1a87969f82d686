// SPDX-License-Identifier: MIT
// The cheapest of nine cuts, by the surface area heuristic: along each axis the middle of the box,
// the median of the items, and the best cut between bins. Private to the builders.
#pragma once

#include "bvh/divide.hpp"

namespace vitrine {

class NineDivider {
  public:
    explicit NineDivider(const CutRules& rules) : rules_(rules) {}

    /// False if the range is better left whole.
    bool operator()(const Range& range, Children& out) const;

  private:
    bool divideLarge(const Range& range, Children& out) const;

    CutRules rules_;
};

}  // namespace vitrine
