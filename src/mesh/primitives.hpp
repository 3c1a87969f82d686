// SPDX-License-Identifier: MIT
// Built-in shapes: closed (but for the plane), centred on the origin, with exact normals and
// pictures the right way up. Sizes must be positive and finite; counts are raised to the least
// that makes a solid.
#pragma once

#include "mesh/mesh.hpp"

namespace vitrine {

/// Each face shows the whole picture.
Mesh makeBox(const glm::vec3& halfExtents);

/// Latitude and longitude; `subdivisions` quads from pole to pole and twice as many around.
/// u runs eastwards, v from the south pole (0,-r,0) to the north pole.
Mesh makeSphere(float radius, int subdivisions = 48);

/// Two triangles in y = 0, facing +y. The picture's upper edge is at -z.
Mesh makePlane(float halfX, float halfZ);

/// Around the y axis: the tube's centre runs on a circle of `ringRadius`, in `segments` steps of
/// `sides` quads. `arc` degrees of it, from +x towards -z, with flat ends unless it is all of it.
Mesh makeTorus(float ringRadius, float tubeRadius, int segments = 96, int sides = 48,
               float arc = 360);

/// Along the y axis, with flat caps. The parts are "side", "top" and "bottom".
Mesh makeCylinder(float radius, float halfHeight, int segments = 64);

}  // namespace vitrine
