// SPDX-License-Identifier: MIT
// An ammonite as tall as a person: a ribbed spiral shell with a flared, thick-lipped opening.
#pragma once

#include "mesh/mesh.hpp"

namespace vitrine {

/// Closed, 1.6 m tall, standing on y = 0 and centred on x = z = 0; the spiral lies in the xy plane
/// and opens towards +x. Parts: "shell" (outside), "lip", "chamber" (inside).
Mesh makeAmmonite();

}  // namespace vitrine
