// SPDX-License-Identifier: MIT
#include "pass/visibility_fields.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba32ui) uniform writeonly uimage2D outRecord;
#if COUNTERS
layout(rgba32ui) uniform writeonly uimage2D outCounters;
#endif

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, frame.image.xy))) return;
    imageStore(outRecord, pixel, visibilityFieldsPass(pixel));
#if COUNTERS
    imageStore(outCounters, pixel, visibilityFieldsCounters(pixel));
#endif
}
