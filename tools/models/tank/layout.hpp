// SPDX-License-Identifier: MIT
// Where everything of the tank is, in metres. x is ahead, y up, z to the right; the tank stands on
// y = 0 and its middle is x = z = 0. The vehicle is an invention: a medium tank as one might have
// drawn it about 1950.
#pragma once

#include <array>

#include "models/tank/solid.hpp"

namespace vitrine::tank {

// Turret and gun have their origins where they turn; chassis and hull stand at the tank's origin.
inline constexpr Vec3 kTurretInHull{0.15, 1.62, 0.0};  // turns about y; positive is to the left
inline constexpr Vec3 kGunInTurret{1.00, 0.39, 0.0};   // turns about z; positive is upwards

// Running gear of one side; the other is its mirror image.
inline constexpr double kTrackZ = 1.34;  // of the middle of the track
inline constexpr double kTrackHalfWidth = 0.285;
inline constexpr double kPitch = 0.165;        // from pin to pin, before the track is closed
inline constexpr double kLinkInside = 0.028;   // from the pins to the face that wheels roll on
inline constexpr double kLinkOutside = 0.045;  // from the pins to the ground
inline constexpr double kWheelRadius = 0.40;
inline constexpr double kWheelY = kLinkOutside + kLinkInside + kWheelRadius;
inline constexpr std::array kWheelX = {2.10, 1.24, 0.38, -0.48, -1.34, -2.20};
inline constexpr int kSprocketTeeth = 12;
inline constexpr double kSprocketRadius = 0.3188;  // of the circle that the pins lie on
inline constexpr Vec2 kSprocketAt{-2.98, 0.74};
inline constexpr double kIdlerRadius = 0.31;
inline constexpr Vec2 kIdlerAt{2.94, 0.72};
inline constexpr double kRollerRadius = 0.125;
inline constexpr double kRollerY = 0.895;
inline constexpr std::array kRollerX = {1.67, -0.05, -1.77};
inline constexpr double kSag = 0.070;  // of the track, between the rollers

// The hull's outline.
inline constexpr double kTubHalfWidth = 0.97;
inline constexpr double kBelly = 0.43;
inline constexpr double kFenderY = 1.165;
inline constexpr double kFenderZ = 1.68;  // its outer edge
inline constexpr double kRoofY = 1.62;
inline constexpr double kNoseX = 3.24, kNoseY = 0.95;
inline constexpr double kGlacisDegrees = 31.0;  // from the horizontal
inline constexpr double kRearX = -3.08;

}  // namespace vitrine::tank
