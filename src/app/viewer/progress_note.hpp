// SPDX-License-Identifier: MIT
// Says that a scene is being read or compiled while the picture before it stays.
#pragma once

#include <string>

#include "app/viewer/scene_view.hpp"
#include "app/viewer/tool.hpp"

namespace vitrine {

class ProgressNote : public Tool {
  public:
    ProgressNote(Window& window, const SceneView& view) : window_(window), view_(view) {}
    void draw(glm::vec2 pictureSize) override;
    void update() override;

  private:
    Window& window_;
    const SceneView& view_;
    std::string text_;
};

}  // namespace vitrine
