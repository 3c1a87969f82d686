// SPDX-License-Identifier: MIT
// Snippets as people write them, for the tests that compile them and the tests that break them.
#pragma once

#include <array>
#include <string_view>

#include "sdf/snippet.hpp"

namespace vitrine {

struct Sample {
    std::string_view name;
    SnippetKind kind;
    std::string_view source;
};

inline constexpr std::array<Sample, 11> kSamples = {{
    {"sphere", SnippetKind::kField, "float sdf(vec3 p) { return length(p) - 1.0; }\n"},
    {"parameters", SnippetKind::kField, R"(// bounds[-1.2, -1.2, -1.2,  1.2, 1.2, 1.2]
// lipschitz[1.4]
// parts[body, trim]
// group Shape
uniform float morph;   // slider[0.0, 0.0, 1.0] Torus to mug
uniform vec3  tint;    // color[0.8, 0.3, 0.2] Glaze
uniform bool  handle;  // checkbox[true] Handle
uniform int   teeth;   // slider[3, 12, 40]
uniform vec2  shift; slider[(0,0),(0.5,0.5),(1,1)]
uniform float time;
float torus(vec3 p, vec2 t) { return length(vec2(length(p.xz) - t.x, p.y)) - t.y; }
vec2 sdf(vec3 p) {
    p.xz += shift * tint.xy * sin(time);
    float d = torus(p, vec2(mix(0.8, 0.6, morph), 0.2)) + float(teeth) * 0.001;
    if (handle) d = min(d, torus(p.xzy, vec2(0.3, 0.1)));
    return vec2(d, p.y > 0.0 ? 1.0 : 0.0);
}
)"},
    {"shadowing", SnippetKind::kField, R"(uniform float r; // slider[0, 0.5, 1]
uniform vec3 c; // color[1, 0, 0]
struct Thing { float r; vec3 c; };
float plain(float r) { return r * 2.0; }
float DE(vec3 p) {
    Thing t;
    t.r = r;
    t.c = c;
    float d = length(p) - t.r - t.c.r;
    { float r = r + 1.0, c = r; d += r * c; }
    for (float r = 0.0; r < 3.0; r += 1.0) d -= plain(r) * 0.0001;
    if (d > r) { float time = r; d += time * 0.001; }
    float plain = plain(d);
    return plain * c.x;
}
)"},
    {"macros", SnippetKind::kField, R"(#define PI 3.14159265
#define rot(a) mat2(cos(a), -sin(a), \
                    sin(a), cos(a))
#define FOR(i, n) for (int i = 0; i < n; i++)
#ifdef GL_ES
precision mediump float;
#endif
#if defined(VITRINE) && __VERSION__ >= 300
const int N = 4;
#else
const int N = 400000;
#endif
float table[N * 2];
float map(vec3 p) {
    float d = 1e9;
    FOR(i, N) FOR(k, 2) table[i * 2 + k] = float(i + k);
    FOR(i, N) { p.xy = rot(PI / 5.0 * iTime) * abs(p.xy); d = min(d, length(p) - table[i]); }
    return d;
}
#ifndef VITRINE
void main() { gl_FragColor = vec4(map(vec3(gl_FragCoord.xyz))); }
#endif
)"},
    {"loops", SnippetKind::kField, R"(float sdf(vec3 p) {
    float d = length(p);
    int i = 0;
    while (i < 10) i++;
    do { d *= 0.99; if (d < 0.1) continue; } while (d > 1.0);
    do d *= 0.5; while (d > 2.0);
    for (;;) { if (i++ > 20) break; }
    for (int a = 0, b = 3; a < b; ++a, d += 0.001)
        for (float x = 0.0; x < 1.0 && d < 9.0; x += 0.3)
            if (x > 0.5) d -= 0.01; else d += 0.02;
    while (i > 0) { i -= 2; while (i > 5) { i--; } }
    return d;
}
)"},
    {"overloads", SnippetKind::kField, R"(float hash(float x) { return fract(sin(x) * 43758.5453); }
float hash(vec2 x) { return hash(dot(x, vec2(12.9898, 78.233))); }
float hash(vec3 x) { return hash(vec2(hash(x.xy), x.z)); }
float max(vec3 v) { return max(v.x, max(v.y, v.z)); }
float later(vec3 p);
float sdf(vec3 p) { return max(abs(p)) - 0.5 + 0.01 * hash(p) + later(p); }
float later(vec3 p) { return 0.001 * hash(p.x); }
)"},
    {"globals", SnippetKind::kField, R"(vec4 orbitTrap = vec4(1000.0);
const vec3 kAxis[2] = vec3[2](vec3(1.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0));
float _scale = 2.0, bias;
int input, filter;
struct Ray { vec3 o, d; float t[3]; } ray;
float DE(in vec3 z) {
    bias = 0.5;
    ray.o = z;
    ray.t[1] = 2.0;
    for (int n = 0; n < 8; n++) {
        z = abs(z) * _scale - bias * ray.t[1];
        orbitTrap = min(orbitTrap, vec4(z, dot(z, z)));
        input += n;
    }
    Ray other = Ray(z, kAxis[input & 1], float[3](0.0, 1.0, 2.0));
    return length(z + other.o) * pow(_scale, -8.0) + orbitTrap.w * 0.0;
}
)"},
    {"statements", SnippetKind::kField, R"(int pick(int k) {
    switch (k) {
        case 0: return 4;
        case 1 + 1: { int k = 7; return k; }
        default: break;
    }
    if (k > 5) return 1; else if (k > 4) return 2; else if (k > 3) { return 3; } else return 5;
}
void swap(inout float a, inout float b) { float t = a; a = b; b = t; }
float sum(const in float list[3], float[2] more, float) { return list[0] + more[1]; }
float sdf(vec3 p) {
    const int kLength = 2 + 1;
    float a[kLength];
    a[0] = p.x; a[1] = p.y; a[2] = p.z;
    swap(a[0], a[1]);
    precision highp float;
    bool hit = p.x > 0.0 ? true : false, other;
    return sum(a, float[2](1.0, 2.0), 3.0) + float(pick(int(p.x))) * (hit ? 1. : -1.);;
}
)"},
    {"noise", SnippetKind::kField, R"(// A bumpy ground. Ganz ohne Umlaute geht es nicht: hügelig.
float hash21(vec2 p) {
    p = fract(p * vec2(234.34, 435.345)); p += dot(p, p + 34.23);
    return fract(p.x * p.y);
}
float noise(vec2 p) {
    vec2 i = floor(p), f = fract(p);
    f = f * f * (3.0 - 2.0 * f);
    return mix(mix(hash21(i), hash21(i + vec2(1, 0)), f.x),
               mix(hash21(i + vec2(0, 1)), hash21(i + vec2(1, 1)), f.x), f.y);
}
float fbm(vec2 p) {
    float s = 0.0, a = 0.5;
    for (int i = 0; i < 5; i++, p *= 2.02, a *= 0.5) s += a * noise(p);
    return s;
}
float map(vec3 p) { return p.y - fbm(p.xz + u_time) /* height */; }
)"},
    {"material", SnippetKind::kMaterial, R"(uniform float scale; // slider[1, 8, 40] Checks
void material(inout Surface s) {
    vec3 cell = floor(s.position * scale);
    s.color = mod(cell.x + cell.y + cell.z, 2.0) < 0.5 ? vec3(0.1) : vec3(0.9);
    s.roughness = 0.2 + 0.1 * sin(time);
}
)"},
    {"screen", SnippetKind::kScreen, R"(uniform vec2 u_resolution;
void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = fragCoord / iResolution.xy;
    vec3 col = 0.5 + 0.5 * cos(iTime + uv.xyx * u_resolution.x + vec3(0, 2, 4));
    fragColor = vec4(col, 1.0 + float(iFrame) + iMouse.x);
}
)"},
}};

}  // namespace vitrine
