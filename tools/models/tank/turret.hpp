// SPDX-License-Identifier: MIT
// The turret: a casting with cheeks for the mantlet, and what is on it.
#pragma once

#include "models/tank/assembly.hpp"

namespace vitrine::tank {

Assembly makeTurret();

// The stages of makeTurret, each in a file of its own.
void addTurretFittings(Assembly& turret);
void addTurretStowage(Assembly& turret);
void addMachineGun(Assembly& turret, const Mat4& pintle);

}  // namespace vitrine::tank
