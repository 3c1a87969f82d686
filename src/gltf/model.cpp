// SPDX-License-Identifier: MIT
#include "gltf/model.hpp"

#include <cmath>

namespace vitrine {

glm::mat3 uvFromMeshUv(const GltfTextureInfo& info) {
    // Positive angles turn from +u to -v of glTF, whose v points down: counter-clockwise. The
    // matrix printed in the extension's text has the other sign (KhronosGroup/glTF#1563).
    const float c = std::cos(info.rotation), s = std::sin(info.rotation);
    const glm::mat3 translation(1, 0, 0, 0, 1, 0, info.offset.x, info.offset.y, 1);
    const glm::mat3 rotation(c, -s, 0, s, c, 0, 0, 0, 1);
    const glm::mat3 scale(info.scale.x, 0, 0, 0, info.scale.y, 0, 0, 0, 1);
    const glm::mat3 flip(1, 0, 0, 0, -1, 0, 0, 1, 1);
    return flip * translation * rotation * scale * flip;
}

}  // namespace vitrine
