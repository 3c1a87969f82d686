// SPDX-License-Identifier: MIT
// Light that leaves each hit towards the path: emission, all lights, the bright part of the sky, and
// ambient light with rays for its occlusion. One loop, one place where shadow rays are traced.
//
// What has a size is found in two ways, by choosing a direction to it here and by the bounces that
// run into it; both count by the balance heuristic (Veach & Guibas, Optimally Combining Sampling
// Techniques, SIGGRAPH 1995). Surfaces that glow are not chosen: they light what bounces off them.
#define TRACE_ANY 1
#include "trace/trace.glsl"
#include "shade/path.glsl"
#include "shade/surface.glsl"
#include "shade/environment.glsl"
#include "shade/lights.glsl"
#include "shade/reflection.glsl"
#include "shade/counters.glsl"

uniform sampler2D radianceBefore;

// A look for light: where to, how far, and what of it counts if nothing is in the way or something
// is. `sky`: the factors are on this part of the sky's radiance; kNoSky: they are radiance.
struct Probe {
    vec3 direction;
    float distance;
    vec3 open;
    vec3 blocked;
    int sky;
    float level;
    vec3 origin;
};
const int kNoSky = -1;

// Directions to the bright sky from a hit after so many bounces.
int skySamples(int bounce) { return bounce == 0 ? frame.skyTree.z : frame.skyTree.w; }

// What the surface sends to the viewer of light from `direction` that was chosen with `density`, and
// that a bounce may find as well. 0: a bounce cannot.
vec3 answerToLight(Hit hit, Path path, vec3 direction, float density) {
    float leastAlpha = density > 0.0 ? path.blur : max(path.blur, kLeastLightAlpha);
    vec3 toViewer = -path.ray.direction;
    Answer all = evaluateReflection(hit.surface, toViewer, direction, leastAlpha, true);
    Answer lobe = evaluateReflection(hit.surface, toViewer, direction, leastAlpha, false);
    // Bounces of blurred paths look for no lights (pass/bounce.glsl).
    float other = density > 0.0 && path.blur <= 0.0 ? all.pdf : 0.0;
    // In hybrid mode they follow the lobes that mirror, and light of the others is found here alone.
    vec3 foundTwice = isReference() ? all.value : lobe.value;
    return max(all.value - foundTwice * (other / max(density + other, 1.0e-30)), 0.0);
}

Probe lightProbe(Hit hit, Path path, ivec2 pixel, int light) {
    int dimension = kDimensionLights + 32 * (light & 31) + (frame.sampling.z & 31);
    vec2 u = random2(pixel, frame.sampling.x, dimension, frame.sampling.w);
#if HAS_CONES
    bool oneRay = frame.quick.x != 0;
    if (oneRay) u = middleOfLight(light);
#endif
    LightSample chosen = sampleLight(light, hit.surface.position, u);
#if HAS_CONES
    coneSlope = chosen.spread;
    coneAsks = oneRay && chosen.density > 0.0 ? kAskPenumbra : kAskHit;
#endif
    vec3 answer = answerToLight(hit, path, chosen.direction, chosen.density) * chosen.irradiance;
    if (frame.image.w == VITRINE_VIEW_SHADOW)
        answer = vec3(answer == vec3(0.0) ? 0.0 : 1.0 / float(frame.counts.x));
    return Probe(chosen.direction, chosen.distance, answer, vec3(0.0), kNoSky, 0.0,
                 hit.rayOrigin);
}

#if HAS_SKY
Probe brightProbe(Hit hit, Path path, ivec2 pixel, int index, int count) {
    int sampleIndex = frame.sampling.x * count + index;
    vec2 u = random2(pixel, sampleIndex, frame.sampling.y * count,
                     kDimensionSky + frame.sampling.z, frame.sampling.w);
    SkySample chosen = sampleSky(u);
    float density = float(count) * chosen.density;
    vec3 answer = answerToLight(hit, path, chosen.direction, density) / max(density, 1.0e-30);
    return Probe(chosen.direction, kInfinity, answer, vec3(0.0), kSkyBright, 0.0, hit.rayOrigin);
}

