// SPDX-License-Identifier: MIT
// The tank's running gear as a scene that moves: meshes of one wheel of each kind and of one link,
// and the text of a scene file with a node and an animation for each of their copies.
//
// Every link only ever goes from its place to the next one's, then begins again: since all links
// look the same, the track runs. So the keys of a link are few, and the film never ends.
#pragma once

#include <string>
#include <vector>

#include "mesh/mesh.hpp"
#include "models/tank/assembly.hpp"
#include "models/tank/unwrap.hpp"

namespace vitrine::tank {

/// Metres a second that the animations are made for.
inline constexpr double kDriveSpeed = 1.0;

/// body (the chassis without what turns), road_wheel, return_roller, idler, sprocket, link; with
/// the texture coordinates of the whole chassis.
std::vector<Mesh> makeDriveMeshes(const Assembly& chassis, const Atlas& atlas);

/// A scene file to be included, in the folder of the meshes. It has the node "tank", which stands
/// still (whoever includes it moves it ahead), and under it "body" for all that is sprung. The
/// material "chassis" is the including scene's.
std::string driveScene();

}  // namespace vitrine::tank
