// SPDX-License-Identifier: MIT
// Equations that distances to curves lead to.

// The real roots of t^3 + a t^2 + b t + c; a single one is given three times.
// Source: Cardano's formula, with the sign chosen so that nothing cancels, and Viete's cosines where
// there are three.
// example[abs(p.y - numCubicRoots(0.0, 2.0, -4.0 * p.x).x) / 2.3 - 0.05]
vec3 numCubicRoots(float a, float b, float c) {
    float third = a / 3.0;
    float p = b / 3.0 - third * third;
    float q = third * (third * third - 0.5 * b) + 0.5 * c;
    float inner = q * q + p * p * p;
    if (inner >= 0.0) {
        float w = abs(q) + sqrt(inner);
        float u = pow(w, 1.0 / 3.0);
        float root = u > 0.0 ? u - p / u : 0.0;
        return vec3((q > 0.0 ? -root : root) - third);
    }
    float r = sqrt(-p);
    float angle = acos(clamp(-q / (r * r * r), -1.0, 1.0)) / 3.0;
    return 2.0 * r * cos(angle + vec3(0.0, 2.09439510239, 4.18879020479)) - third;
}

// Where the point at `origin` is nearest to origin + 2 t a + t^2 b, from the products of those
// vectors: up to three t, each to be kept between 0 and 1.
// Source: the derivative of the squared distance is a cubic in t.
// example[sdBezier(p, vec3(-0.8, -0.5, 0.0), vec3(0.0, 1.2, 0.4), vec3(0.8, -0.5, 0.2), 0.1)]
vec3 numBezierFeet(float aa, float ab, float bb, float ao, float bo) {
    // A straight line is bent by a thousandth: its cubic would have no leading term.
    float lead = max(bb, 1.0e-6 * (aa + abs(ab)));
    return clamp(numCubicRoots(3.0 * ab / lead, (2.0 * aa + bo) / lead, ao / lead), 0.0, 1.0);
}
