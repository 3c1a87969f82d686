// SPDX-License-Identifier: MIT
// Asks a field about places that are given, to find out how steep it is (src/sdf/field_samples.hpp).
// Seven evaluations of the text that the renderer marches along, from a single call.
#include "scene/fetch.glsl"
#include "generated/field.glsl"

uniform sampler2D samplePlaces;  // xyz: object space; w: time, s
uniform sampler2D sampleSteps;   // x: half of the length over which slopes are measured; y: first parameter

struct FieldProbe {
    vec4 value;     // x: distance; y: largest slope; z: values that are no finite numbers
    vec4 gradient;  // xyz
};

bool isBad(float d) { return !(abs(d) < 1.0e30); }

FieldProbe probeFieldPass(ivec2 pixel) {
    vec4 place = texelFetch(samplePlaces, pixel, 0);
    vec4 how = texelFetch(sampleSteps, pixel, 0);
    float reach = how.x;
    float corner = reach * inversesqrt(3.0);
    bindField(0, int(how.y));
    snippetTime = place.w;
    FieldProbe probe = FieldProbe(vec4(0.0), vec4(0.0));
    vec3 gradient = vec3(0.0);
    vec3 along = vec3(1.0, 0.0, 0.0);
    float behind = 0.0;
    // The place, the corners of a tetrahedron, then backwards and forwards along the gradient.
    for (int i = 0; i < frame.counts.y; i++) {
        if (!mayLoop()) break;
        int c = i - 1;
        vec3 side = vec3((c & 1) == 0 ? 1.0 : -1.0, (c & 2) == 0 ? 1.0 : -1.0,
                         c == 0 || c == 3 ? 1.0 : -1.0);
        if (i == 5) {
            float size = length(gradient);
            if (size > 0.0 && !isBad(size)) along = gradient / size;
        }
        vec3 offset = i == 0 ? vec3(0.0) : i < 5 ? corner * side : i == 5 ? -reach * along : reach * along;
        float d = evaluateField(0, place.xyz + offset).x;
        if (isBad(d)) probe.value.z += 1.0;
        if (i == 0) probe.value.x = d;
        if (i > 0 && i < 5) gradient += side * d / (4.0 * corner);
        if (i > 4) probe.value.y = max(probe.value.y, abs(d - probe.value.x) / reach);
        if (i == 5) behind = d;
        if (i == 6) probe.value.y = max(probe.value.y, abs(d - behind) / (2.0 * reach));
    }
    probe.gradient = vec4(gradient, 0.0);
    return probe;
}
