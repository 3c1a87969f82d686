// SPDX-License-Identifier: MIT
#include "mesh/triangulate.hpp"

#include <algorithm>
#include <cmath>

namespace vitrine {
namespace {

/// Twice the signed area.
double cross(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// The polygon's normal, twice its area long (Newell's method): right for concave polygons, and a
/// mean for those that are not quite flat.
glm::dvec3 newellNormal(std::span<const glm::vec3> polygon) {
    glm::dvec3 normal(0.0);
    const glm::dvec3 origin(polygon[0]);
    glm::dvec3 a = glm::dvec3(polygon.back()) - origin;
    for (const glm::vec3& p : polygon) {
        const glm::dvec3 b = glm::dvec3(p) - origin;
        normal += glm::cross(a, b);
        a = b;
    }
    return normal;
}

}  // namespace

/// Drops the axis the normal is longest along, which loses no bit of the others. Swaps them where
/// needed so that the polygon winds counter-clockwise.
void Triangulator::project(std::span<const glm::vec3> polygon) {
    const glm::dvec3 n = newellNormal(polygon);
    const glm::dvec3 size = glm::abs(n);
    const int drop = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
    int u = (drop + 1) % 3, v = (drop + 2) % 3;
    if (n[drop] < 0.0) std::swap(u, v);
    const auto count = static_cast<uint32_t>(polygon.size());
    ring_.clear();
    for (uint32_t i = 0; i < count; ++i)
        ring_.push_back({{polygon[i][u], polygon[i][v]},
                         i == 0 ? count - 1 : i - 1,
                         i + 1 == count ? 0 : i + 1,
                         0,
                         false});
}

/// Positive at outward corners; zero too if the triangle there would be a sliver, so that corners
/// in one line are left to be seen from elsewhere.
double Triangulator::turn(uint32_t corner) const {
    const Corner& c = ring_[corner];
    const glm::dvec2 &a = ring_[c.previous].at, &b = ring_[c.next].at;
    const double area = cross(a, c.at, b);
    const double longest = std::max(
        {glm::dot(c.at - a, c.at - a), glm::dot(b - c.at, b - c.at), glm::dot(b - a, b - a)});
    return std::abs(area) > 1e-7 * longest ? area : 0.0;
}

/// Only inward corners can lie in the triangle of an outward one.
void Triangulator::findInward() {
    inward_.clear();
    for (uint32_t i = 0; i < ring_.size(); ++i)
        if (turn(i) <= 0.0) inward_.push_back(i);
}

bool Triangulator::isEar(uint32_t corner) {
    if (turn(corner) <= 0.0) return false;
    const Corner& c = ring_[corner];
    const glm::dvec2 &a = ring_[c.previous].at, &b = c.at, &d = ring_[c.next].at;
    for (size_t i = 0; i < inward_.size(); ++i) {
        const Corner& p = ring_[inward_[i]];
        if (p.clipped) {
            inward_[i--] = inward_.back();
            inward_.pop_back();
            continue;
        }
        if (budget_ == 0) return true;
        --budget_;
        // A corner at the same place is a bridge to a hole, not an obstacle.
        if (p.at == a || p.at == b || p.at == d) continue;
        if (cross(a, b, p.at) >= 0.0 && cross(b, d, p.at) >= 0.0 && cross(d, a, p.at) >= 0.0)
            return false;
    }
    return true;
}

/// A corner's last place in the queue is the one that counts. Neighbours of a clipped ear go to the
/// back, so that ears are taken all around the polygon and triangles stay compact.
void Triangulator::enqueue(uint32_t corner) {
    ring_[corner].queuedAt = queue_.size();
    queue_.push_back(corner);
}

void Triangulator::clip(uint32_t corner, std::vector<glm::uvec3>& triangles) {
    Corner& c = ring_[corner];
    triangles.emplace_back(c.previous, corner, c.next);
    ring_[c.previous].next = c.next;
    ring_[c.next].previous = c.previous;
    c.clipped = true;
}

void Triangulator::triangulate(std::span<const glm::vec3> polygon,
                               std::vector<glm::uvec3>& triangles) {
    const auto count = static_cast<uint32_t>(polygon.size());
    if (count < 3) return;
    const bool usable = std::all_of(polygon.begin(), polygon.end(), isFinite);
    if (count == 3 || !usable || exhausted()) {
        for (uint32_t i = 2; i < count; ++i) triangles.emplace_back(0, i - 1, i);
        return;
    }
    project(polygon);
    findInward();

    uint32_t left = count;
    while (left > 3) {
        const uint32_t before = left;
        queue_.clear();
        for (uint32_t i = 0; i < count; ++i)
            if (!ring_[i].clipped) enqueue(i);
        for (size_t i = 0; i < queue_.size() && left > 3; ++i) {
            const uint32_t corner = queue_[i];
            if (ring_[corner].clipped || ring_[corner].queuedAt != i || !isEar(corner)) continue;
            clip(corner, triangles);
            enqueue(ring_[corner].previous);
            enqueue(ring_[corner].next);
            --left;
        }
        // No ear: the polygon crosses itself or what is left lies in one line. Any corner will do.
        if (left == before) {
            clip(queue_.front(), triangles);
            --left;
        }
    }
    const auto last = static_cast<uint32_t>(
        std::find_if(ring_.begin(), ring_.end(), [](const Corner& c) { return !c.clipped; }) -
        ring_.begin());
    triangles.emplace_back(ring_[last].previous, last, ring_[last].next);
}

}  // namespace vitrine
