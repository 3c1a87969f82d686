// SPDX-License-Identifier: MIT
// Lights as a point sees them. Those with a size are sampled over the angle that they fill, and are
// met by rays that pass them.
#include "scene/fetch.glsl"

struct Light {
    int type;
    vec3 at;
    vec3 axis;         // the way its light travels
    vec3 power;        // sun: irradiance; others: radiant intensity
    float range;
    float radius;      // m
    float narrowness;  // sun: one minus the cosine of its radius
    vec2 cosines;      // spot: of the inner and the outer angle
    bool seen;         // by the camera
    vec3 edgeX;        // rect: from the middle to the right and the upper edge
    vec3 edgeY;
};

Light fetchLight(int light) {
    int i = frame.tables.z + light * VITRINE_LIGHT_TEXELS;
    vec4 a = fetchTable(i);
    vec4 b = fetchTable(i + 1);
    vec4 c = fetchTable(i + 2);
    vec4 d = fetchTable(i + 3);
    return Light(int(a.w), a.xyz, c.xyz, b.rgb, b.w, c.w, d.z, d.xy, d.w > 0.0,
                 fetchTable(i + 4).xyz, fetchTable(i + 5).xyz);
}

struct LightSample {
    vec3 direction;   // towards the light, unit
    float distance;   // free way that a shadow ray needs
    vec3 irradiance;  // on a surface that faces the light; of a sized one, divided by the density
    float density;    // of the direction, per solid angle; 0: the only one there is
    float spread;     // tangent of the angle between the middle of the light and its rim
};

// What of a lamp's light gets this far: `distance` from its middle, in direction `way` from it.
float lampShare(Light light, float distance, vec3 way) {
    // The window of KHR_lights_punctual, which takes a light to nothing at its range.
    float q = light.range > 0.0 ? distance / light.range : 0.0;
    float share = clamp(1.0 - q * q * q * q, 0.0, 1.0);
    if (light.type == VITRINE_LIGHT_SPOT) {
        float cone = clamp((dot(light.axis, way) - light.cosines.y) /
                               max(light.cosines.x - light.cosines.y, 1.0e-3), 0.0, 1.0);
        share *= cone * cone;
    }
    return share;
}

// One minus the cosine of the angle under which a sphere's radius is seen.
float sphereNarrowness(float radius, float distanceSquared) {
    float q = min(radius * radius / distanceSquared, 0.999999);
    return q / (1.0 + sqrt(1.0 - q));
}

LightSample sampleRect(Light light, vec3 position, vec2 u) {
    vec3 way = light.at + (2.0 * u.x - 1.0) * light.edgeX + (2.0 * u.y - 1.0) * light.edgeY - position;
    float distanceSquared = max(dot(way, way), 1.0e-8);
    float distance = sqrt(distanceSquared);
    vec3 direction = way / distance;
    float cosine = max(0.0, -dot(direction, light.axis));
    float area = 4.0 * length(light.edgeX) * length(light.edgeY);
    return LightSample(direction, distance * 0.99999,
                       light.power * (cosine * lampShare(light, distance, -direction) / distanceSquared),
                       distanceSquared / max(area * cosine, 1.0e-12),
                       sqrt(area * cosine / (kPi * distanceSquared)));  // of a disc as large
}

// The `u` for which sampleLight looks at the middle.
vec2 middleOfLight(int number) {
    bool rect = int(fetchTable(frame.tables.z + number * VITRINE_LIGHT_TEXELS).w) == VITRINE_LIGHT_RECT;
    return rect ? vec2(0.5) : vec2(0.0);
}

