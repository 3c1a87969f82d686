// SPDX-License-Identifier: MIT
// The robot's face: two eyes of light and a mouth behind dark glass. Where it looks and how far its
// eyes are open are parameters, so that the scene moves them.
uniform vec3 light;       // color[0.25, 0.95, 1.0] Eyes
uniform float glow;       // slider[0.0, 3.0, 10.0] Their brightness
uniform vec2 look;        // slider[(-1, -1), (0, 0), (1, 1)] Where it looks
uniform float open;       // slider[0.0, 1.0, 1.0] How far the eyes are open
uniform float happiness;  // slider[0.0, 0.35, 1.0] From round eyes to laughing ones

const vec2 middle = vec2(0.0, 0.42);     // of the glass on the head's front
const vec2 halfSize = vec2(0.37, 0.26);  // of the glass

float pill(vec2 p, vec2 halfLength) {
    float radius = min(halfLength.x, halfLength.y);
    return sd2RoundedBox(p, halfLength, radius);
}

// An arc of a circle about the origin, open downwards.
float arc(vec2 p, float radius, float width, float opening) {
    float a = clamp(atan(p.x, p.y), -opening, opening);
    return length(p - radius * vec2(sin(a), cos(a))) - width;
}

void material(inout Surface s) {
    // Of the face: -1 to 1 across the glass. Fields have no coordinates of their own.
    vec2 uv = (s.localPosition.xy - middle) / halfSize;
    // Drawn in metres, or eyes would be stretched with the glass.
    vec2 face = uv * halfSize;
    vec2 p = face - vec2(0.045, 0.03) * look - vec2(0.0, 0.03);
    p.x = abs(p.x) - 0.15;
    float roundEye = pill(p, vec2(0.062, max(0.095 * open, 0.007)));
    float laugh = arc(p + vec2(0.0, 0.05), 0.065, 0.020, 1.3);
    float eye = mix(roundEye, laugh, smoothstep(0.45, 0.75, happiness));
    vec2 m = face + vec2(0.0, 0.085) - vec2(0.03, 0.02) * look;
    float mouth = arc(vec2(m.x, -m.y), 0.055 + 0.02 * happiness, 0.011, 0.5 + 0.7 * happiness);
    float shape = min(eye, mouth);
    float width = max(s.footprint, 0.0015);
    float inside = smoothstep(width, -width, shape);
    // Lines of a display, and the light that scatters in the glass.
    float lines = 0.86 + 0.14 * smoothstep(-0.4, 0.4, sin(face.y * 420.0)) * smoothstep(0.006, 0.002, s.footprint);
    float halo = 0.10 * exp(-max(shape, 0.0) * 22.0);
    s.emission = light * glow * (inside * lines + halo);
}
