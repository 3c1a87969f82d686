// SPDX-License-Identifier: MIT
#include "pass/layers.glsl"

layout(location = 0) out uvec4 outIds;
layout(location = 1) out vec4 outAlbedo;
layout(location = 2) out vec4 outNormal;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    Layers layers = layersPass(pixel);
    outIds = layers.ids;
    outAlbedo = layers.albedo;
    outNormal = layers.normal;
}
