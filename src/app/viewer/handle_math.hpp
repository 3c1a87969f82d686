// SPDX-License-Identifier: MIT
// How a hand moves, turns and scales a node by its handles. Pure mathematics: no window, no scene.
//
// Places count in the frame of the node's parent, so the handles do: axes 0, 1, 2 of a move and of
// a turn are the parent's, those of a scale the node's own. Whatever the parent's transform is
// (mirrored, scaled unevenly, sheared), dragging the axis x changes x and nothing else.
#pragma once

#include <optional>

#include "app/viewer/camera_control.hpp"
#include "base/math.hpp"

namespace vitrine {

/// Where a node stands in its parent, as Node::at, rotate (degrees about x, then y, then z), scale.
struct Place {
    glm::vec3 at{0}, rotate{0}, scale{1};
    bool operator==(const Place&) const = default;
};

enum class HandleMode { kMove, kTurn, kScale };

/// What can be grabbed. A turn has axes alone, a scale no planes.
struct Handle {
    enum class Kind { kAxis, kPlane, kMiddle };
    Kind kind = Kind::kAxis;
    int axis = 0;  ///< of a plane the one across it; of the middle 0
    bool operator==(const Handle&) const = default;
};

/// A line of sight in the world: from the eye through a point of the picture.
struct Sight {
    glm::vec3 origin{0}, direction{0, 0, -1};
};

/// The rotation that Node::rotate means.
glm::mat3 rotationOf(glm::vec3 degrees);
/// Its inverse: of all angles that give this rotation the ones nearest to `near`, in degrees.
glm::vec3 anglesOf(const glm::mat3& rotation, glm::vec3 near);

/// The point of the line `origin + t * axis` nearest to the sight: t. Nothing if one looks along
/// it.
std::optional<float> nearestOnLine(const Sight& sight, glm::vec3 origin, glm::vec3 axis);
/// Where the sight meets the plane through `origin` along `a` and `b`, which need not be square to
/// each other: its coordinates by them. Nothing if it does not, or behind the eye.
std::optional<glm::vec2> meetingPlane(const Sight& sight, glm::vec3 origin, glm::vec3 a,
                                      glm::vec3 b);

/// `value` with no more decimals than it takes to tell steps of this size apart.
float tidy(float value, float step);

/// A drag of one handle, from when it is grabbed.
class HandleDrag {
  public:
    struct Setting {
        HandleMode mode = HandleMode::kMove;
        Handle handle;
        Place place;  ///< before the drag
        glm::mat4 worldFromParent{1};
        float reach = 1;  ///< of the handles, m in the world
        float pixel = 0;  ///< m in the world at the node's distance: what is finer is not meant
        CameraFrame view{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    };
    HandleDrag(const Setting& setting, const Sight& grabbed);

    /// The place when the hand is here. `snap`: in steps of 0.1 (of the parent's units, of the
    /// scale) and of 15 degrees.
    Place to(const Sight& sight, bool snap);

    [[nodiscard]] const Setting& setting() const { return setting_; }
    /// What the last to() has turned by, degrees.
    [[nodiscard]] float turned() const { return turned_; }
    /// Where on its ring a turn was grabbed: the angle in its plane, radians.
    [[nodiscard]] float grabbedAngle() const { return grabbedAngle_; }

  private:
    [[nodiscard]] Place moved(const Sight& sight, bool snap) const;
    Place turnedTo(const Sight& sight, bool snap);
    [[nodiscard]] Place scaled(const Sight& sight, bool snap) const;
    /// The angle of the sight on the ring, radians, without whole turns.
    [[nodiscard]] std::optional<float> angleOf(const Sight& sight) const;
    [[nodiscard]] glm::vec3 onScreenPlane(const Sight& sight) const;

    Setting setting_;
    Sight grabbed_;
    glm::vec3 centre_;  ///< of the handles, in the world
    bool edgeOn_ = false;
    float grabbedAngle_ = 0, lastAngle_ = 0, turned_ = 0;
};

/// The direction of a handle's axis in the world; its length is that of a unit of the parent (or,
/// for a scale, of the node's own axis before its scale).
glm::vec3 handleAxis(HandleMode mode, const Place& place, const glm::mat4& worldFromParent,
                     int axis);

}  // namespace vitrine