// The sky at the end of a path: first its ambient part, then the bright one.
Probe missProbe(Path path, int part) {
    float level = skyLevel(square(frame.cameraEye.w));
    float weight = 1.0;
    if (path.pdf != 0.0) {
        // A ray of a lobe stands for the directions around it; fewer rays, more of them (Colbert &
        // Krivanek, GPU-Based Importance Sampling, GPU Gems 3, 2007).
        level = isReference() ? 0.0
                              : skyLevel(1.0 / (float(frame.sampling.y) * abs(path.pdf))) - 1.0;
        if (part == kSkyBright) {
            float count = float(skySamples(frame.sampling.z - 1));
            float density = count > 0.0 ? count * skyDensity(path.ray.direction) : 0.0;
            weight = max(path.pdf, 0.0) / (abs(path.pdf) + density);
            level = 0.0;
        }
    }
    return Probe(path.ray.direction, 0.0, vec3(weight), vec3(weight), part, level, path.ray.origin);
}
#endif

// A length of which a share of exp(-d / radius) are longer than d, by u in [0, 1). A ray of such a
// length tells of a thickness what is needed of it, on average, without measuring it.
float scatteredLength(float u, float radius) { return -radius * log(1.0 - u); }

// What the view of thicknesses asks for.
struct Substance {
    bool mesh;
    float radius;  // that leaves 1/e, m
};

// exp(-thickness / radius) straight below the surface.
Probe thicknessProbe(Hit hit, Substance below, float u, float share) {
    float reach = scatteredLength(u, below.radius);
    vec3 down = -hit.geometricNormal;
    // Of a mesh, a ray inside meets the other side; a field holds whatever starts in it.
    if (below.mesh) return Probe(down, reach, vec3(0.0), vec3(share), kNoSky, 0.0, hit.behind);
    return Probe(down, 1.0e-3 * reach, vec3(share), vec3(0.0), kNoSky, 0.0,
                 hit.surface.position + reach * down);
}

Probe ambientProbe(Hit hit, Substance below, ivec2 pixel, int index, int count) {
    Surface s = hit.surface;
    vec3 albedo = ambientAlbedo(s) * s.occlusion;
    if (frame.image.w == VITRINE_VIEW_AO) albedo = vec3(1.0);
    albedo /= float(count);
    float ao = frame.shading.z;
    int sampleIndex = frame.sampling.x * count + index;
    vec2 u = random2(pixel, sampleIndex, frame.sampling.y * count,
                     kDimensionAmbient + frame.sampling.z, frame.sampling.w);
    if (frame.image.w == VITRINE_VIEW_THICKNESS)
        return thicknessProbe(hit, below, u.x, 1.0 / float(count));
    vec3 local = sampleCosine(u);
#if !HAS_SKY
    if (ao <= 0.0) local = vec3(0.0, 0.0, 1.0);
#endif
    vec3 tangent, bitangent;
    orthonormalBasis(s.normal, tangent, bitangent);
    vec3 direction = local.x * tangent + local.y * bitangent + local.z * s.normal;
    Probe probe = Probe(direction, ao > 0.0 ? frame.shading.w : 0.0, albedo, albedo * (1.0 - ao),
                        kSkyAmbient, 0.0, hit.rayOrigin);
    if (frame.image.w == VITRINE_VIEW_AO) {
        probe.sky = kNoSky;
        return probe;
    }
#if HAS_SKY
    float density = max(local.z, 0.05) / kPi;
    probe.level = skyLevel(1.0 / (float(frame.sampling.y * count) * density)) - 1.0;
#else
    vec3 radiance = gradientRadiance(direction);
    probe.open *= radiance;
    probe.blocked *= radiance;
#endif
    return probe;
}

