// SPDX-License-Identifier: MIT
// The track: where its pins are, for any distance driven, and what a link looks like.
//
// The pins lie on a closed curve around sprocket, road wheels, idler and return rollers. Between
// the upper supports the track hangs as a catenary, with the same horizontal pull in every span
// (y'' = cosh, Bernoulli and Leibniz 1691). Links are rigid: pins are equal *chords* apart, and the
// pitch is solved so that a whole number of links closes the curve exactly.
#pragma once

#include <vector>

#include "models/tank/solid.hpp"

namespace vitrine::tank {

/// From pin to pin around the whole track, clockwise seen from the right: ahead along the top.
/// `drive` is how far the tank has come, in metres.
std::vector<Vec2> trackPins(double drive);

/// How far the tank drives until every link is where the next one was, in metres.
double trackPitch();

/// Places of the links of the right track (side = 1) or the left one (side = -1).
std::vector<Mat4> linkPlaces(const std::vector<Vec2>& pins, double side);

/// The angle about z at which a tooth of the sprocket stands between two pins.
double sprocketAngle(const std::vector<Vec2>& pins);

/// x from pin to pin, y away from the wheels, z across; the origin is between the pins.
Solid makeLink();

}  // namespace vitrine::tank
