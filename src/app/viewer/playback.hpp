// SPDX-License-Identifier: MIT
// Hands on the time of a scene that moves.
#pragma once

#include "app/viewer/recorder.hpp"
#include "app/viewer/scene_view.hpp"
#include "app/viewer/tool.hpp"

namespace vitrine {

class Playback : public Tool {
  public:
    Playback(SceneView& view, Recorder& recorder) : view_(view), recorder_(recorder) {}
    void addCommands(std::vector<Command>& list) override;
    void draw(glm::vec2 pictureSize) override;

  private:
    void step(float seconds);
    SceneView& view_;
    Recorder& recorder_;
};

}  // namespace vitrine
