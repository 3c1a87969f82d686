// SPDX-License-Identifier: MIT
// The running mean of the samples: exact for one sample, and never larger than they are.
#include "scene/frame.glsl"

uniform sampler2D radiance;
uniform sampler2D meanBefore;

vec4 accumulatePass(ivec2 pixel) {
    vec4 value = texelFetch(radiance, pixel, 0);
    // One broken sample must not blacken the pixel for good.
    if (any(isnan(value)) || any(isinf(value))) value = vec4(0.0, 0.0, 0.0, 1.0);
    if (frame.sampling.x == 0) return value;
    vec4 before = texelFetch(meanBefore, pixel, 0);
    return before + (value - before) / float(frame.sampling.x + 1);
}
