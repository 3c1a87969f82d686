// SPDX-License-Identifier: MIT
#include "pass/layers.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba32ui) uniform writeonly uimage2D outIds;
layout(rgba32f) uniform writeonly image2D outAlbedo;
layout(rgba32f) uniform writeonly image2D outNormal;

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, frame.image.xy))) return;
    Layers layers = layersPass(pixel);
    imageStore(outIds, pixel, layers.ids);
    imageStore(outAlbedo, pixel, layers.albedo);
    imageStore(outNormal, pixel, layers.normal);
}
