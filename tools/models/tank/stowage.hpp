// SPDX-License-Identifier: MIT
// What hangs on a tank: boxes, cans, tools, hooks, lamps. Each stands on y = 0 with its middle
// above the origin and is longest along x.
#pragma once

#include "models/tank/solid.hpp"

namespace vitrine::tank {

/// A sheet-metal box with lid, latches at +z and handles at its ends.
Solid makeBin(const Vec3& size);
/// 20 litres; the spout is at +x.
Solid makeJerryCan();
/// Canvas rolled up, with two straps.
Solid makeTarpaulin(double length, double radius);
/// Lies on y = 0, blade towards +x.
Solid makeShovel();
Solid makeAxe();
Solid makeCrowbar();
/// Looks to +x, on a stalk, within a cage of bars.
Solid makeHeadlamp();
/// An open hook with its bolted foot, opening towards +x.
Solid makeTowHook();
/// A block with a slanted window that looks to +x.
Solid makePeriscope();
/// A round lid with handle and hinge (at -x).
Solid makeHatch(double radius);

}  // namespace vitrine::tank
