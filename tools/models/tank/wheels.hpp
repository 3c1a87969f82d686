// SPDX-License-Identifier: MIT
// Everything that turns: all have their axle along z and look outwards to +z. The origin is in the
// middle of the track's width.
#pragma once

#include "models/tank/solid.hpp"

namespace vitrine::tank {

/// A pair of dished discs with rubber tyres, the guide horns run between them.
Solid makeRoadWheel();
/// Two toothed rings on a drum; a tooth points along +x.
Solid makeSprocket();
Solid makeIdler();
Solid makeReturnRoller();

}  // namespace vitrine::tank
