// SPDX-License-Identifier: MIT
// The tank as meshes, for any distance driven.
//
// Chassis and hull have their origin on the ground in the middle of the tank; the turret's is in
// its ring, the gun's between its trunnions. A scene puts one on the other with `at` (layout.hpp
// has the numbers), and then turns the turret about y and the gun about z:
//
//     [[node]]                          [[node]]
//     name = "turret"                   name = "gun"
//     parent = "hull"                   parent = "turret"
//     at = [0.15, 1.62, 0]              at = [1.0, 0.39, 0]
//     rotate = [0, TRAVERSE, 0]         rotate = [0, 0, ELEVATION]
//
// Traverse is free all around, elevation goes from -6 to 18 degrees; over the engine deck no lower
// than -1, and at 180 and -1.3 degrees the barrel lies in its crutch.
// To drive, ask for the chassis again with another `drive` (trackPins is exact for any), keep the
// atlas, and move the nodes by the same distance along x. The track repeats after one pitch
// (track.hpp); drive.hpp makes a scene of that.
#pragma once

#include <vector>

#include "mesh/mesh.hpp"
#include "models/tank/assembly.hpp"
#include "models/tank/unwrap.hpp"

namespace vitrine::tank {

/// Side of the textures in texels.
inline constexpr int kTextureSide = 1024;

/// Chassis, hull, turret, gun. Only the chassis depends on `drive`, the metres driven, and of it
/// only places: every call has the same parts, so one atlas and one set of textures serves all.
std::vector<Assembly> makeTank(double drive = 0.0);

/// All copies of all parts in the assembly's own space; the materials are the mesh's parts.
Mesh toMesh(const Assembly& assembly, const Atlas& atlas);

}  // namespace vitrine::tank
