// SPDX-License-Identifier: MIT
#include "app/viewer/handle_math.hpp"

#include <algorithm>
#include <cmath>

namespace vitrine {
namespace {

constexpr float kSnapLength = 0.1f, kSnapDegrees = 15, kSnapScale = 0.1f;
constexpr float kLeastFactor = 0.01f;  // a drag through the middle must not turn a node inside out
constexpr float kEdgeOn = 0.2f;  // sine of the angle to a ring's plane below which it is a line
constexpr float kDegreeStep = 0.1f, kScaleStep = 0.005f;

float snapped(float value, float step) {
    return tidy(std::round(value / step) * step, step);
}

/// The same angle, less than half a turn from `near`.
float wrapped(float degrees, float near) {
    return near + std::remainder(degrees - near, 360.0f);
}

float distanceOf(glm::vec3 a, glm::vec3 b) {
    const glm::vec3 d = glm::abs(a - b);
    return d.x + d.y + d.z;
}

}  // namespace

glm::mat3 rotationOf(glm::vec3 degrees) {
    const glm::vec3 r = glm::radians(degrees);
    return glm::mat3_cast(glm::angleAxis(r.z, glm::vec3(0, 0, 1)) *
                          glm::angleAxis(r.y, glm::vec3(0, 1, 0)) *
                          glm::angleAxis(r.x, glm::vec3(1, 0, 0)));
}

glm::vec3 anglesOf(const glm::mat3& rotation, glm::vec3 near) {
    const float sine = std::clamp(-rotation[0][2], -1.0f, 1.0f);
    const float cosine = std::hypot(rotation[0][0], rotation[0][1]);
    const float y = std::atan2(sine, cosine);
    float x = glm::radians(near.x), z = 0;
    if (cosine > 1e-4f) {
        x = std::atan2(rotation[1][2], rotation[2][2]);
        z = std::atan2(rotation[0][1], rotation[0][0]);
    } else {
        // x and z turn about the same axis: x stays as it was.
        z = sine > 0 ? x + std::atan2(-rotation[1][0], rotation[1][1])
                     : -x + std::atan2(-rotation[1][0], rotation[1][1]);
    }
    const auto close = [&](glm::vec3 degrees) {
        return glm::vec3(wrapped(degrees.x, near.x), wrapped(degrees.y, near.y),
                         wrapped(degrees.z, near.z));
    };
    const glm::vec3 one = glm::degrees(glm::vec3(x, y, z));
    const glm::vec3 a = close(one), b = close({one.x + 180, 180 - one.y, one.z + 180});
    return distanceOf(a, near) <= distanceOf(b, near) ? a : b;
}

std::optional<float> nearestOnLine(const Sight& sight, glm::vec3 origin, glm::vec3 axis) {
    const glm::vec3 d = glm::normalize(sight.direction), w = origin - sight.origin;
    const float along = glm::dot(axis, d);
    const float square = glm::dot(axis, axis) - along * along;
    if (square < 1e-5f * glm::dot(axis, axis)) return {};
    return (along * glm::dot(d, w) - glm::dot(axis, w)) / square;
}

std::optional<glm::vec2> meetingPlane(const Sight& sight, glm::vec3 origin, glm::vec3 a,
                                      glm::vec3 b) {
    const glm::vec3 normal = glm::cross(a, b);
    const float facing = glm::dot(normal, sight.direction);
    if (std::abs(facing) < 1e-4f * glm::length(normal) * glm::length(sight.direction)) return {};
    const float t = glm::dot(normal, origin - sight.origin) / facing;
    if (t <= 0) return {};
    const glm::vec3 p = sight.origin + t * sight.direction - origin;
    const float square = glm::dot(normal, normal);
    return glm::vec2(glm::dot(glm::cross(p, b), normal), glm::dot(glm::cross(a, p), normal)) /
           square;
}

float tidy(float value, float step) {
    if (!(step > 0) || !std::isfinite(value)) return value;
    // In double, so that a tenth becomes the float that is written as 0.1.
    const double decimals = std::ceil(-std::log10(static_cast<double>(step)) - 1e-6);
    const double power = std::pow(10.0, std::clamp(decimals, -6.0, 9.0));
    const double result = std::round(static_cast<double>(value) * power) / power;
    return static_cast<float>(result == 0 ? 0.0 : result);
}

glm::vec3 handleAxis(HandleMode mode, const Place& place, const glm::mat4& worldFromParent,
                     int axis) {
    glm::vec3 local(0);
    local[axis] = 1;
    if (mode == HandleMode::kScale) local = rotationOf(place.rotate) * local;
    return glm::mat3(worldFromParent) * local;
}

HandleDrag::HandleDrag(const Setting& setting, const Sight& grabbed)
    : setting_(setting),
      grabbed_(grabbed),
      centre_(setting.worldFromParent * glm::vec4(setting.place.at, 1)) {
    if (setting.mode != HandleMode::kTurn) return;
    const int i = setting.handle.axis;
    const auto axis = [&](int k) {
        return handleAxis(setting.mode, setting.place, setting.worldFromParent, k % 3);
    };
    const glm::vec3 normal = glm::normalize(glm::cross(axis(i + 1), axis(i + 2)));
    edgeOn_ = std::abs(glm::dot(normal, glm::normalize(grabbed.direction))) < kEdgeOn;
    // Of a ring that is seen as a line the near side is grabbed; it is pulled along the line.
    if (edgeOn_) {
        const glm::mat3 parentFromWorld = glm::inverse(glm::mat3(setting.worldFromParent));
        const glm::vec3 near = parentFromWorld * -grabbed.direction;
        grabbedAngle_ = std::atan2(near[(i + 2) % 3], near[(i + 1) % 3]);
        lastAngle_ = angleOf(grabbed).value_or(0);
    } else {
        grabbedAngle_ = lastAngle_ = angleOf(grabbed).value_or(0);
    }
}

Place HandleDrag::to(const Sight& sight, bool snap) {
    switch (setting_.mode) {
        case HandleMode::kMove:
            return moved(sight, snap);
        case HandleMode::kTurn:
            return turnedTo(sight, snap);
        case HandleMode::kScale:
            break;
    }
    return scaled(sight, snap);
}

glm::vec3 HandleDrag::onScreenPlane(const Sight& sight) const {
    const auto at = meetingPlane(sight, centre_, setting_.view.right, setting_.view.up);
    return at ? at->x * setting_.view.right + at->y * setting_.view.up : glm::vec3(0);
}

Place HandleDrag::moved(const Sight& sight, bool snap) const {
    Place result = setting_.place;
    const auto axis = [&](int k) {
        return handleAxis(setting_.mode, setting_.place, setting_.worldFromParent, k % 3);
    };
    glm::vec3 way(0);
    const int i = setting_.handle.axis, j = (i + 1) % 3, k = (i + 2) % 3;
    if (setting_.handle.kind == Handle::Kind::kMiddle) {
        const glm::vec3 world = onScreenPlane(sight) - onScreenPlane(grabbed_);
        way = glm::inverse(glm::mat3(setting_.worldFromParent)) * world;
    } else if (setting_.handle.kind == Handle::Kind::kPlane) {
        const auto from = meetingPlane(grabbed_, centre_, axis(j), axis(k));
        const auto to = meetingPlane(sight, centre_, axis(j), axis(k));
        if (!from || !to) return result;
        way[j] = to->x - from->x;
        way[k] = to->y - from->y;
    } else {
        const auto from = nearestOnLine(grabbed_, centre_, axis(i));
        const auto to = nearestOnLine(sight, centre_, axis(i));
        if (!from || !to) return result;
        way[i] = *to - *from;
    }
    for (int c = 0; c < 3; ++c) {
        if (way[c] == 0) continue;
        const float value = result.at[c] + way[c];
        result.at[c] =
            snap ? snapped(value, kSnapLength) : tidy(value, setting_.pixel / glm::length(axis(c)));
    }
    return result;
}

std::optional<float> HandleDrag::angleOf(const Sight& sight) const {
    const int i = setting_.handle.axis;
    const glm::vec3 a =
        handleAxis(setting_.mode, setting_.place, setting_.worldFromParent, (i + 1) % 3);
    const glm::vec3 b =
        handleAxis(setting_.mode, setting_.place, setting_.worldFromParent, (i + 2) % 3);
    if (edgeOn_) {
        const glm::vec3 tangent = -std::sin(grabbedAngle_) * a + std::cos(grabbedAngle_) * b;
        const auto along = nearestOnLine(sight, centre_, tangent);
        if (!along) return {};
        return *along * glm::length(tangent) / setting_.reach;
    }
    const auto at = meetingPlane(sight, centre_, a, b);
    if (!at || *at == glm::vec2(0)) return {};
    return std::atan2(at->y, at->x);
}

Place HandleDrag::turnedTo(const Sight& sight, bool snap) {
    const auto angle = angleOf(sight);
    if (angle) {
        const float step =
            edgeOn_ ? *angle - lastAngle_ : std::remainder(*angle - lastAngle_, 2 * kPi);
        turned_ += glm::degrees(step);
        lastAngle_ = *angle;
    }
    const float degrees = snap ? snapped(turned_, kSnapDegrees) : tidy(turned_, kDegreeStep);
    Place result = setting_.place;
    const int i = setting_.handle.axis;
    if (i == 2) {  // the outermost
        result.rotate.z = tidy(result.rotate.z + degrees, kDegreeStep);
        return result;
    }
    glm::vec3 about(0);
    about[i] = degrees;
    const glm::vec3 angles =
        anglesOf(rotationOf(about) * rotationOf(setting_.place.rotate), setting_.place.rotate);
    for (int c = 0; c < 3; ++c) result.rotate[c] = tidy(angles[c], 0.1f * kDegreeStep);
    return result;
}

Place HandleDrag::scaled(const Sight& sight, bool snap) const {
    Place result = setting_.place;
    const bool all = setting_.handle.kind == Handle::Kind::kMiddle;
    float factor = 1;
    if (all) {
        // Right and up is larger, in doublings by the handles' length.
        const glm::vec3 way = onScreenPlane(sight) - onScreenPlane(grabbed_);
        const float along = glm::dot(way, setting_.view.right + setting_.view.up);
        factor = std::exp2(along / setting_.reach);
    } else {
        const glm::vec3 axis = handleAxis(setting_.mode, setting_.place, setting_.worldFromParent,
                                          setting_.handle.axis);
        const auto from = nearestOnLine(grabbed_, centre_, axis);
        const auto to = nearestOnLine(sight, centre_, axis);
        if (!from || !to || *from == 0) return result;
        factor = *to / *from;
    }
    factor = std::max(factor, kLeastFactor);
    if (all && snap) {  // the largest goes in steps, the others with it
        const glm::vec3 size = glm::abs(result.scale);
        const float largest = std::max({size.x, size.y, size.z});
        factor = std::max(snapped(factor * largest, kSnapScale), kSnapScale) / largest;
    }
    for (int c = 0; c < 3; ++c) {
        if (!all && c != setting_.handle.axis) continue;
        const float before = std::abs(result.scale[c]), value = before * factor;
        const float size = snap && !all ? std::max(snapped(value, kSnapScale), kSnapScale)
                                        : std::max(tidy(value, kScaleStep * before), 1e-6f);
        result.scale[c] = std::copysign(size, result.scale[c]);
    }
    return result;
}

}  // namespace vitrine
