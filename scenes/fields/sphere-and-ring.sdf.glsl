// A sphere cut into a lattice by a gyroid, and a ring that is hung through it and whatever else
// stands in its way.
// bounds[-1.25, -0.56, -0.80,  0.80, 0.80, 0.80]
// parts[sphere, ring]
uniform float cells;      // slider[4.0, 9.0, 16.0] Fineness of the lattice
uniform float thickness;  // slider[0.1, 0.42, 1.0] Thickness of the lattice
uniform float tilt;       // slider[-90.0, 24.0, 90.0] Tilt of the ring, degrees

vec2 sdf(vec3 p) {
    float shell = opShell(sdSphere(p, 0.47), 0.075);
    // The gyroid's equation has the slope sqrt(3) at most: thickness is a value of the equation.
    float lattice = sdGyroid(p, 6.2831853 / cells, thickness / (1.7320508 * cells));
    float sphere = opSmoothIntersection(shell, lattice, 0.03);

    vec3 q = domRotateZ(p - vec3(-0.62, 0.08, 0.0), radians(tilt));
    float ring = sdTorus(q, 0.5, 0.055);
    return opUnionPart(vec2(sphere, 0.0), vec2(ring, 1.0));
}
