// SPDX-License-Identifier: MIT
// Opening, saving, undoing: what the window does with the scene's file.
#pragma once

#include <string>

#include "app/viewer/notices.hpp"
#include "app/viewer/scene_view.hpp"
#include "app/viewer/tool.hpp"

namespace vitrine {

/// The window's title while a file is shown.
std::string titleFor(const std::string& file);

class SceneFiles : public Tool {
  public:
    SceneFiles(Window& window, SceneView& view, Notices& notices)
        : window_(window), view_(view), notices_(notices) {}

    void addCommands(std::vector<Command>& list) override;
    void draw(glm::vec2 pictureSize) override;
    /// Opens the first of the files that were dropped on the window.
    void update() override;

  private:
    void open(const std::string& file, size_t of);
    void finishOpening(const SceneView::Opened& opened);

    Window& window_;
    SceneView& view_;
    Notices& notices_;
    size_t droppedWith_ = 1;  ///< how many files were dropped with the one that is being opened
    std::string askedFor_;    ///< a file that was not opened, for the sake of edits
};

}  // namespace vitrine
