// SPDX-License-Identifier: MIT
// What the mouse points at in the picture: clicks select it, double clicks fly to it. And the
// cameras to go to.
#pragma once

#include "app/viewer/scene_view.hpp"
#include "app/viewer/tool.hpp"

namespace vitrine {

class Pointer : public Tool {
  public:
    explicit Pointer(SceneView& view) : view_(view) {}
    void addCommands(std::vector<Command>& list) override;
    void update() override;

  private:
    void flyToCursor();
    void select();
    SceneView& view_;
};

}  // namespace vitrine
