// SPDX-License-Identifier: MIT
// The pictures that belong to a mesh.
#pragma once

#include "image/image.hpp"
#include "models/tank/occlusion.hpp"

namespace vitrine::tank {

struct Textures {
    ImageRgba8 albedo;  ///< sRGB
    ImageRgba8 normal;  ///< tangent space as in glTF: x along u, y along v (upwards), z outwards
    ImageRgba8 orm;     ///< linear: occlusion, roughness, metalness, as in glTF
    ImageRgba8 glossMetal;  ///< linear: 1 - roughness, metalness, 0; an older packing
};

Textures makeTextures(const Assembly& assembly, const Atlas& atlas, const Occluder& occluder);

}  // namespace vitrine::tank
