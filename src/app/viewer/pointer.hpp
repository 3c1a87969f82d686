// SPDX-License-Identifier: MIT
// What the mouse points at in the picture: clicks select it, double clicks fly to it. And the
// cameras to go to.
#pragma once

#include "app/viewer/scene_view.hpp"
#include "app/viewer/surroundings.hpp"
#include "app/viewer/tool.hpp"

namespace vitrine {

class Pointer : public Tool {
  public:
    Pointer(SceneView& view, Surroundings& surroundings)
        : view_(view), surroundings_(surroundings) {}
    void addCommands(std::vector<Command>& list) override;
    void update() override;

  private:
    void flyToCursor();
    void flyToSelection();
    /// Flies square in front of it, if that is a place from where it is seen. Returns whether.
    bool flyToScreen(const PackedInstance& instance);
    void select();
    SceneView& view_;
    Surroundings& surroundings_;
};

}  // namespace vitrine
