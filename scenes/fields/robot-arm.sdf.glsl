// SPDX-License-Identifier: MIT
// One arm of the robot: the origin is the shoulder, it hangs along -y, the palm turns to +z.
// A negative scale along x makes the other one.
// bounds[-0.40, -0.90, -0.26,  0.40, 0.52, 0.80]
// parts[shell, trim, metal]
uniform float elbow;  // slider[0.0, 25.0, 140.0] Bend of the elbow, degrees
uniform float grip;   // slider[0.0, 35.0, 90.0] Curl of the fingers, degrees
uniform float twist;  // slider[-90.0, 0.0, 90.0] Turn of the forearm, degrees
uniform float wave;   // slider[-40.0, 0.0, 40.0] The forearm waves to the one side and the other, degrees

vec2 turned(vec2 v, float degrees) {
    float a = radians(degrees);
    return mat2(cos(a), -sin(a), sin(a), cos(a)) * v;
}

void take(inout vec2 nearest, float d, float part) {
    if (d < nearest.x) nearest = vec2(d, part);
}

vec2 sdf(vec3 p) {
    vec2 nearest = vec2(length(p) - 0.125, 0.0);
    // Upper arm: a tube with rings.
    float tube = sdCapsule(p, vec3(0.0), vec3(0.0, -0.26, 0.0), 0.052);
    vec3 r = p + vec3(0.0, 0.18, 0.0);
    r.y -= 0.038 * clamp(floor(r.y / 0.038 + 0.5), -1.0, 1.0);
    take(nearest, min(tube, sdTorus(r, 0.050, 0.019)), 1.0);
    take(nearest, length(p + vec3(0.0, 0.29, 0.0)) - 0.078, 2.0);

    // The forearm's frame: bent at the elbow, turned about itself.
    vec3 q = p + vec3(0.0, 0.29, 0.0);
    q.zy = turned(q.zy, elbow + wave);
    q.xz = turned(q.xz, twist);
    q = vec3(q.x, -q.y, q.z);
    take(nearest, sdRoundCone(q - vec3(0.0, 0.075, 0.0), 0.080, 0.112, 0.16), 0.0);
    take(nearest, sdTorus(q - vec3(0.0, 0.325, 0.0), 0.078, 0.024), 2.0);

    // Hand: a palm and three fingers with a thumb, curled about the knuckles.
    vec3 h = q - vec3(0.0, 0.385, 0.0);
    float palm = length(vec3(h.x, h.y, h.z / 0.8)) * 0.8 - 0.062;
    palm = opSmoothUnion(palm, sdCapsule(h, vec3(-0.035, 0.04, 0.0), vec3(0.035, 0.04, 0.0), 0.045), 0.04);
    vec3 f = h - vec3(0.0, 0.075, 0.0);
    f.zy = turned(f.zy, -grip);
    f.x -= 0.056 * clamp(floor(f.x / 0.056 + 0.5), -1.0, 1.0);
    float fingers = sdCapsule(f, vec3(0.0), vec3(0.0, 0.055, 0.0), 0.025);
    vec3 g = f - vec3(0.0, 0.06, 0.0);
    g.zy = turned(g.zy, -grip);
    fingers = min(fingers, sdCapsule(g, vec3(0.0), vec3(0.0, 0.04, 0.0), 0.024));
    vec3 thumbTip = vec3(-0.115, 0.055, 0.045);
    float thumb = sdCapsule(h, vec3(-0.05, 0.0, 0.02), thumbTip, 0.026);
    take(nearest, opSmoothUnion(palm, min(fingers, thumb), 0.02), 1.0);
    return nearest;
}
