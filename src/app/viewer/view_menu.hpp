// SPDX-License-Identifier: MIT
// What of the scene is shown: all `--view` modes, one or two at a time.
#pragma once

#include "app/viewer/scene_view.hpp"
#include "app/viewer/tool.hpp"

namespace vitrine {

class ViewMenu : public Tool {
  public:
    explicit ViewMenu(SceneView& view) : view_(view) {}
    void addCommands(std::vector<Command>& list) override;
    void draw(glm::vec2 pictureSize) override;

  private:
    SceneView& view_;
};

}  // namespace vitrine
