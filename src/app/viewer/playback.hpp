// SPDX-License-Identifier: MIT
// Hands on the time of a scene that moves.
#pragma once

#include "app/viewer/scene_view.hpp"
#include "app/viewer/tool.hpp"

namespace vitrine {

class Playback : public Tool {
  public:
    explicit Playback(SceneView& view) : view_(view) {}
    void addCommands(std::vector<Command>& list) override;
    void draw(glm::vec2 pictureSize) override;

  private:
    void step(float seconds);
    SceneView& view_;
};

}  // namespace vitrine
