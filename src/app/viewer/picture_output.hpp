// SPDX-License-Identifier: MIT
// What leaves the window: pictures, and command lines that draw them.
#pragma once

#include "app/viewer/notices.hpp"
#include "app/viewer/scene_view.hpp"
#include "app/viewer/tool.hpp"

namespace vitrine {

class PictureOutput : public Tool {
  public:
    PictureOutput(SceneView& view, Notices& notices) : view_(view), notices_(notices) {}
    void addCommands(std::vector<Command>& list) override;
    void finishStep() override;

  private:
    void write();
    void copyCommand();
    SceneView& view_;
    Notices& notices_;
    bool wanted_ = false;
};

}  // namespace vitrine
