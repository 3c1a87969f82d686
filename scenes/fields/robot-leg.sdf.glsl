// SPDX-License-Identifier: MIT
// One leg of the robot: the origin is the hip, the sole stands at y = -0.62 when the knee is
// straight. A negative scale along x makes the other one.
// bounds[-0.22, -0.84, -0.82,  0.22, 0.50, 0.86]
// parts[shell, trim, metal]
uniform float hip;   // slider[-60.0, 0.0, 90.0] The thigh swings forward, degrees
uniform float knee;  // slider[0.0, 0.0, 120.0] Bend of the knee, degrees
uniform float foot;  // slider[-40.0, 0.0, 40.0] The toes go up, degrees

vec2 turned(vec2 v, float degrees) {
    float a = radians(degrees);
    return mat2(cos(a), -sin(a), sin(a), cos(a)) * v;
}

void take(inout vec2 nearest, float d, float part) {
    if (d < nearest.x) nearest = vec2(d, part);
}

vec2 sdf(vec3 p) {
    vec3 t = p;
    t.zy = turned(t.zy, hip);
    vec2 nearest = vec2(sdCapsule(t, vec3(0.0), vec3(0.0, -0.2, 0.0), 0.062), 1.0);
    vec3 r = t + vec3(0.0, 0.135, 0.0);
    r.y -= 0.042 * clamp(floor(r.y / 0.042 + 0.5), -1.0, 1.0);
    take(nearest, sdTorus(r, 0.060, 0.021), 1.0);
    take(nearest, length(t + vec3(0.0, 0.225, 0.0)) - 0.086, 2.0);

    vec3 s = t + vec3(0.0, 0.225, 0.0);
    s.zy = turned(s.zy, -knee);
    take(nearest, sdRoundCone(s + vec3(0.0, 0.26, 0.0), 0.130, 0.092, 0.17), 0.0);
    take(nearest, sdTorus(s + vec3(0.0, 0.285, 0.0), 0.118, 0.022), 2.0);

    // The boot: half an egg on a dark sole.
    vec3 f = s + vec3(0.0, 0.30, 0.0);
    f.zy = turned(f.zy, foot);
    vec3 e = f + vec3(0.0, 0.065, -0.075);
    float egg = (length(e / vec3(0.150, 0.150, 0.215)) - 1.0) * 0.150;
    take(nearest, opSmoothIntersection(egg, -0.065 - f.y, 0.03), 0.0);
    vec2 w = vec2((length(e.xz / vec2(0.158, 0.222)) - 1.0) * 0.158, abs(f.y + 0.0775) - 0.0175);
    w += 0.012;
    take(nearest, length(max(w, 0.0)) + min(max(w.x, w.y), 0.0) - 0.012, 1.0);
    return nearest;
}
