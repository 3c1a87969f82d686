// SPDX-License-Identifier: MIT
// The lower hull with all that drives and carries the tank.
#pragma once

#include "models/tank/assembly.hpp"

namespace vitrine::tank {

/// As it is after `drive` metres straight ahead: wheels and tracks have moved, the origin has not.
/// The last five parts are what turns: road wheels, return rollers, idlers, sprockets, links.
Assembly makeChassis(double drive);

}  // namespace vitrine::tank
