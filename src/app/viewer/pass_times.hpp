// SPDX-License-Identifier: MIT
// The graph of milliseconds by pass, on demand: measuring costs time.
#pragma once

#include "app/viewer/pass_graph.hpp"
#include "app/viewer/scene_view.hpp"
#include "app/viewer/tool.hpp"

namespace vitrine {

class PassTimes : public Tool {
  public:
    PassTimes(Window& window, SceneView& view) : window_(window), view_(view) {}
    void addCommands(std::vector<Command>& list) override;
    void draw(glm::vec2 pictureSize) override;
    void finishStep() override;

  private:
    Window& window_;
    SceneView& view_;
    PassGraph graph_;
    bool shown_ = false;
};

}  // namespace vitrine
