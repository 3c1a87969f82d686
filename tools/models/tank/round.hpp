// SPDX-License-Identifier: MIT
// Round bodies: turned on a lathe, bent from tube, or drawn as a skin over ribs; and small
// hardware.
#pragma once

#include "models/tank/solid.hpp"

namespace vitrine::tank {

enum class Axis { kX, kY, kZ };

struct Lathe {
    Axis axis = Axis::kY;
    int segments = 16;
    double bevel = 0.004;  ///< where it stands out by over 30 degrees; the rest is smooth or sharp
    bool ring = false;     ///< the profile is closed and does not touch the axis
    Material material = Material::kPaint;
};

/// The profile's points are (along the axis, radius). It runs towards the axis's positive end where
/// it is outside.
Solid turnedOnLathe(const std::vector<Vec2>& profile, const Lathe& how);

struct Tube {
    double radius = 0.01;
    int sides = 6;
    bool loop = false;
    Material material = Material::kPaint;
    bool open = false;  ///< without lids, if both ends are inside of something
};

/// With flat ends.
Solid bentTube(const std::vector<Vec3>& path, const Tube& how);

/// The same path with its corners rounded, in `steps` straight pieces each.
std::vector<Vec3> rounded(const std::vector<Vec3>& path, double radius, int steps = 3,
                          bool loop = false);

/// A smooth surface over closed rings of as many points each. The first and last ring may be one
/// point, repeated; otherwise they end in flat lids.
Solid skinned(const std::vector<std::vector<Vec3>>& rings, Material material);

/// Stands on y = 0.
Solid hexBolt(double radius, double height, Material material);
/// Half a flattened ball on y = 0.
Solid rivet(double radius, Material material);
/// A bar of `length` along x on two feet, `height` above y = 0.
Solid handle(double length, double height, double radius, Material material);

}  // namespace vitrine::tank
