// SPDX-License-Identifier: MIT
// The boxes that ask for a file: to open one, and to save the scene under another name.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/viewer/dialogue.hpp"
#include "app/viewer/folder_list.hpp"

namespace vitrine {

class OpenDialogue {
  public:
    explicit OpenDialogue(Window& window) : window_(window), box_(window, "Open a file") {}
    /// Beginning in the folder of this file.
    void open(const std::string& file);
    bool takeKey(const KeyPress& press) { return box_.takeKey(press); }
    /// The file that was chosen, once.
    std::optional<std::string> draw();

  private:
    void enter(const std::filesystem::path& folder);
    std::optional<std::string> drawList();
    /// A folder is entered; a file that can be opened is returned.
    std::optional<std::string> accept();

    Window& window_;
    Dialogue box_;
    std::filesystem::path folder_;
    FolderList list_;
    std::string typed_, problem_;
};

class SaveDialogue {
  public:
    explicit SaveDialogue(Window& window) : box_(window, "Save as") {}
    /// Another name for this scene.
    void open(const std::string& scene);
    bool takeKey(const KeyPress& press) { return box_.takeKey(press); }
    /// The file to be written, once.
    std::optional<std::string> draw();

  private:
    Dialogue box_;
    std::string scene_, typed_;
    std::string agreed_;  ///< what may be overwritten
};

}  // namespace vitrine
