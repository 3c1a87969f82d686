// SPDX-License-Identifier: MIT
#include "pass/probe_field.glsl"

layout(location = 0) out vec4 outValue;
layout(location = 1) out vec4 outGradient;

void main() {
    FieldProbe probe = probeFieldPass(ivec2(gl_FragCoord.xy));
    outValue = probe.value;
    outGradient = probe.gradient;
}
