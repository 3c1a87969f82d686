// SPDX-License-Identifier: MIT
// Handles as they stand in the picture: of a constant size there, in perspective.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "app/viewer/handle_math.hpp"
#include "app/viewer/projection.hpp"
#include "base/aabb.hpp"

struct ImDrawList;

namespace vitrine {

/// Which way a path through three places turns: positive to one side, negative to the other.
inline float turnAt(glm::vec2 a, glm::vec2 b, glm::vec2 c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

class HandleView {
  public:
    /// `unit`: ImGui units that a line of text at the usual size has for each of its 13 pixels.
    HandleView(HandleMode mode, const Place& place, const glm::mat4& worldFromParent,
               const Projection& projection, float unit);

    /// Nothing of them is in the picture.
    [[nodiscard]] bool hidden() const { return reach_ <= 0; }
    /// The handle under a place of the picture.
    [[nodiscard]] std::optional<Handle> at(glm::vec2 place) const;

    /// Draws all of them, the one under the hand bright. `dead`: nothing can be grabbed.
    void draw(ImDrawList& list, std::optional<Handle> hot, bool dead) const;
    /// Draws what a drag has done so far, with its number beside `hand`.
    void drawDrag(ImDrawList& list, const HandleDrag& drag, glm::vec2 hand) const;

    /// m in the world: of the longest handle, and of an ImGui unit beside it.
    [[nodiscard]] float reach() const { return reach_; }
    [[nodiscard]] float pixel() const { return projection_.metresPerUnit(centre_); }

  private:
    [[nodiscard]] glm::vec3 unitAxis(int axis) const;
    /// A point of the picture, from the middle of the handles in their lengths along the axes.
    [[nodiscard]] std::optional<glm::vec2> onAxes(glm::vec3 lengths) const;
    [[nodiscard]] glm::vec3 onRing(int axis, float angle) const;
    /// Whether a point of a ring is on the half that turns away from the eye.
    [[nodiscard]] bool isBehind(glm::vec3 onRing) const;
    /// 0: an axis that points at the eye, or a plane seen from its edge; 1: all others.
    [[nodiscard]] float clarity(Handle handle) const;
    [[nodiscard]] std::optional<float> distance(Handle handle, glm::vec2 place) const;
    [[nodiscard]] std::vector<Handle> all() const;

    [[nodiscard]] std::optional<std::array<glm::vec2, 4>> planeCorners(int axis) const;

    void drawAxis(ImDrawList& list, int axis, unsigned color, float alpha) const;
    void drawPlane(ImDrawList& list, int axis, unsigned color, bool hot, float alpha) const;
    void drawRing(ImDrawList& list, int axis, unsigned color, float alpha, bool hot) const;
    void drawMiddle(ImDrawList& list, bool hot, float alpha) const;
    void drawSolid(ImDrawList& list, const std::vector<glm::vec3>& points, unsigned color) const;
    void drawCube(ImDrawList& list, int axis, unsigned color, float alpha) const;
    void drawCone(ImDrawList& list, int axis, unsigned color, float alpha) const;

    // Of their length.
    static constexpr float kShaftBegin = 0.14f, kTipBegin = 0.80f, kTipRadius = 0.055f,
                           kPlaneBegin = 0.30f, kPlaneEnd = 0.50f, kRing = 0.92f, kCube = 0.055f;
    static constexpr float kMiddle = 6;  ///< units
    static constexpr int kRingParts = 72;

    HandleMode mode_;
    Place place_;
    glm::mat4 worldFromParent_;
    const Projection& projection_;
    float unit_;
    glm::vec3 centre_;
    float reach_ = 0;
};

/// The edges of a box, its corners brighter, so that one sees what is selected.
void drawSelectionBox(ImDrawList& list, const Projection& projection, const Aabb& box,
                      const glm::mat4& worldFromBox, float unit);

}  // namespace vitrine
