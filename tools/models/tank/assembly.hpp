// SPDX-License-Identifier: MIT
// A mesh before it is one: parts, where they stand, and what is drawn on them.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "models/tank/marks.hpp"
#include "models/tank/solid.hpp"

namespace vitrine::tank {

enum class Finish : uint8_t {
    kPlain,
    kCast,   ///< rougher than plates
    kRolls,  ///< has no upper side that dust could settle on
};

/// A body with a place of its own in the texture. All its copies look at that same place.
struct Part {
    Solid solid;
    std::vector<Mat4> places{Mat4(1.0)};
    double density = 1.0;  ///< of texels along a line, against the other parts
    Finish finish = Finish::kPlain;
};

struct Assembly {
    std::string name;
    Vec3 origin;  ///< in the tank at rest
    std::vector<Part> parts;
    Marks marks;  ///< in the mesh's own coordinates

    void add(const Solid& solid, std::vector<Mat4> places = {Mat4(1.0)}, double density = 1.0,
             Finish finish = Finish::kPlain) {
        parts.push_back({solid, std::move(places), density, finish});
    }
};

}  // namespace vitrine::tank
