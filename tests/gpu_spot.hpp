// SPDX-License-Identifier: MIT
// A spot of light in a picture, by its moments: exact whatever the noise of single pixels.
#pragma once

#include <functional>

#include "base/math.hpp"

namespace vitrine::test {

struct Spot {
    double light = 0;
    glm::dvec2 middle{0}, variance{0};  ///< pixels
};

/// `light(x, y)`: of the pixels of a square picture.
inline Spot measureSpot(int side, const std::function<double(int, int)>& light) {
    Spot spot;
    glm::dvec2 squares(0);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const double here = light(x, y);
            const glm::dvec2 p(x, y);
            spot.light += here;
            spot.middle += here * p;
            squares += here * p * p;
        }
    spot.middle /= spot.light;
    spot.variance = squares / spot.light - spot.middle * spot.middle;
    return spot;
}

}  // namespace vitrine::test
