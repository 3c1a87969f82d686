// SPDX-License-Identifier: MIT
// The robot's face: two eyes of light and a mouth behind dark glass, drawn on the plane of the
// face. It looks about, and blinks.
uniform vec3 light;       // color[0.25, 0.95, 1.0] Eyes
uniform float glow;       // slider[0.0, 3.0, 10.0] Their brightness
uniform vec2 look;        // slider[(-1, -1), (0, 0), (1, 1)] Where it looks
uniform float happiness;  // slider[0.0, 0.35, 1.0] From round eyes to laughing ones
uniform float idle;       // slider[0.0, 1.0, 1.0] How much it looks about and blinks by itself

float pill(vec2 p, vec2 size) {
    vec2 q = abs(p) - size + size.x;
    return length(max(q, 0.0)) + min(max(q.x, q.y), 0.0) - size.x;
}

// An arc of a circle about the origin, open downwards.
float arc(vec2 p, float radius, float width, float opening) {
    float a = clamp(atan(p.x, p.y), -opening, opening);
    return length(p - radius * vec2(sin(a), cos(a))) - width;
}

void material(inout Surface s) {
    vec2 uv = s.localPosition.xy - vec2(0.0, 0.42);
    // Glances last a second or two and are quick: steps with short ramps.
    float beat = time / 1.7;
    float step0 = floor(beat);
    float ramp = smoothstep(0.0, 0.12, beat - step0);
    vec2 before = vec2(sin(12.9 * step0 - 12.9), sin(7.1 * step0 - 7.1));
    vec2 after = vec2(sin(12.9 * step0), sin(7.1 * step0));
    vec2 gaze = look + idle * mix(before, after, ramp) * vec2(0.6, 0.35);
    float cycle = fract(time / 3.1) * 3.1;
    float lid = 1.0 - idle * (1.0 - smoothstep(0.0, 0.07, abs(cycle - 2.6)));
    lid = max(lid, 0.06);

    vec2 p = uv - vec2(0.045, 0.03) * gaze - vec2(0.0, 0.03);
    p.x = abs(p.x) - 0.15;
    float open = pill(vec2(p.x, p.y / lid), vec2(0.062, 0.095)) * lid;
    float laugh = arc(p + vec2(0.0, 0.05), 0.065, 0.020, 1.3);
    float eye = mix(open, laugh, smoothstep(0.45, 0.75, happiness));
    vec2 m = uv + vec2(0.0, 0.085) - vec2(0.03, 0.02) * gaze;
    float mouth = arc(vec2(m.x, -m.y), 0.055 + 0.02 * happiness, 0.011, 0.5 + 0.7 * happiness);
    float shape = min(eye, mouth);
    float width = max(s.footprint, 0.0015);
    float inside = smoothstep(width, -width, shape);
    // Lines of a display, and the light that scatters in the glass.
    float lines = 0.86 + 0.14 * smoothstep(-0.4, 0.4, sin(uv.y * 420.0)) * smoothstep(0.006, 0.002, s.footprint);
    float halo = 0.10 * exp(-max(shape, 0.0) * 22.0);
    s.emission = light * glow * (inside * lines + halo);
}
