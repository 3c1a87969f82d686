// SPDX-License-Identifier: MIT
// What a shadow ray may ask of fields besides whether it hits them. A distance tells more than yes or
// no, and costs nothing more to ask for:
//
// - a penumbra from one ray: how near does it pass, against the width of the light there? The smallest
//   ratio is the share of light (Quilez, Free Penumbra Shadows, 2010; the nearest place between two
//   steps after Aaltonen, GPU-based Clay Simulation and Ray-tracing Tech in Claybook, GDC 2018);
// - occlusion from five taps along the normal: where there is nothing, the distance is the way from
//   the surface (Evans, Fast Approximations for Global Illumination on Dynamic Scenes, SIGGRAPH 2006).
//
// Both must visit what the ray passes, so boxes grow by the cone's radius; and both take the fields of
// all instances as if they were one: the nearest counts. Meshes have no distance: they block a cone
// when its middle hits them, and no tap sees them.
#include "scene/fetch.glsl"

const int kAskHit = 0;
const int kAskPenumbra = 1;
const int kAskTaps = 2;
const float kTaps = 5.0;

// Set by passes before they trace.
int coneAsks = kAskHit;
float coneSlope = 0.0;  // penumbra: the cone's radius for each metre of its length
int coneOwner = -1;     // taps: the instance that the ray starts on

// Answers of trace().
float coneClear = 1.0;  // the smallest distance to a field, over the radius of the cone there
vec4 tapsNear;          // taps: distances to the nearest field, at the first four
float tapsLast;         // and the last
float tapsReach;

float coneSpread() {
    return coneAsks == kAskTaps ? 1.0 : coneAsks == kAskPenumbra ? coneSlope : 0.0;
}

// The largest radius of a cone of length tMax where it is near something; `farthest`: of that
// something's points from the ray's origin.
float coneRadius(float spread, float farthest, float tMax) {
    return spread * min(farthest / max(1.0 - spread, 0.05), tMax);
}

// By which a field's box grows, in object space.
vec3 coneMargin(Instance instance, vec3 origin, vec3 direction, float tMax) {
    vec3 far = max(abs(instance.boxMin - origin), abs(instance.boxMax - origin));
    float radius = coneRadius(coneSpread(), length(far) / length(direction), tMax);
    return radius * vec3(length(instance.objectFromWorld[0].xyz),
                         length(instance.objectFromWorld[1].xyz),
                         length(instance.objectFromWorld[2].xyz));
}

float distanceToBox(vec3 p, vec3 boxMin, vec3 boxMax) {
    return length(max(max(boxMin - p, p - boxMax), 0.0));
}

void openCone(float tMax) {
    coneClear = 1.0;
    tapsNear = vec4(tMax);
    tapsLast = tMax;
    tapsReach = tMax;
}

// A field is `distance` away at t. The step before was from a place where it was `lastDistance` away,
// 0 if there is none: what both spheres touch lies beside where they intersect.
void passNear(float distance, float t, float lastDistance, float lastStep) {
    float back = (distance * distance - lastDistance * lastDistance + lastStep * lastStep) /
                 max(2.0 * lastStep, 1.0e-20);
    bool between = lastStep > 0.0 && back > 0.0 && back < lastStep;
    float nearest = between ? sqrt(max(distance * distance - back * back, 0.0)) : distance;
    float radius = coneSlope * max(between ? t - back : t, 1.0e-6);
    coneClear = min(coneClear, nearest / radius);
}

float penumbraShare() {
    return coneAsks == kAskPenumbra ? smoothstep(0.0, 1.0, coneClear) : 1.0;
}

// Way along the ray to look at number `step`: 0 and 1 measure the slope of the field that the ray
// starts on, `apart`; then come the taps, evenly over the reach.
float tapPlace(int step, float apart, float reach) {
    return step == 0 ? 0.0 : step == 1 ? apart : reach * float(step - 1) / kTaps;
}
const int kTapSteps = 7;

void takeTap(int tap, float distance) {
    bvec4 chosen = equal(ivec4(tap), ivec4(0, 1, 2, 3));
    tapsNear = mix(tapsNear, min(tapsNear, distance), vec4(chosen));
    tapsLast = tap == 4 ? min(tapsLast, distance) : tapsLast;
}

// The share of ambient light that is held back. The weights are those for which a wall beside a floor
// occludes it as much as it occludes rays of the same reach, within 0.03 whatever the distance to the
// wall; inside of a solid a tap counts up to twice, so that what lies below a block is dark.
float tapOcclusion() {
    vec4 near = clamp(1.0 - tapsNear / (tapsReach * vec4(1.0, 2.0, 3.0, 4.0) / kTaps), 0.0, 2.0);
    float last = clamp(1.0 - tapsLast / tapsReach, 0.0, 2.0);
    return min(dot(near, vec4(0.03, 0.05, 0.07, 0.12)) + 0.26 * last, 1.0);
}
