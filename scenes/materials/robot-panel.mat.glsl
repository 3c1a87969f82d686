// SPDX-License-Identifier: MIT
// The panel on the robot's chest: a beating line, three lamps and a row of keys. All of it begins
// again after 8 seconds.
uniform vec3 line;  // color[0.35, 1.0, 0.55] The line
uniform float glow;  // slider[0.0, 2.5, 10.0] Its brightness

float box(vec2 p, vec2 size, float r) {
    vec2 q = abs(p) - size + r;
    return length(max(q, 0.0)) + min(max(q.x, q.y), 0.0) - r;
}

void material(inout Surface s) {
    vec2 uv = s.localPosition.xy - vec2(0.0, 0.41);
    float width = max(s.footprint, 0.001);
    s.baseColor = vec3(0.045, 0.05, 0.06);
    s.roughness = 0.35;

    // A screen with a heart beat that runs across it.
    vec2 q = uv - vec2(-0.045, 0.02);
    float screen = smoothstep(width, -width, box(q, vec2(0.095, 0.062), 0.012));
    float x = q.x * 22.0 + 3.0 * time;
    float beat = exp(-abs(mod(x, 4.0) - 2.0) * 7.0) * cos(9.0 * (mod(x, 4.0) - 2.0));
    float height = abs(q.y - 0.036 * beat) - 0.0022;
    float fade = 0.35 + 0.65 * fract(q.x * 2.6 - 0.5 * time);
    s.baseColor = mix(s.baseColor, vec3(0.01, 0.018, 0.016), screen);
    s.roughness = mix(s.roughness, 0.08, screen);
    s.emission = screen * line * glow *
                 (fade * smoothstep(width, -width, height) + 0.02 + 0.15 * exp(-max(height, 0.0) * 130.0));

    // Lamps, one after the other.
    vec2 l = uv - vec2(0.108, 0.02);
    float index = clamp(floor(l.y / 0.045 + 0.5), -1.0, 1.0);
    l.y -= 0.045 * index;
    float lamp = smoothstep(width, -width, length(l) - 0.0145);
    vec3 hue = index < -0.5 ? vec3(0.2, 0.7, 1.0) : index < 0.5 ? vec3(1.0, 0.7, 0.15) : vec3(1.0, 0.2, 0.12);
    float on = 0.25 + 0.75 * smoothstep(0.5, 0.9, 0.5 + 0.5 * sin(radians(135.0 * time + 120.0 * index)));
    s.emission += lamp * hue * glow * on;

    // Keys.
    vec2 k = uv - vec2(-0.0, -0.075);
    k.x -= 0.052 * clamp(floor(k.x / 0.052 + 0.5), -2.0, 2.0);
    float key = smoothstep(width, -width, box(k, vec2(0.019, 0.011), 0.005));
    s.baseColor = mix(s.baseColor, vec3(0.75, 0.72, 0.66), key);
}