#if HAS_CONES
// The same for a surface whose occlusion comes from taps: no ray. Without a picture all of the light
// is in one probe.
Probe tappedProbe(Hit hit, Probe probe) {
#if !HAS_SKY
    Surface s = hit.surface;
    bool ao = frame.image.w == VITRINE_VIEW_AO;
    probe.open = ao ? vec3(1.0) : ambientAlbedo(s) * s.occlusion * gradientMean(s.normal);
#endif
    probe.blocked = probe.open;
    return probe;
}
#endif

#if HAS_SUBSURFACE
// Light that comes through the substance (Barre-Brisebois & Bouchard, Approximating Translucency for a
// Fast, Cheap and Convincing Subsurface Scattering Look, GDC 2011): most of it goes straight on, a
// part everywhere. The thickness is not baked: a shadow ray that starts a random length further
// towards the light is free if the substance ends before that, and if nothing else is in the way.
Probe substanceProbe(Hit hit, Path path, ivec2 pixel, int light, int index, int count) {
    const float kEverywhere = 0.35;
    const float kPower = 4.0;
    const float kDistortion = 0.2;
    Surface s = hit.surface;
    int dimension = kDimensionLights + 32 * (light & 31) + (frame.sampling.z & 31);
    vec2 u = random2(pixel, frame.sampling.x, dimension, frame.sampling.w);
    LightSample chosen = sampleLight(light, s.position, u);
    vec3 through = -normalize(chosen.direction + kDistortion * s.normal);
    float straight = pow(max(dot(-path.ray.direction, through), 0.0), kPower);
    // What faces the light answers as a body does.
    float facing = max(dot(s.normal, chosen.direction), 0.0);
    vec3 albedo = (1.0 - s.metallic) * (1.0 - s.transmission) * s.baseColor * s.subsurface;
    vec3 answer = albedo * chosen.irradiance *
                  (mix(kEverywhere, 1.0, straight) * (1.0 - facing) / (kPi * float(count)));
    float uLength = random2(pixel, frame.sampling.x * count + index, frame.sampling.y * count,
                            kDimensionSubstance + (frame.sampling.z & 31), frame.sampling.w).x;
    float start = scatteredLength(uLength, s.subsurfaceRadius);
    bool outside = dot(hit.geometricNormal, chosen.direction) > 0.0;
    vec3 origin = (outside ? hit.rayOrigin : s.position) + start * chosen.direction;
    return Probe(chosen.direction, max(chosen.distance - start, 0.0), answer, vec3(0.0), kNoSky, 0.0,
                 origin);
}
#endif

// Lights with a size that the path's ray ran into before it met a surface.
vec3 lightsSeen(Path path, float nearest) {
    vec3 sum = vec3(0.0);
    for (int i = 0; i < frame.probes.x; i++) {
        if (!mayLoop()) break;
        LightSeen light = seeLight(i, path.ray, nearest, frame.sampling.z == 0);
        sum += path.pdf == 0.0 ? min(light.radiance, kMostSeen)
                               : light.radiance * (max(path.pdf, 0.0) / (abs(path.pdf) + light.density));
    }
    return sum;
}

