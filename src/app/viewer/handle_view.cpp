// SPDX-License-Identifier: MIT
#include "app/viewer/handle_view.hpp"

#include <algorithm>
#include <cmath>

namespace vitrine {
namespace {

using Kind = Handle::Kind;

constexpr float kLength = 92;   // ImGui units
constexpr float kPart = 0.22f;  // of a small picture, at most
constexpr float kGrip = 7;      // units beside a line that a hand still finds
// A ring that is seen from its front, or nearly so, is seen all round.
constexpr float kBehind = 0.25f;

float distanceToSegment(glm::vec2 p, glm::vec2 a, glm::vec2 b) {
    const glm::vec2 d = b - a;
    const float square = glm::dot(d, d);
    const float t = square > 0 ? std::clamp(glm::dot(p - a, d) / square, 0.0f, 1.0f) : 0;
    return glm::distance(p, a + t * d);
}

}  // namespace

HandleView::HandleView(HandleMode mode, const Place& place, const glm::mat4& worldFromParent,
                       const Projection& projection, float unit)
    : mode_(mode),
      place_(place),
      worldFromParent_(worldFromParent),
      projection_(projection),
      unit_(unit),
      centre_(worldFromParent * glm::vec4(place.at, 1)) {
    if (!projection.place(centre_)) return;
    const glm::vec2 size = projection.pictureSize();
    const float length = std::min(kLength * unit, kPart * std::min(size.x, size.y));
    reach_ = length * projection.metresPerUnit(centre_);
}

glm::vec3 HandleView::unitAxis(int axis) const {
    return glm::normalize(handleAxis(mode_, place_, worldFromParent_, axis));
}

std::optional<glm::vec2> HandleView::onAxes(glm::vec3 lengths) const {
    glm::vec3 p = centre_;
    for (int i = 0; i < 3; ++i) p += reach_ * lengths[i] * unitAxis(i);
    return projection_.place(p);
}

glm::vec3 HandleView::onRing(int axis, float angle) const {
    // The ring is round in the parent: an ellipse in a world that it is scaled unevenly in.
    const glm::vec3 a = handleAxis(mode_, place_, worldFromParent_, (axis + 1) % 3);
    const glm::vec3 b = handleAxis(mode_, place_, worldFromParent_, (axis + 2) % 3);
    const float longest = std::max(glm::length(a), glm::length(b));
    return centre_ + kRing * reach_ / longest * (std::cos(angle) * a + std::sin(angle) * b);
}

bool HandleView::isBehind(glm::vec3 onRing) const {
    const glm::vec3 away = glm::normalize(centre_ - projection_.eye());
    return glm::dot(onRing - centre_, away) > kBehind * reach_;
}

float HandleView::clarity(Handle handle) const {
    if (handle.kind == Kind::kMiddle || mode_ == HandleMode::kTurn) return 1;
    const glm::vec3 view = glm::normalize(centre_ - projection_.eye());
    const glm::vec3 axis = handle.kind == Kind::kAxis
                               ? unitAxis(handle.axis)
                               : glm::normalize(glm::cross(unitAxis((handle.axis + 1) % 3),
                                                           unitAxis((handle.axis + 2) % 3)));
    const float along = std::abs(glm::dot(axis, view));
    const float seen =
        handle.kind == Kind::kAxis ? std::sqrt(std::max(0.0f, 1 - along * along)) : along;
    return glm::smoothstep(0.10f, 0.25f, seen);
}

std::vector<Handle> HandleView::all() const {
    std::vector<Handle> list;
    if (mode_ != HandleMode::kTurn) list.push_back({Kind::kMiddle, 0});
    for (int i = 0; i < 3; ++i)
        if (mode_ == HandleMode::kMove) list.push_back({Kind::kPlane, i});
    for (int i = 0; i < 3; ++i) list.push_back({Kind::kAxis, i});
    return list;
}

std::optional<std::array<glm::vec2, 4>> HandleView::planeCorners(int axis) const {
    std::array<glm::vec2, 4> corners{};
    size_t n = 0;
    for (const glm::vec2 c : {glm::vec2(kPlaneBegin, kPlaneBegin),
                              {kPlaneEnd, kPlaneBegin},
                              {kPlaneEnd, kPlaneEnd},
                              {kPlaneBegin, kPlaneEnd}}) {
        glm::vec3 lengths(0);
        lengths[(axis + 1) % 3] = c.x;
        lengths[(axis + 2) % 3] = c.y;
        const auto place = onAxes(lengths);
        if (!place) return {};
        corners[n++] = *place;
    }
    return corners;
}

std::optional<float> HandleView::distance(Handle handle, glm::vec2 place) const {
    if (handle.kind == Kind::kMiddle) {
        const auto middle = projection_.place(centre_);
        return std::max(0.0f, glm::distance(place, *middle) - kMiddle * unit_);
    }
    if (handle.kind == Kind::kPlane) {
        const auto quad = planeCorners(handle.axis);
        if (!quad) return {};
        const std::array<glm::vec2, 4>& corners = *quad;
        const bool left = turnAt(corners[0], corners[1], place) > 0;
        for (size_t i = 1; i < 4; ++i)
            if ((turnAt(corners[i], corners[(i + 1) % 4], place) > 0) != left) return {};
        return 0;
    }
    if (mode_ != HandleMode::kTurn) {
        glm::vec3 end(0);
        end[handle.axis] = 1;
        const auto a = onAxes(kShaftBegin * end), b = onAxes(end);
        if (!a || !b) return {};
        return distanceToSegment(place, *a, *b);
    }
    std::optional<float> nearest;
    for (int i = 0; i < kRingParts; ++i) {
        const float step = 2 * kPi / kRingParts;
        const glm::vec3 from = onRing(handle.axis, step * static_cast<float>(i));
        if (isBehind(from)) continue;
        const auto a = projection_.place(from),
                   b = projection_.place(onRing(handle.axis, step * static_cast<float>(i + 1)));
        if (!a || !b) continue;
        const float d = distanceToSegment(place, *a, *b);
        if (!nearest || d < *nearest) nearest = d;
    }
    return nearest;
}

std::optional<Handle> HandleView::at(glm::vec2 place) const {
    if (hidden()) return {};
    std::optional<Handle> best;
    float least = kGrip * unit_;
    for (const Handle handle : all()) {
        if (clarity(handle) < 0.3f) continue;
        const auto d = distance(handle, place);
        if (!d || *d >= least) continue;
        best = handle;
        least = *d;
        // What lies in the middle of others goes before them.
        if (handle.kind != Kind::kAxis) least = std::min(least, 0.5f);
    }
    return best;
}

}  // namespace vitrine
