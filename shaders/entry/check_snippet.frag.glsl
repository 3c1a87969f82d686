// SPDX-License-Identifier: MIT
// Nothing but the snippets and a call of each: compiled to see what the compiler says of them.
#include "scene/fetch.glsl"
#include "lib/color.glsl"
#include "shade/surface_type.glsl"
#include "generated/field.glsl"
#include "generated/material.glsl"

layout(location = 0) out vec4 outColor;

void main() {
    Surface s;
    s.part = int(gl_FragCoord.x);
    evaluateMaterial(s.part, s, 0);
    bindField(s.part, 0);
    outColor = vec4(evaluateField(s.part, gl_FragCoord.xyz), s.roughness, 1.0);
}
