// SPDX-License-Identifier: MIT
const float kPi = 3.14159265358979;
const float kInfinity = 3.0e38;

struct Ray {
    vec3 origin;
    vec3 direction;
    float radius;  // of the pixel's cone at the origin, m: no detail smaller than this is resolved
};

float square(float x) { return x * x; }
float maxComponent(vec3 v) { return max(v.x, max(v.y, v.z)); }

// 1 / direction without infinities: a zero component becomes a huge slope with the right answer.
vec3 safeInverse(vec3 d) {
    return 1.0 / mix(d, vec3(1.0e-18), lessThan(abs(d), vec3(1.0e-18)));
}

// Two unit vectors that make a right-handed frame with n (Duff et al., Building an Orthonormal
// Basis, Revisited, JCGT 2017).
void orthonormalBasis(vec3 n, out vec3 tangent, out vec3 bitangent) {
    float s = n.z >= 0.0 ? 1.0 : -1.0;
    float a = -1.0 / (s + n.z);
    float b = n.x * n.y * a;
    tangent = vec3(1.0 + s * n.x * n.x * a, s * b, -s * n.x);
    bitangent = vec3(b, s + n.y * n.y * a, -n.y);
}
