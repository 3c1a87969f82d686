// SPDX-License-Identifier: MIT
// Tone maps: linear scene light, not negative, to linear display light, 0 to 1. Middle grey, 0.18, stays
// between 0.15 and 0.22 in all of them.

// Narkowicz, "ACES Filmic Tone Mapping Curve" (2015), a fit of the ACES reference rendering transform
// channel by channel. Deep blacks, a soft shoulder, vivid colours; the factor keeps middle grey.
vec3 toneMapFilmic(vec3 c) {
    c *= 0.8;
    return (c * (2.51 * c + 0.03)) / (c * (2.43 * c + 0.59) + 0.14);
}

// Hill's fit of the ACES RRT and ODT with its change of primaries (in Baking Lab by Pettineo & Hill,
// 2016): bright colours lose their saturation. The factor keeps middle grey.
vec3 toneMapAces(vec3 c) {
    const mat3 toRrt = mat3(0.59719, 0.07600, 0.02840, 0.35458, 0.90834, 0.13383, 0.04823, 0.01566, 0.83777);
    const mat3 fromOdt = mat3(1.60475, -0.10208, -0.00327, -0.53108, 1.10813, -0.07276, -0.07367, -0.00605, 1.07602);
    c = toRrt * (1.463 * min(c, 1.0e6));
    c = (c * (c + 0.0245786) - 0.000090537) / (c * (0.983729 * c + 0.4329510) + 0.238081);
    return clamp(fromOdt * c, 0.0, 1.0);
}

// The sigmoid of AgX through (pivot, 0.5) with slope 2, which reaches 0 at 0 and 1 at 1.
vec3 agxSigmoid(vec3 x) {
    const float pivot = 10.0 / 16.5;  // middle grey among the stops
    vec3 lower = vec3(lessThan(x, vec3(pivot)));
    vec3 power = mix(vec3(3.25), vec3(3.0), lower);
    vec3 reach = 2.0 * mix(vec3(1.0 - pivot), vec3(pivot), lower);
    // reach / scale: what bends the straight line so that it ends where it should.
    vec3 bend = pow(pow(2.0 * reach, power) - 1.0, 1.0 / power);
    vec3 along = 2.0 * (x - pivot);
    return 0.5 + along / pow(1.0 + pow(abs(along) / reach * bend, power), 1.0 / power);
}

// AgX: Sobotka's picture formation (github.com/sobotka/AgX, 2022). The primaries are pulled towards
// grey before a curve over 16.5 stops and pushed back behind it, so that bright colours go to white
// without turning on the way (blue not to violet, red not to yellow). The matrix for Rec. 709 is the
// one of Wrensch, "Minimal AgX Implementation" (2023).
vec3 toneMapAgx(vec3 c) {
    const mat3 inset = mat3(0.842479062253094, 0.0423282422610123, 0.0423756549057051,
                            0.0784335999999992, 0.878468636469772, 0.0784336,
                            0.0792237451477643, 0.0791661274605434, 0.879142973793104);
    c = inset * c;
    vec3 stops = log2(max(c, 1.0e-10) / 0.18);
    c = agxSigmoid(clamp((stops + 10.0) / 16.5, 0.0, 1.0));
    c = clamp(inverse(inset) * c, 0.0, 1.0);
    return pow(c, vec3(2.2));
}

// Reinhard et al., Photographic Tone Reproduction for Digital Images (SIGGRAPH 2002), formula 4, on
// luminance: a luminance of 4 is white. Hues stay until a channel clips.
vec3 toneMapReinhard(vec3 c) {
    const float white = 4.0;
    float luminance = dot(c, vec3(0.2126, 0.7152, 0.0722));
    return c * ((1.0 + luminance / (white * white)) / (1.0 + luminance));
}
