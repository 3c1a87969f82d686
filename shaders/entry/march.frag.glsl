// SPDX-License-Identifier: MIT
#include "pass/march.glsl"

#if !DIALECT_ES && __VERSION__ >= 420
// The box was drawn as if all of it were as near as its nearest corner: a GPU may leave out what
// even then is hidden.
layout(depth_less) out float gl_FragDepth;
#endif
flat in int instance;
layout(location = 0) out uvec4 outRecord;

void main() {
    Ray ray = pixelRay(ivec2(gl_FragCoord.xy));
    outRecord = marchPass(ivec2(gl_FragCoord.xy), ray, instance);
    if (!isSurface(outRecord)) discard;
    gl_FragDepth = rasterDepth(ray, recordDistance(outRecord));
}
