// SPDX-License-Identifier: MIT
// What each point of the tank looks like: camouflage, wear, dust, mud, rain, rust and soot.
#pragma once

#include <span>

#include "models/tank/marks.hpp"
#include "models/tank/relief.hpp"
#include "models/tank/solid.hpp"

namespace vitrine::tank {

/// A point, and what was found out about it.
struct SurfacePoint {
    Vec3 at;        ///< in the mesh's space
    Vec3 inTank;    ///< at rest
    Vec3 normal;    ///< at rest
    double height;  ///< over the ground; of what rolls, the mean over a turn
    Material material;
    bool camouflaged;      ///< false: one colour, for parts that come in many copies
    bool rolls;            ///< see Finish
    double edge;           ///< metres to the nearest outer edge
    double open, crevice;  ///< see Occlusion
    Marked marked;
    std::span<const Lettering> letterings;
};

struct Look {
    Vec3 colour;  ///< linear
    double roughness, metal;
    double lump;  ///< height of mud on the surface, metres
};

Look lookAt(const SurfacePoint& point);

}  // namespace vitrine::tank
