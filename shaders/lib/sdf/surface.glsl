// SPDX-License-Identifier: MIT
// Minimal surfaces that repeat for ever, as sheets: the known sums of sines and cosines, divided by
// their largest slope. `period` is the edge of their cube; the sheet is at least 2 `halfThickness`
// thick. The slopes were found by search over a cube; the test searches again.

// The gyroid: sin x cos y + sin y cos z + sin z cos x = 0.
// Source: Schoen, Infinite Periodic Minimal Surfaces without Self-Intersections, NASA 1970.
// bound
// lipschitz[1.0]
// example[opIntersection(sdGyroid(p, 0.8, 0.03), sdSphere(p, 0.8))]
float sdGyroid(vec3 p, float period, float halfThickness) {
    float frequency = 6.28318530718 / period;
    vec3 q = frequency * p;
    return abs(dot(sin(q), cos(q.yzx))) / (1.7320509 * frequency) - halfThickness;
}

// Schwarz' surface P: cos x + cos y + cos z = 0.
// Source: Schwarz, Gesammelte Mathematische Abhandlungen, 1890.
// bound
// lipschitz[1.0]
// example[opIntersection(sdSchwarzP(p, 0.8, 0.03), sdSphere(p, 0.8))]
float sdSchwarzP(vec3 p, float period, float halfThickness) {
    float frequency = 6.28318530718 / period;
    vec3 c = cos(frequency * p);
    return abs(c.x + c.y + c.z) / (1.7320509 * frequency) - halfThickness;
}

// Schwarz' surface D, the diamond: sin x sin y sin z + sin x cos y cos z + cos x sin y cos z +
// cos x cos y sin z = 0.
// Source: Schwarz, Gesammelte Mathematische Abhandlungen, 1890.
// bound
// lipschitz[1.0]
// example[opIntersection(sdSchwarzD(p, 1.0, 0.03), sdSphere(p, 0.8))]
float sdSchwarzD(vec3 p, float period, float halfThickness) {
    float frequency = 6.28318530718 / period;
    vec3 s = sin(frequency * p);
    vec3 c = cos(frequency * p);
    float sum = s.x * s.y * s.z + s.x * c.y * c.z + c.x * s.y * c.z + c.x * c.y * s.z;
    return abs(sum) / (1.7320509 * frequency) - halfThickness;
}

// Neovius' surface: 3 (cos x + cos y + cos z) + 4 cos x cos y cos z = 0.
// Source: Neovius, Bestimmung zweier speciellen periodischen Minimalflaechen, 1883.
// bound
// lipschitz[1.0]
// example[opIntersection(sdNeovius(p, 0.8, 0.03), sdSphere(p, 0.8))]
float sdNeovius(vec3 p, float period, float halfThickness) {
    float frequency = 6.28318530718 / period;
    vec3 c = cos(frequency * p);
    float sum = 3.0 * (c.x + c.y + c.z) + 4.0 * c.x * c.y * c.z;
    return abs(sum) / (7.0 * frequency) - halfThickness;
}

// Schoen's surface I-WP: 2 (cos x cos y + cos y cos z + cos z cos x) = cos 2x + cos 2y + cos 2z.
// Source: Schoen, Infinite Periodic Minimal Surfaces without Self-Intersections, NASA 1970.
// bound
// lipschitz[1.0]
// example[opIntersection(sdSchoenIwp(p, 0.8, 0.03), sdSphere(p, 0.8))]
float sdSchoenIwp(vec3 p, float period, float halfThickness) {
    float frequency = 6.28318530718 / period;
    vec3 c = cos(frequency * p);
    float sum = 2.0 * dot(c, c.yzx) + 3.0 - 2.0 * dot(c, c);
    return abs(sum) / (5.2 * frequency) - halfThickness;
}
