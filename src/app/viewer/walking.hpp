// SPDX-License-Identifier: MIT
// The camera as a body in the scene: it walks on the ground, stops at walls and flies around
// things.
#pragma once

#include "app/viewer/scene_view.hpp"
#include "app/viewer/surroundings.hpp"
#include "app/viewer/tool.hpp"
#include "app/viewer/walker.hpp"

namespace vitrine {

class Walking : public Tool {
  public:
    Walking(SceneView& view, Surroundings& surroundings);
    void addCommands(std::vector<Command>& list) override;

  private:
    SceneView& view_;
    Surroundings& surroundings_;
    Walker walker_;
    bool solid_ = true;
};

}  // namespace vitrine
