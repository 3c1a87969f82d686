// SPDX-License-Identifier: MIT
// The upper hull: armour, fenders, engine deck, and everything fastened to them.
#pragma once

#include "models/tank/assembly.hpp"

namespace vitrine::tank {

Assembly makeHull();

/// A point on the glacis: metres down the slope from the roof's edge, and metres to the right.
Vec3 onGlacis(double down, double z);
/// Its directions outwards and down the slope.
Vec3 glacisOut();
Vec3 glacisDown();

// The stages of makeHull, each in a file of its own.
void addEngineDeck(Assembly& hull);
void addHullFittings(Assembly& hull);
void addHullStowage(Assembly& hull);

}  // namespace vitrine::tank
