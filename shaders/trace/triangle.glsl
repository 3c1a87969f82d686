// SPDX-License-Identifier: MIT
// Watertight ray-triangle intersection (Woop, Benthin, Wald 2013, JCGT 2(1)): a ray through a shared
// edge hits at least one of its triangles, because both compute the same edge function.
#include "lib/math.glsl"

// The shear that turns the ray into the +z axis, columns of a matrix. Written as a matrix rather
// than a permutation: products with its zeros and ones are exact.
struct RayShear {
    vec3 x, y, z;
};

RayShear rayShear(vec3 d) {
    vec3 a = abs(d);
    if (a.x > a.y && a.x > a.z)
        return RayShear(vec3(-d.y, -d.z, 1.0) / d.x, vec3(1.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0));
    if (a.y > a.z)
        return RayShear(vec3(0.0, 1.0, 0.0), vec3(-d.z, -d.x, 1.0) / d.y, vec3(1.0, 0.0, 0.0));
    return RayShear(vec3(1.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0), vec3(-d.x, -d.y, 1.0) / d.z);
}

// Two-sided. If the triangle is hit in [0, tMax): true, its distance and the weights of its second
// and third corner.
bool intersectTriangle(vec3 origin, RayShear shear, vec3 v0, vec3 v1, vec3 v2, float tMax,
                       out float t, out vec2 barycentrics) {
    vec3 a = v0 - origin;
    vec3 b = v1 - origin;
    vec3 c = v2 - origin;
    precise vec3 p0 = shear.x * a.x + shear.y * a.y + shear.z * a.z;
    precise vec3 p1 = shear.x * b.x + shear.y * b.y + shear.z * b.z;
    precise vec3 p2 = shear.x * c.x + shear.y * c.y + shear.z * c.z;
    // `precise`: a fused multiply-add would round an edge differently for its two triangles.
    precise float u = p2.x * p1.y - p2.y * p1.x;
    precise float v = p0.x * p2.y - p0.y * p2.x;
    precise float w = p1.x * p0.y - p1.y * p0.x;
    float determinant = u + v + w;
    t = (u * p0.z + v * p1.z + w * p2.z) / determinant;
    barycentrics = vec2(v, w) / determinant;
    bool inside = min(u, min(v, w)) >= 0.0 || max(u, max(v, w)) <= 0.0;
    return inside && determinant != 0.0 && t >= 0.0 && t < tMax;
}
