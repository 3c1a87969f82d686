// SPDX-License-Identifier: MIT
// A thin lens in the place of the pinhole: rays that leave it anywhere meet again where it is in focus
// (Cook, Porter & Carpenter, Distributed Ray Tracing, SIGGRAPH 1984).
#include "scene/frame.glsl"

// Evenly over the unit disc (Shirley & Chiu, A Low Distortion Map Between Disk and Square, 1997).
vec2 pointOnDisc(vec2 u) {
    vec2 p = 2.0 * u - 1.0;
    bool wide = abs(p.x) > abs(p.y);
    float r = wide ? p.x : p.y;
    float ratio = r == 0.0 ? 0.0 : (wide ? p.y : p.x) / r;
    float angle = 0.25 * kPi * ratio;
    return r * (wide ? vec2(cos(angle), sin(angle)) : vec2(sin(angle), cos(angle)));
}

// Evenly over the regular polygon with its corners on the unit circle, one at the top.
vec2 pointOnPolygon(vec2 u, float corners) {
    float sector = u.x * corners;
    float root = sqrt(u.y);
    float along = root * fract(sector);
    float turn = 2.0 * kPi / corners;
    float angle = 0.5 * kPi + turn * floor(sector);
    vec2 a = vec2(cos(angle), sin(angle));
    vec2 b = vec2(cos(angle + turn), sin(angle + turn));
    return (root - along) * a + along * b;
}

// The ray from a point of the lens, chosen by `u`, to where the ray through its middle is in focus.
Ray throughLens(Ray middle, vec2 u) {
    vec2 p = frame.lens.z > 0.0 ? pointOnPolygon(u, frame.lens.z) : pointOnDisc(u);
    p *= frame.lens.x;
    vec3 offset = p.x * normalize(frame.cameraRight.xyz) + p.y * normalize(frame.cameraUp.xyz);
    float along = frame.lens.y / dot(middle.direction, frame.cameraForward.xyz);
    return Ray(middle.origin + offset, normalize(along * middle.direction - offset), middle.radius);
}
