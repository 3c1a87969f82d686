// SPDX-License-Identifier: MIT
#include "app/viewer/scene_files.hpp"

#include <fmt/format.h>

namespace vitrine {

std::string titleFor(const std::string& file) {
    return file + " - Vitrine";
}

void SceneFiles::addCommands(std::vector<Command>& list) {
    list.push_back({"File", "Save the changes", "Ctrl+S", 'S', true, false,
                    [this] { notices_.say(view_.scene.save()); }});
    list.push_back(
        {"Edit", "Undo", "Ctrl+Z", 'Z', true, false, [this] { view_.scene.edits.undo(); }});
    list.push_back(
        {"Edit", "Redo", "Ctrl+Y", 'Y', true, false, [this] { view_.scene.edits.redo(); }});
}

void SceneFiles::draw(glm::vec2 pictureSize) {
    notices_.draw(view_.scene.problems(), pictureSize);
}

void SceneFiles::update() {
    const std::vector<std::string> files = window_.takeDroppedFiles();
    if (!files.empty()) open(files.front(), files.size());
    if (const auto opened = view_.takeOpened()) finishOpening(*opened);
}

void SceneFiles::open(const std::string& file, size_t of) {
    // What has been changed by hand is lost only to who asks twice.
    if (!view_.scene.edits.empty() && askedFor_ != file) {
        askedFor_ = file;
        Diagnostics why;
        why.error({view_.scene.file()},
                  "has changes that are not saved: drop the file again to lose them");
        return notices_.refuse(why);
    }
    askedFor_.clear();
    droppedWith_ = of;
    view_.open(file);
}

void SceneFiles::finishOpening(const SceneView::Opened& opened) {
    if (opened.problems.hasErrors()) return notices_.refuse(opened.problems);
    notices_.forgetRefusal();
    window_.setTitle(titleFor(opened.file));
    notices_.say(droppedWith_ == 1
                     ? "opened " + opened.file
                     : fmt::format("opened {}, the first of {}", opened.file, droppedWith_));
}

}  // namespace vitrine
