// SPDX-License-Identifier: MIT
// What is the same for every pixel of a pass.
#include "shared/limits.glsl"
#include "lib/math.glsl"

layout(std140) uniform FrameBlock {
#include "shared/frame_fields.glsl"
} frame;

// Every loop asks this before each iteration: all loops of an invocation share VITRINE_LOOP_BUDGET.
// It comes as a uniform, so that no compiler takes it for a bound to unroll to.
int takenLoops = 0;
bool mayLoop() {
    takenLoops++;
    return takenLoops <= frame.counts.w;
}

#if COUNTERS
int countedNodes = 0;
int countedSteps = 0;
int countedRays = 0;
#define COUNT(counter) counter++
#else
#define COUNT(counter)
#endif

// The ray through the middle of the lens and a point of the image plane; x, y in pixels from the lower left.
Ray cameraRay(vec2 position) {
    vec2 p = 2.0 * position / vec2(frame.image.xy) - 1.0;
    vec3 direction = frame.cameraForward.xyz + p.x * frame.cameraRight.xyz + p.y * frame.cameraUp.xyz;
    return Ray(frame.cameraEye.xyz, normalize(direction), 0.0);
}
