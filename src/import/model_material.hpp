// SPDX-License-Identifier: MIT
// A model's material as a scene's.
#pragma once

#include <functional>
#include <memory>

#include "gltf/model.hpp"
#include "scene/scene.hpp"

namespace vitrine {

/// Pixels of image number i of the model; never null.
using PictureSource = std::function<std::shared_ptr<const ImageRgba8>(int)>;

/// Every field but the name. `material` kNoIndex: the specification's default, a white metal.
/// Photometric units are taken as they are: emission 1 is radiance 1.
Material materialOf(const GltfModel& model, int material, const PictureSource& pictureOf);

/// True if a texture of the material lies on the second texture coordinates.
bool usesSecondUvs(const GltfMaterial& material);

}  // namespace vitrine