LightSample sampleLight(int number, vec3 position, vec2 u) {
    Light light = fetchLight(number);
    if (light.type == VITRINE_LIGHT_RECT) return sampleRect(light, position, u);
    bool sun = light.type == VITRINE_LIGHT_SUN;
    vec3 way = light.at - position;
    float distanceSquared = max(dot(way, way), 1.0e-8);
    float distance = sqrt(distanceSquared);
    vec3 centre = sun ? -light.axis : way / distance;
    float narrowness = sun ? light.narrowness : sphereNarrowness(light.radius, distanceSquared);
    // Evenly within the cone that holds the disc or the sphere.
    float down = u.x * narrowness;
    float sine = sqrt(down * (2.0 - down));
    float angle = 2.0 * kPi * u.y;
    vec3 tangent, bitangent;
    orthonormalBasis(centre, tangent, bitangent);
    vec3 direction = (1.0 - down) * centre +
                     sine * (cos(angle) * tangent + sin(angle) * bitangent);
    // The radiance, which makes light.power with the sine squared of the radius, over the density.
    vec3 irradiance = light.power * (2.0 / (2.0 - narrowness));
    float density = narrowness > 0.0 ? 1.0 / (2.0 * kPi * narrowness) : 0.0;
    float spread = sqrt(narrowness * (2.0 - narrowness)) / max(1.0 - narrowness, 1.0e-3);
    if (sun) return LightSample(direction, kInfinity, irradiance, density, spread);
    float nearSide = distance * (1.0 - down) -
                     sqrt(max(0.0, square(light.radius) - square(distance * sine)));
    return LightSample(direction, nearSide * 0.99999,
                       irradiance * (lampShare(light, distance, -centre) / distanceSquared), density,
                       spread);
}

// What a ray meets of a sized light, unless something stands before it.
struct LightSeen {
    vec3 radiance;
    float density;  // of the ray's direction in sampleLight from its origin
};

// A sun's disc outshines all else so much that no screen shows it and any mirror of it flickers.
const float kMostSeen = 400.0;

LightSeen seeLight(int number, Ray ray, float nearest, bool camera) {
    Light light = fetchLight(number);
    LightSeen none = LightSeen(vec3(0.0), 0.0);
    if (camera && !light.seen) return none;
    if (light.type == VITRINE_LIGHT_SUN) {
        // Of unit vectors, the square of the difference is twice that number, and exact where the
        // cosine is not.
        vec3 off = ray.direction + light.axis;
        bool met = nearest >= kInfinity && dot(off, off) < 2.0 * light.narrowness;
        float sineSquared = light.narrowness * (2.0 - light.narrowness);
        return met ? LightSeen(light.power / (kPi * sineSquared), 1.0 / (2.0 * kPi * light.narrowness))
                   : none;
    }
    vec3 way = light.at - ray.origin;
    if (light.type == VITRINE_LIGHT_RECT) {
        float cosine = -dot(ray.direction, light.axis);
        float t = -dot(way, light.axis) / max(cosine, 1.0e-6);
        vec3 at = t * ray.direction - way;
        vec2 halves = vec2(dot(light.edgeX, light.edgeX), dot(light.edgeY, light.edgeY));
        vec2 place = abs(vec2(dot(at, light.edgeX), dot(at, light.edgeY)));
        bool met = cosine > 0.0 && t > 0.0 && t < nearest && all(lessThan(place, halves));
        float area = 4.0 * sqrt(halves.x * halves.y);
        return met ? LightSeen(light.power * lampShare(light, t, ray.direction) / area,
                               t * t / (area * cosine))
                   : none;
    }
    float along = dot(way, ray.direction);
    vec3 miss = way - along * ray.direction;
    float inside = square(light.radius) - dot(miss, miss);
    float distanceSquared = dot(way, way);
    bool met = inside > 0.0 && along > 0.0 && along - sqrt(max(inside, 0.0)) < nearest &&
               distanceSquared > square(light.radius);
    float distance = sqrt(distanceSquared);
    vec3 radiance = light.power * lampShare(light, distance, -way / distance) /
                    (kPi * square(light.radius));
    return met ? LightSeen(radiance, 1.0 / (2.0 * kPi *
                                            sphereNarrowness(light.radius, distanceSquared)))
               : none;
}
