// SPDX-License-Identifier: MIT
// Opening, saving, undoing: what the window does with the scene's file.
#pragma once

#include <string>

#include "app/viewer/leaving.hpp"
#include "app/viewer/notices.hpp"
#include "app/viewer/scene_view.hpp"
#include "app/viewer/tool.hpp"

namespace vitrine {

/// The window's title while a file is shown.
std::string titleFor(const std::string& file);

class SceneFiles : public Tool {
  public:
    SceneFiles(Window& window, SceneView& view, Notices& notices, Leaving& leaving)
        : window_(window), view_(view), notices_(notices), leaving_(leaving) {}

    void addCommands(std::vector<Command>& list) override;
    void draw(glm::vec2 pictureSize) override;
    /// Opens the first of the files that were dropped on the window.
    void update() override;
    [[nodiscard]] bool needsScene() const override { return false; }

  private:
    void open(const std::string& file, size_t of = 1);
    void show(const std::string& file, size_t of);

    Window& window_;
    SceneView& view_;
    Notices& notices_;
    Leaving& leaving_;
};

}  // namespace vitrine
