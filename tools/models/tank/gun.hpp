// SPDX-License-Identifier: MIT
// The gun with its mantlet, which elevates with it. The origin is between the trunnions.
#pragma once

#include "models/tank/assembly.hpp"

namespace vitrine::tank {

Assembly makeGun();

}  // namespace vitrine::tank
