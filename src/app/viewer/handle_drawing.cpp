// SPDX-License-Identifier: MIT
// How handles look.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/viewer/handle_view.hpp"

namespace vitrine {
namespace {

using Kind = Handle::Kind;

constexpr std::array<unsigned, 3> kColors{IM_COL32(236, 78, 82, 255), IM_COL32(126, 200, 60, 255),
                                          IM_COL32(70, 140, 246, 255)};
constexpr unsigned kHot = IM_COL32(255, 210, 92, 255), kDead = IM_COL32(165, 165, 165, 255),
                   kWhite = IM_COL32(255, 255, 255, 255), kShadow = IM_COL32(0, 0, 0, 110);

ImVec2 imgui(glm::vec2 p) {
    return {p.x, p.y};
}

unsigned faded(unsigned color, float alpha) {
    const auto a = static_cast<float>(color >> IM_COL32_A_SHIFT) * std::clamp(alpha, 0.0f, 1.0f);
    return (color & ~IM_COL32_A_MASK) | (static_cast<unsigned>(a + 0.5f) << IM_COL32_A_SHIFT);
}

unsigned shaded(unsigned color, float light) {
    ImVec4 c = ImGui::ColorConvertU32ToFloat4(color);
    c.x *= light, c.y *= light, c.z *= light;
    return ImGui::ColorConvertFloat4ToU32(c);
}

/// The convex hull, in the order in which ImGui fills without seams (Andrew's monotone chain).
std::vector<ImVec2> hull(std::vector<glm::vec2> points) {
    std::sort(points.begin(), points.end(),
              [](glm::vec2 a, glm::vec2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
    std::vector<glm::vec2> chain;
    for (int side = 0; side < 2; ++side) {
        const size_t start = chain.size();
        for (const glm::vec2 p : points) {
            while (chain.size() >= start + 2 &&
                   turnAt(chain[chain.size() - 2], chain.back(), p) <= 0)
                chain.pop_back();
            chain.push_back(p);
        }
        chain.pop_back();
        std::reverse(points.begin(), points.end());
    }
    std::vector<ImVec2> result;
    for (const glm::vec2 p : chain) result.push_back(imgui(p));
    return result;
}

/// A line that can be told from any picture.
void drawLine(ImDrawList& list, glm::vec2 a, glm::vec2 b, unsigned color, float alpha,
              float width) {
    list.AddLine(imgui(a), imgui(b), faded(kShadow, alpha), width + 2);
    list.AddLine(imgui(a), imgui(b), faded(color, alpha), width);
}

}  // namespace

void HandleView::drawSolid(ImDrawList& list, const std::vector<glm::vec3>& points,
                           unsigned color) const {
    std::vector<glm::vec2> places;
    for (const glm::vec3& p : points)
        if (const auto place = projection_.place(p)) places.push_back(*place);
    if (places.size() < 3) return;
    const std::vector<ImVec2> outline = hull(std::move(places));
    list.AddConvexPolyFilled(outline.data(), static_cast<int>(outline.size()), color);
}

void HandleView::drawCone(ImDrawList& list, int axis, unsigned color, float alpha) const {
    const glm::vec3 along = unitAxis(axis);
    const glm::vec3 aside = glm::normalize(
        glm::cross(along, std::abs(along.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0)));
    const glm::vec3 other = glm::cross(along, aside);
    const glm::vec3 foot = centre_ + kTipBegin * reach_ * along;
    std::vector<glm::vec3> points;
    for (int i = 0; i < 20; ++i) {
        const float angle = 2 * kPi * static_cast<float>(i) / 20;
        points.push_back(foot +
                         kTipRadius * reach_ * (std::cos(angle) * aside + std::sin(angle) * other));
    }
    const bool fromBehind = glm::dot(along, foot - projection_.eye()) > 0;
    std::vector<glm::vec3> whole = points;
    whole.push_back(centre_ + reach_ * along);
    drawSolid(list, whole, faded(color, alpha));
    if (fromBehind) drawSolid(list, points, faded(shaded(color, 0.62f), alpha));
}

void HandleView::drawCube(ImDrawList& list, int axis, unsigned color, float alpha) const {
    glm::vec3 middle = centre_;
    if (axis >= 0) middle += (1 - kCube) * reach_ * unitAxis(axis);
    const float half = (axis >= 0 ? kCube : 1.2f * kCube) * reach_;
    for (int i = 0; i < 3; ++i)
        for (const float side : {-1.0f, 1.0f}) {
            const glm::vec3 n = side * unitAxis(i);
            const glm::vec3 face = middle + half * n;
            const float facing = glm::dot(n, glm::normalize(projection_.eye() - face));
            if (facing <= 0) continue;
            std::vector<glm::vec3> corners;
            for (const glm::vec2 c : {glm::vec2(-1, -1), {1, -1}, {1, 1}, {-1, 1}})
                corners.push_back(
                    face + half * (c.x * unitAxis((i + 1) % 3) + c.y * unitAxis((i + 2) % 3)));
            drawSolid(list, corners, faded(shaded(color, 0.6f + 0.4f * facing), alpha));
        }
}

void HandleView::drawAxis(ImDrawList& list, int axis, unsigned color, float alpha) const {
    const bool move = mode_ == HandleMode::kMove;
    glm::vec3 end(0);
    end[axis] = move ? kTipBegin : 1 - kCube;
    const auto a = onAxes(kShaftBegin / end[axis] * end), b = onAxes(end);
    if (!a || !b) return;
    drawLine(list, *a, *b, color, alpha, 2.5f * unit_);
    if (move)
        drawCone(list, axis, color, alpha);
    else
        drawCube(list, axis, color, alpha);
}

void HandleView::drawPlane(ImDrawList& list, int axis, unsigned color, bool hot,
                           float alpha) const {
    const auto quad = planeCorners(axis);
    if (!quad) return;
    std::array<ImVec2, 4> corners;
    std::transform(quad->begin(), quad->end(), corners.begin(), imgui);
    list.AddConvexPolyFilled(corners.data(), 4, faded(color, alpha * (hot ? 0.75f : 0.38f)));
    list.AddPolyline(corners.data(), 4, faded(color, alpha), ImDrawFlags_Closed, 1.5f * unit_);
}

void HandleView::drawRing(ImDrawList& list, int axis, unsigned color, float alpha, bool hot) const {
    const glm::vec3 away = centre_ - projection_.eye();
    std::vector<ImVec2> piece;
    const auto flush = [&] {
        const int count = static_cast<int>(piece.size());
        if (count > 1) {
            list.AddPolyline(piece.data(), count, faded(kShadow, alpha), 0, 4.5f * unit_);
            list.AddPolyline(piece.data(), count, faded(color, alpha), 0,
                             (hot ? 3.5f : 2.5f) * unit_);
        }
        piece.clear();
    };
    // Begun where the ring goes behind, so that the half in front is one line.
    const glm::vec3 a = onRing(axis, 0) - centre_, b = onRing(axis, kPi / 2) - centre_;
    const float farthest = std::atan2(glm::dot(b, away), glm::dot(a, away));
    std::vector<ImVec2> behind;
    for (int i = 0; i <= kRingParts; ++i) {
        const glm::vec3 p = onRing(axis, farthest + 2 * kPi / kRingParts * static_cast<float>(i));
        const auto place = projection_.place(p);
        if (!place) return;
        if (!isBehind(p)) piece.push_back(imgui(*place));
        behind.push_back(imgui(*place));
    }
    list.AddPolyline(behind.data(), static_cast<int>(behind.size()), faded(color, 0.22f * alpha), 0,
                     1.5f * unit_);
    flush();
}

void HandleView::drawMiddle(ImDrawList& list, bool hot, float alpha) const {
    const unsigned color = hot ? kHot : kWhite;
    if (mode_ == HandleMode::kScale) return drawCube(list, -1, color, alpha);
    const auto middle = projection_.place(centre_);
    if (!middle) return;
    const float radius = kMiddle * unit_;
    list.AddCircleFilled(imgui(*middle), radius, faded(kShadow, alpha));
    if (mode_ == HandleMode::kTurn)
        list.AddCircleFilled(imgui(*middle), 0.4f * radius, faded(color, alpha));
    else
        list.AddCircle(imgui(*middle), radius, faded(color, alpha), 0, 2 * unit_);
}

void HandleView::draw(ImDrawList& list, std::optional<Handle> hot, bool dead) const {
    if (hidden()) return;
    const float alpha = dead ? 0.45f : 1;
    const auto color = [&](Handle handle) {
        if (dead) return kDead;
        return hot == handle ? kHot : kColors[static_cast<size_t>(handle.axis)];
    };
    std::array<int, 3> order{0, 1, 2};  // what is behind first
    std::sort(order.begin(), order.end(), [&](int a, int b) {
        return glm::dot(unitAxis(a), projection_.frame().back) <
               glm::dot(unitAxis(b), projection_.frame().back);
    });
    if (mode_ == HandleMode::kMove)
        for (const int i : order) {
            const Handle plane{Kind::kPlane, i};
            drawPlane(list, i, color(plane), hot == plane, alpha * clarity(plane));
        }
    const Handle middle{Kind::kMiddle, 0};
    bool middleDrawn = false;
    for (const int i : order) {
        const Handle handle{Kind::kAxis, i};
        if (!middleDrawn && glm::dot(unitAxis(i), projection_.frame().back) > 0) {
            drawMiddle(list, hot == middle, alpha);
            middleDrawn = true;
        }
        if (mode_ == HandleMode::kTurn)
            drawRing(list, i, color(handle), alpha, hot == handle);
        else
            drawAxis(list, i, color(handle), alpha * clarity(handle));
    }
    if (!middleDrawn) drawMiddle(list, hot == middle, alpha);
}

void HandleView::drawDrag(ImDrawList& list, const HandleDrag& drag, glm::vec2 hand) const {
    if (hidden()) return;
    const HandleDrag::Setting& before = drag.setting();
    const Handle handle = before.handle;
    const auto axis = static_cast<size_t>(handle.axis);
    const auto middle = *projection_.place(centre_);
    std::string label;
    if (mode_ == HandleMode::kMove) {
        // The line or the plane it goes along, and the way from where it was.
        for (int i = 0; i < 3; ++i) {
            const bool free = handle.kind == Kind::kAxis
                                  ? i == handle.axis
                                  : handle.kind == Kind::kPlane && i != handle.axis;
            if (!free) continue;
            const glm::vec3 far = 100.0f * reach_ * unitAxis(i);
            if (const auto line = projection_.line(centre_ - far, centre_ + far))
                list.AddLine(imgui(line->first), imgui(line->second),
                             faded(kColors[static_cast<size_t>(i)], 0.55f), 1.2f * unit_);
        }
        const glm::vec3 was(worldFromParent_ * glm::vec4(before.place.at, 1));
        if (const auto line = projection_.line(was, centre_)) {
            drawLine(list, line->first, line->second, kHot, 1, 2 * unit_);
            list.AddCircle(imgui(line->first), 4 * unit_, kHot, 0, 1.5f * unit_);
        }
        const glm::vec3 way = place_.at - before.place.at;
        for (int i = 0; i < 3; ++i)
            if (handle.kind == Kind::kMiddle || (handle.kind == Kind::kAxis) == (i == handle.axis))
                label += fmt::format("{}{} {:+.4g}", label.empty() ? "" : "   ", "xyz"[i], way[i]);
        drawMiddle(list, true, 1);
    } else if (mode_ == HandleMode::kTurn) {
        const int parts = std::clamp(static_cast<int>(std::abs(drag.turned()) / 4) + 1, 1, 400);
        std::vector<ImVec2> arc;
        for (int i = 0; i <= parts; ++i) {
            const float share = static_cast<float>(i) / static_cast<float>(parts);
            const auto p = projection_.place(
                onRing(handle.axis, drag.grabbedAngle() + share * glm::radians(drag.turned())));
            if (p) arc.push_back(imgui(*p));
        }
        for (size_t i = 1; i < arc.size(); ++i)
            list.AddTriangleFilled(imgui(middle), arc[i - 1], arc[i], faded(kHot, 0.25f));
        drawRing(list, handle.axis, kColors[axis], 1, true);
        if (arc.size() > 1) {
            list.AddLine(imgui(middle), arc.front(), faded(kHot, 0.8f), 1.5f * unit_);
            list.AddLine(imgui(middle), arc.back(), kHot, 2 * unit_);
        }
        label = fmt::format("{} {:+.1f} degrees", "xyz"[axis], drag.turned());
    } else {
        if (handle.kind == Kind::kMiddle)
            drawMiddle(list, true, 1);
        else
            drawAxis(list, handle.axis, kHot, 1);
        const float factor = place_.scale[handle.axis] / before.place.scale[handle.axis];
        label = handle.kind == Kind::kMiddle ? fmt::format("{:.3g} times", factor)
                                             : fmt::format("{} {:.3g} times", "xyz"[axis], factor);
    }
    const ImVec2 size = ImGui::CalcTextSize(label.c_str());
    const float gap = 6 * unit_;
    glm::vec2 at = hand + 18.0f * unit_;
    at = glm::max(glm::vec2(gap),
                  glm::min(at, projection_.pictureSize() - glm::vec2(size.x, size.y) - 2 * gap));
    list.AddRectFilled({at.x - gap, at.y - gap}, {at.x + size.x + gap, at.y + size.y + gap},
                       IM_COL32(20, 20, 22, 215), 4 * unit_);
    list.AddText(imgui(at), kWhite, label.c_str());
}

void drawSelectionBox(ImDrawList& list, const Projection& projection, const Aabb& box,
                      const glm::mat4& worldFromBox, float unit) {
    if (box.empty()) return;
    const auto corner = [&](int i) {
        const glm::vec3 p(i & 1 ? box.max.x : box.min.x, i & 2 ? box.max.y : box.min.y,
                          i & 4 ? box.max.z : box.min.z);
        return glm::vec3(worldFromBox * glm::vec4(p, 1));
    };
    const auto draw = [&](glm::vec3 a, glm::vec3 b, float alpha, float width) {
        const auto line = projection.line(a, b);
        if (!line) return;
        list.AddLine(imgui(line->first), imgui(line->second), faded(kShadow, alpha), width + 2);
        list.AddLine(imgui(line->first), imgui(line->second), faded(kHot, alpha), width);
    };
    constexpr float kBracket = 0.16f;  // of an edge
    for (int i = 0; i < 8; ++i)
        for (const int bit : {1, 2, 4}) {
            if (i & bit) continue;
            const glm::vec3 a = corner(i), b = corner(i | bit);
            draw(a, b, 0.25f, unit);
            draw(a, glm::mix(a, b, kBracket), 0.9f, 1.6f * unit);
            draw(b, glm::mix(b, a, kBracket), 0.9f, 1.6f * unit);
        }
}

}  // namespace vitrine
