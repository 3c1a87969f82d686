// SPDX-License-Identifier: MIT
// What is the same for every pixel of a pass.
#include "shared/limits.glsl"
#include "lib/math.glsl"

layout(std140) uniform FrameBlock {
#include "shared/frame_fields.glsl"
} frame;

// Every loop asks this, so that no compiler can unroll it and that the passes can be held far below
// the 65,535 iterations after which llvmpipe ends all loops of an invocation.
#if COUNTERS
int countedLoops = 0;
int countedNodes = 0;
int countedSteps = 0;
int countedRays = 0;
#define COUNT(counter) counter++
#else
#define COUNT(counter)
#endif

// The camera ray through a point of the image plane; x, y in pixels from the lower left.
Ray cameraRay(vec2 position) {
    vec2 p = 2.0 * position / vec2(frame.image.xy) - 1.0;
    vec3 direction = frame.cameraForward.xyz + p.x * frame.cameraRight.xyz + p.y * frame.cameraUp.xyz;
    return Ray(frame.cameraEye.xyz, normalize(direction), 0.0);
}
