// SPDX-License-Identifier: MIT
// Opening, saving, undoing: what the window does with the scene's file.
#pragma once

#include <string>

#include "app/viewer/file_dialogues.hpp"
#include "app/viewer/leaving.hpp"
#include "app/viewer/notices.hpp"
#include "app/viewer/recent_files.hpp"
#include "app/viewer/scene_view.hpp"
#include "app/viewer/tool.hpp"

namespace vitrine {

/// The window's title while a file is shown.
std::string titleFor(const std::string& file);

class SceneFiles : public Tool {
  public:
    SceneFiles(Window& window, SceneView& view, Notices& notices, Leaving& leaving,
               RecentFiles& recent)
        : window_(window),
          view_(view),
          notices_(notices),
          leaving_(leaving),
          recent_(recent),
          openDialogue_(window),
          saveDialogue_(window) {}

    void addCommands(std::vector<Command>& list) override;
    void draw(glm::vec2 pictureSize) override;
    /// Opens the first of the files that were dropped on the window.
    void update() override;
    [[nodiscard]] bool needsScene() const override { return false; }
    bool takeKey(const KeyPress& press) override;

    /// Shows another file, unless that would lose something that is to be kept. `of` so many files
    /// that were offered at once.
    void open(const std::string& file, size_t of = 1);
    /// How often that was tried, with or without success.
    [[nodiscard]] int attempts() const { return attempts_; }
    /// Asks for a file and opens it.
    void askToOpen() { openDialogue_.open(view_.scene.file()); }

  private:
    void save(const std::string& file);
    void show(const std::string& file, size_t of);
    void finishOpening(const SceneView::Opened& opened);

    Window& window_;
    SceneView& view_;
    Notices& notices_;
    Leaving& leaving_;
    RecentFiles& recent_;
    OpenDialogue openDialogue_;
    SaveDialogue saveDialogue_;
    int attempts_ = 0;
    size_t droppedWith_ = 1;  ///< how many files were dropped with the one that is being opened
};

}  // namespace vitrine
