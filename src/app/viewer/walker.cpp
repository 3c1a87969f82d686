// SPDX-License-Identifier: MIT
#include "app/viewer/walker.hpp"

#include <algorithm>
#include <cmath>

#include "app/viewer/camera_control.hpp"

namespace vitrine {
namespace {

constexpr glm::vec3 kUp(0, 1, 0);
constexpr float kHighestEye = 2;       // m: who is higher flies
constexpr float kLowestEye = 0.05f;    // m
constexpr float kGrounded = 0.6f;      // least height of a ground's unit normal
constexpr float kFlyingRadius = 0.1f;  // m
constexpr float kSettling = 0.08f;     // s to go to 1/e of a step
constexpr float kFallingSpeed = 6;     // m/s
constexpr float kCloseEnough = 1e-3f;  // m
constexpr int kContacts = 4;           // walls that one step may slide along

std::optional<float> groundBelow(glm::vec3 eye, float reach, const Probe& probe) {
    const ProbeRay ray{eye, -kUp, reach};
    const auto hit = probe(std::span(&ray, 1)).front();
    return hit ? std::optional(hit->distance) : std::nullopt;
}

/// Where the rays of a body start: in its middle and, as far as there is room, on both sides.
std::vector<glm::vec3> feelers(glm::vec3 eye, glm::vec3 way, const Body& body, const Probe& probe) {
    glm::vec3 aside = glm::cross(way, kUp);
    if (glm::length(aside) < 1e-4f) aside = {1, 0, 0};
    aside = glm::normalize(aside);
    const float reach = 0.9f * body.radius;
    std::vector<float> heights{0};
    if (body.height > body.step) {
        heights.push_back(0.5f * (body.height - body.step));
        heights.push_back(body.height - 1.02f * body.step);
    }
    std::vector<ProbeRay> rays;
    for (const float below : heights)
        for (const float side : {-1.0f, 1.0f})
            rays.push_back({eye - below * kUp, side * aside, reach});
    const auto hits = probe(rays);
    std::vector<glm::vec3> starts;
    for (const float below : heights) starts.push_back(eye - below * kUp);
    for (size_t i = 0; i < rays.size(); ++i) {
        const float room = hits[i] ? 0.9f * hits[i]->distance : reach;
        for (const float share : {0.5f, 1.0f})
            starts.push_back(rays[i].origin + share * room * rays[i].direction);
    }
    return starts;
}

}  // namespace

Body bodyOf(float eyeHeight) {
    Body body;
    const float share = std::min(eyeHeight / body.height, 1.0f);
    return {share * body.radius, std::min(eyeHeight, body.height), share * body.step};
}

glm::vec3 freeShift(glm::vec3 eye, glm::vec3 shift, const Body& body, bool grounded,
                    const Probe& probe) {
    glm::vec3 at = eye;
    std::optional<glm::vec3> lastWall;
    for (int contact = 0; contact < kContacts; ++contact) {
        const float length = glm::length(shift);
        if (length < 1e-6f) break;
        const glm::vec3 way = shift / length;
        std::vector<ProbeRay> rays;
        for (const glm::vec3& start : feelers(at, way, body, probe))
            rays.push_back({start, way, length + 8 * body.radius});
        const auto hits = probe(rays);
        float free = length;
        glm::vec3 wall(0);
        for (size_t i = 0; i < rays.size(); ++i) {
            if (!hits[i]) continue;
            glm::vec3 n = hits[i]->normal;
            if (grounded) {
                if (n.y > kGrounded) continue;
                n.y = 0;
                n = glm::length(n) > 1e-3f ? glm::normalize(n) : -way;
            }
            const float closing = -glm::dot(way, n);
            if (closing < 1e-3f) continue;
            // From the middle of the body to the wall, as if that were a plane.
            const glm::vec3 touched = rays[i].origin + hits[i]->distance * way;
            glm::vec3 apart = at - touched;
            if (grounded) apart.y = 0;
            const float room = std::max(0.0f, (glm::dot(apart, n) - body.radius) / closing);
            if (room < free) {
                free = room;
                wall = n;
            }
        }
        at += free * way;
        if (free >= length) break;
        shift = (length - free) * way;
        shift -= glm::dot(shift, wall) * wall;
        // Out of a corner there is only the way along both walls.
        if (lastWall && glm::dot(shift, *lastWall) < 0) {
            const glm::vec3 edge = glm::cross(wall, *lastWall);
            if (glm::length(edge) < 1e-3f) break;
            shift = glm::dot(shift, edge) / glm::dot(edge, edge) * edge;
            if (grounded) shift.y = 0;
        }
        lastWall = wall;
    }
    return at - eye;
}

void Walker::stand(const Camera& camera, const Probe& probe) {
    eyeHeight_ = groundBelow(camera.eye, kHighestEye, probe);
    if (eyeHeight_) eyeHeight_ = std::max(*eyeHeight_, kLowestEye);
    settled_ = true;
}

bool Walker::go(Camera& camera, glm::vec3 metres, float elapsed, const Probe& probe) {
    const bool carried =
        !eye_ || glm::distance(*eye_, camera.eye) > 1e-5f * glm::length(camera.eye);
    if (metres == glm::vec3(0) && (settled_ || carried)) return false;
    if (carried || !eyeHeight_) stand(camera, probe);
    const bool moved =
        eyeHeight_ ? walk(camera, metres, elapsed, probe) : fly(camera, metres, probe);
    eye_ = camera.eye;
    return moved;
}

bool Walker::fly(Camera& camera, glm::vec3 metres, const Probe& probe) {
    Camera wanted = camera;
    vitrine::walk(wanted, metres, true);
    const Body ball{kFlyingRadius, 0, 0};
    const glm::vec3 shift = freeShift(camera.eye, wanted.eye - camera.eye, ball, false, probe);
    camera.eye += shift;
    camera.target += shift;
    return glm::length(shift) > 0;
}

bool Walker::walk(Camera& camera, glm::vec3 metres, float elapsed, const Probe& probe) {
    const Camera before = camera;
    const float height = std::max(*eyeHeight_ + metres.y, kLowestEye);
    const Body body = bodyOf(height);
    Camera wanted = camera;
    vitrine::walk(wanted, {metres.x, 0, metres.z}, false);
    glm::vec3 shift = wanted.eye - camera.eye;
    shift.y = 0;
    shift = freeShift(camera.eye, shift, body, true, probe);
    // As if the eye had its height already, however far it is behind on a stair.
    const float reach = 4 * kHighestEye;
    auto ground = groundBelow(camera.eye + shift, reach, probe);
    if (ground && height - *ground > body.step) {
        // Too high to climb: it stays where it is.
        shift = glm::vec3(0);
        ground = groundBelow(camera.eye, reach, probe);
    }
    eyeHeight_ = height;
    const float rise = ground ? height - *ground : metres.y;
    float lift = rise * (1 - std::exp(-elapsed / kSettling));
    lift = std::max(lift, -kFallingSpeed * elapsed);
    settled_ = !ground || std::abs(rise - lift) < kCloseEnough;
    shift.y = settled_ ? rise : lift;
    camera.eye += shift;
    camera.target += shift;
    if (height > kHighestEye) eyeHeight_.reset();  // it has taken off
    return camera.eye != before.eye;
}

}  // namespace vitrine
