// SPDX-License-Identifier: MIT
// Counters of one pixel, carried from pass to pass within a sample.
//   x: most loop iterations of one pass; y: nodes and triangles visited; z: field evaluations;
//   w: shadow rays in the low, bounce rays in the high 16 bits
#include "scene/frame.glsl"
#if COUNTERS
uniform usampler2D countersBefore;

uvec4 addCounters(uvec4 before, uint unitOfRays) {
    return uvec4(max(before.x, uint(takenLoops)), before.y + uint(countedNodes),
                 before.z + uint(countedSteps), before.w + unitOfRays * uint(countedRays));
}
#endif
