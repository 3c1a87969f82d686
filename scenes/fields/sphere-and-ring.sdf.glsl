// A sphere cut into a lattice by a gyroid, and a ring that is hung through it and whatever else
// stands in its way.
// bounds[-1.25, -0.56, -0.80,  0.80, 0.80, 0.80]
// lipschitz[1.15]
// parts[sphere, ring]
uniform float cells;      // slider[4.0, 9.0, 16.0] Fineness of the lattice
uniform float thickness;  // slider[0.1, 0.42, 1.0] Thickness of the lattice
uniform float tilt;       // slider[-90.0, 24.0, 90.0] Tilt of the ring, degrees

// Distance to the surface sin x cos y + sin y cos z + sin z cos x = 0, thickened to a sheet. The
// slope of the sum is at most sqrt(3) times the frequency, hence the division.
float gyroidSheet(vec3 p, float frequency, float width) {
    p *= frequency;
    return (abs(dot(sin(p), cos(p.yzx))) - width) / (frequency * 1.55);
}

float torus(vec3 p, float ringRadius, float tubeRadius) {
    return length(vec2(length(p.xz) - ringRadius, p.y)) - tubeRadius;
}

// The larger of two values, with a rounded edge of radius r where they meet.
float smoothMax(float a, float b, float r) {
    float h = max(r - abs(a - b), 0.0);
    return max(a, b) + 0.25 * h * h / r;
}

vec2 sdf(vec3 p) {
    float shell = abs(length(p) - 0.47) - 0.075;
    float sphere = smoothMax(shell, gyroidSheet(p, cells, thickness), 0.03);

    float angle = radians(tilt);
    vec3 q = p - vec3(-0.62, 0.08, 0.0);
    q.xy = mat2(cos(angle), -sin(angle), sin(angle), cos(angle)) * q.xy;
    float ring = torus(q, 0.5, 0.055);
    return sphere < ring ? vec2(sphere, 0.0) : vec2(ring, 1.0);
}
