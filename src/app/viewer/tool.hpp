// SPDX-License-Identifier: MIT
// A part of the window that brings its own commands and draws its own things over the picture.
#pragma once

#include <vector>

#include "app/viewer/commands.hpp"
#include "base/math.hpp"

namespace vitrine {

/// A step of the window calls, for each tool: addCommands, draw, (the scene takes its step,)
/// update, and finishStep if the picture was drawn.
class Tool {
  public:
    Tool() = default;
    virtual ~Tool() = default;
    Tool(const Tool&) = delete;
    Tool& operator=(const Tool&) = delete;

    /// What can be asked of it now. What they do may be called until the next step.
    virtual void addCommands(std::vector<Command>& /*list*/) {}
    /// Its part of the interface, over a picture of this size (ImGui units, from the upper left).
    /// Who sets ImGuiIO::WantCaptureMouse here keeps the mouse from the camera.
    virtual void draw(glm::vec2 /*pictureSize*/) {}
    /// Looks at the mouse, and at the scene as it is now.
    virtual void update() {}
    /// A little more of the picture has been drawn.
    virtual void finishStep() {}
    /// Puts its own picture over the scene's.
    virtual void show() {}
    /// There is something to do although nothing happens and the picture rests.
    [[nodiscard]] virtual bool busy() const { return false; }
    /// The scene stands still and is not drawn: camera, time, edits and files wait.
    [[nodiscard]] virtual bool holdsScene() const { return false; }
    /// Whether it has to do with the scene alone: then it neither draws nor updates while another
    /// one holds that.
    [[nodiscard]] virtual bool needsScene() const { return true; }
    /// A key went down. Whether it is taken: then nobody behind gets it, and no command runs.
    virtual bool takeKey(const KeyPress& /*press*/) { return false; }
};

}  // namespace vitrine
