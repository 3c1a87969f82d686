// SPDX-License-Identifier: MIT
#include "pass/probe_field.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba32f) uniform writeonly image2D outValue;
layout(rgba32f) uniform writeonly image2D outGradient;

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, frame.image.xy))) return;
    FieldProbe probe = probeFieldPass(pixel);
    imageStore(outValue, pixel, probe.value);
    imageStore(outGradient, pixel, probe.gradient);
}