vec3 gather(uvec4 record, Path path, ivec2 pixel) {
    int view = frame.image.w;
    bool surface = isSurface(record);
    bool thickness = view == VITRINE_VIEW_THICKNESS;
    int lights = view == VITRINE_VIEW_AO || thickness ? 0 : frame.counts.x;
    int ambient = view == VITRINE_VIEW_SHADOW ? 0 : frame.sampling.z == 0 ? frame.probes.y : frame.probes.z;
    bool light = view != VITRINE_VIEW_AO && view != VITRINE_VIEW_SHADOW && !thickness;
    vec3 sum = vec3(0.0);
    vec3 ambientSum = vec3(0.0);
    Hit hit;
    hit.way = vec3(1.0);
    if (surface) hit = loadHit(record, path.ray);
    if (light) {
        sum = lightsSeen(path, surface ? recordDistance(record) : kInfinity);
        if (surface) sum += hit.surface.emission;
    }
#if HAS_SKY
    int bright = light ? skySamples(frame.sampling.z) : 0;
    int count = surface ? lights + bright + ambient : light ? 2 : 0;
#else
    int bright = 0;
    int count = surface ? lights + ambient : 0;
    if (!surface && light) sum += gradientRadiance(path.ray.direction);
#endif
#if HAS_CONES
    bool tapped = surface && frame.quick.y != 0 && !thickness && ambient > 0 &&
                  fetchInstance(int(record.x)).kind == VITRINE_KIND_FIELD;
    float tapOccluded = 0.0;
#if !HAS_SKY
    if (tapped) count += 1 - ambient;
#endif
#endif
    int shone = count;  // probes before those through the substance
#if HAS_SUBSURFACE
    int looks = frame.sampling.z == 0 ? frame.probes.w : 1;
    if (surface && light && maxComponent(hit.surface.subsurface) > 0.0) count += lights * looks;
#endif
    Substance below = Substance(false, 0.0);
    if (surface) {
        below.mesh = fetchInstance(int(record.x)).kind == VITRINE_KIND_MESH;
        below.radius = fetchTable(frame.tables.y + hit.material * VITRINE_MATERIAL_TEXELS + 8).w;
    }
    for (int i = 0; i < count; i++) {
        if (!mayLoop()) break;
        Probe probe;
        bool isAmbient = surface && i >= lights + bright && i < shone;
#if HAS_CONES
        coneAsks = kAskHit;
#endif
#if HAS_SUBSURFACE
        if (i >= shone)
            probe = substanceProbe(hit, path, pixel, (i - shone) / looks, (i - shone) % looks, looks);
        else
#endif
#if HAS_SKY
        if (!surface)
            probe = missProbe(path, i);
        else if (i >= lights && i < lights + bright)
            probe = brightProbe(hit, path, pixel, i - lights, bright);
        else
#endif
        if (i < lights)
            probe = lightProbe(hit, path, pixel, i);
        else
            probe = ambientProbe(hit, below, pixel, i - lights - bright, ambient);
#if HAS_CONES
        if (tapped && isAmbient) probe = tappedProbe(hit, probe);
        bool taps = tapped && i == lights + bright;
#endif
        float distance = any(notEqual(probe.open, probe.blocked)) ? probe.distance : 0.0;
#if HAS_CONES
        vec3 toSky = probe.direction;
        if (taps) {
            coneAsks = kAskTaps;
            coneOwner = int(record.x);
            probe.direction = hit.geometricNormal;
            distance = frame.shading.w;
        }
#endif
        uvec4 obstacle = missRecord();
        if (distance > 0.0)
            obstacle = trace(Ray(probe.origin, probe.direction, i >= shone || thickness ? 0.0 : hit.radius),
                             distance);  // thickness is not a matter of pixels
        vec3 arrives = isSurface(obstacle) || distance <= 0.0
                           ? probe.blocked
                           : mix(probe.blocked, probe.open, transmittance);
#if HAS_CONES
        if (taps) tapOccluded = tapOcclusion();
        probe.direction = toSky;
#endif
#if HAS_SKY
        if (probe.sky != kNoSky) arrives *= skyRadiance(probe.direction, probe.level, probe.sky);
#endif
        if (isAmbient) ambientSum += arrives;
        else sum += arrives;
    }
#if HAS_CONES
    ambientSum *= 1.0 - frame.shading.z * tapOccluded;
#endif
    // More occlusion than is natural (ao above 1) must not take away other light.
    return hit.way * (sum + max(ambientSum, 0.0));
}

vec4 lightPass(ivec2 pixel) {
    uvec4 record = texelFetch(records, pixel, 0);
    vec3 before = texelFetch(radianceBefore, pixel, 0).rgb;
    if (record.x == VITRINE_RECORD_NONE) return vec4(before, 1.0);
    Path path = loadPath(pixel);
    return vec4(before + path.throughput * gather(record, path, pixel), 1.0);
}

#if COUNTERS
uvec4 lightCounters(ivec2 pixel) {
    return addCounters(texelFetch(countersBefore, pixel, 0), 1u);
}
#endif
