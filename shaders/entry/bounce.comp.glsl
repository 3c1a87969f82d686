// SPDX-License-Identifier: MIT
#include "pass/bounce.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba32ui) uniform writeonly uimage2D outRecord;
layout(rgba32f) uniform writeonly image2D outOrigin;
layout(rgba32f) uniform writeonly image2D outDirection;
layout(rgba32f) uniform writeonly image2D outThroughput;
#if COUNTERS
layout(rgba32ui) uniform writeonly uimage2D outCounters;
#endif

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, frame.image.xy))) return;
    Bounce bounce = bouncePass(pixel);
    imageStore(outRecord, pixel, bounce.record);
    imageStore(outOrigin, pixel, bounce.origin);
    imageStore(outDirection, pixel, bounce.direction);
    imageStore(outThroughput, pixel, bounce.throughput);
#if COUNTERS
    imageStore(outCounters, pixel, bounceCounters(pixel));
#endif
}
