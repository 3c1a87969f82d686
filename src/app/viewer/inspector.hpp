// SPDX-License-Identifier: MIT
// Facts about the pixel under the mouse.
#pragma once

#include <optional>

#include "app/viewer/inspect.hpp"
#include "app/viewer/scene_view.hpp"
#include "app/viewer/tool.hpp"

namespace vitrine {

class Inspector : public Tool {
  public:
    Inspector(Window& window, SceneView& view) : window_(window), view_(view) {}
    void addCommands(std::vector<Command>& list) override;
    void draw(glm::vec2 pictureSize) override;
    /// Looks when the mouse or the picture is another, and then only at a picture that rests.
    void update() override;

  private:
    Window& window_;
    SceneView& view_;
    std::optional<glm::ivec2> pixel_;  ///< that the facts are of
    int changes_ = 0;                  ///< of the scene view, when they were found
    Facts facts_;
    bool shown_ = false, counted_ = false;
};

}  // namespace vitrine
