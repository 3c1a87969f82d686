// SPDX-License-Identifier: MIT
#include "app/viewer/way_round.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace vitrine {
namespace {

constexpr int kParts = 12;          // straight pieces that a curved way is tested by
constexpr float kNarrower = 0.75f;  // this much of a bend is free, too: nothing is grazed
constexpr float kThin = 0.02f, kLongest = 4, kMostTilt = 0.75f, kMargin = 1.04f;

void addWay(const Flight& flight, std::vector<ProbeRay>& rays) {
    for (int i = 0; i < kParts; ++i) {
        const glm::vec3 a = flight.eyeAt(static_cast<float>(i) / kParts);
        const glm::vec3 b = flight.eyeAt(static_cast<float>(i + 1) / kParts);
        const float length = glm::distance(a, b);
        const glm::vec3 way = length > 0 ? (b - a) / length : glm::vec3(0, 1, 0);
        rays.push_back({a, way, length});
    }
}

bool noneHit(std::span<const std::optional<ProbeHit>> hits) {
    return std::none_of(hits.begin(), hits.end(), [](const auto& hit) { return hit.has_value(); });
}

}  // namespace

bool isFree(const Flight& flight, const Probe& probe) {
    std::vector<ProbeRay> rays;
    addWay(flight, rays);
    return noneHit(probe(rays));
}

std::optional<glm::vec3> wayRound(const Camera& from, const Camera& to, const Probe& probe) {
    const glm::vec3 way = to.eye - from.eye;
    const float length = glm::length(way);
    if (!(length > 1e-4f) || isFree(Flight(from, to, 1), probe)) return {};
    const glm::vec3 up(0, 1, 0);
    glm::vec3 side = glm::cross(way / length, up);
    side = glm::length(side) > 1e-3f ? glm::normalize(side) : glm::vec3(1, 0, 0);
    const glm::vec3 over = glm::normalize(glm::cross(side, way / length));
    const glm::vec3 middle = 0.5f * (from.eye + to.eye);
    std::vector<glm::vec3> points;
    std::vector<ProbeRay> rays;
    for (const float amount : {0.2f, 0.4f, 0.7f, 1.1f, 1.8f})
        for (const glm::vec3& direction :
             {over, side, -side, glm::normalize(over + side), glm::normalize(over - side), -over}) {
            points.push_back(middle + amount * length * direction);
            for (const float share : {1.0f, kNarrower}) {
                Flight flight(from, to, 1);
                flight.bendThrough(glm::mix(middle, points.back(), share));
                addWay(flight, rays);
            }
        }
    const auto hits = probe(rays);
    constexpr size_t kRays = 2 * kParts;
    for (size_t i = 0; i < points.size(); ++i)
        if (noneHit(std::span(hits).subspan(i * kRays, kRays))) return points[i];
    return {};
}

std::optional<Screen> screenOf(const Aabb& box, const glm::mat4& worldFromBox, glm::vec3 eye) {
    if (box.empty()) return {};
    std::array<glm::vec3, 3> edges;
    std::array<size_t, 3> order{0, 1, 2};
    for (size_t i = 0; i < 3; ++i)
        edges[i] = glm::vec3(worldFromBox[static_cast<int>(i)]) * box.extent()[static_cast<int>(i)];
    std::sort(order.begin(), order.end(),
              [&](size_t a, size_t b) { return glm::length(edges[a]) < glm::length(edges[b]); });
    const float thickness = glm::length(edges[order[0]]), shorter = glm::length(edges[order[1]]),
                longer = glm::length(edges[order[2]]);
    if (!(shorter > 0) || thickness >= kThin * shorter || longer > kLongest * shorter) return {};
    glm::vec3 a = edges[order[1]] / shorter, b = edges[order[2]] / longer;
    if (std::abs(glm::dot(a, b)) > 0.02f) return {};  // sheared: no rectangle
    Screen screen{};
    screen.centre = glm::vec3(worldFromBox * glm::vec4(box.centre(), 1));
    screen.normal = glm::normalize(glm::cross(a, b));
    if (glm::dot(screen.normal, eye - screen.centre) < 0) screen.normal = -screen.normal;
    if (std::abs(screen.normal.y) > kMostTilt) return {};
    // The edge that is more upright is up.
    float height = shorter, width = longer;
    if (std::abs(b.y) > std::abs(a.y)) {
        std::swap(a, b);
        std::swap(height, width);
    }
    screen.up = a.y < 0 ? -a : a;
    screen.right = glm::cross(screen.up, screen.normal);
    screen.width = width;
    screen.height = height;
    return screen;
}

Camera squareInFront(const Camera& camera, const Screen& screen, float aspect) {
    Camera result = camera;
    const float height = heightAtUnitDistance(camera, aspect);
    const float tall = std::max(screen.height, screen.width / aspect);
    result.target = screen.centre;
    if (std::abs(screen.right.y) > 1e-3f) result.up = screen.up;  // it hangs askew
    result.eye = screen.centre + kMargin * tall / height * screen.normal;
    return result;
}

bool isSeen(const Screen& screen, const Camera& camera, const Probe& probe) {
    const glm::vec3 way = screen.centre - camera.eye;
    const float length = glm::length(way);
    const ProbeRay ray{camera.eye, way / length, 0.97f * length};
    return !probe(std::span(&ray, 1)).front();
}

}  // namespace vitrine
