// SPDX-License-Identifier: MIT
#include "app/viewer/scene_files.hpp"

#include <fmt/format.h>

namespace vitrine {

std::string titleFor(const std::string& file) {
    return file + " - Vitrine";
}

void SceneFiles::addCommands(std::vector<Command>& list) {
    list.push_back({"File", "Open", "Ctrl+O", 'O', true, false, [this] { askToOpen(); }});
    for (const std::string& file : recent_.files())
        list.push_back(
            {"File/Open recent", file, "", 0, false, false, [this, file] { open(file); }});
    list.push_back({"File", "Save the changes", "Ctrl+S", 'S', true, false,
                    [this] { notices_.say(view_.scene.save()); }});
    list.push_back({"File", "Save as", "Ctrl+Shift+S", 'S', true, true,
                    [this] { saveDialogue_.open(view_.scene.file()); }});
    list.push_back(
        {"Edit", "Undo", "Ctrl+Z", 'Z', true, false, [this] { view_.scene.edits.undo(); }});
    list.push_back(
        {"Edit", "Redo", "Ctrl+Y", 'Y', true, false, [this] { view_.scene.edits.redo(); }});
}

void SceneFiles::draw(glm::vec2 pictureSize) {
    notices_.draw(view_.scene.problems(), pictureSize);
    if (const auto file = openDialogue_.draw()) open(*file);
    if (const auto file = saveDialogue_.draw()) save(*file);
}

void SceneFiles::update() {
    const std::vector<std::string> files = window_.takeDroppedFiles();
    if (!files.empty()) open(files.front(), files.size());
    if (const auto opened = view_.takeOpened()) finishOpening(*opened);
}

bool SceneFiles::takeKey(const KeyPress& press) {
    return openDialogue_.takeKey(press) || saveDialogue_.takeKey(press);
}

void SceneFiles::save(const std::string& file) {
    notices_.say(view_.scene.saveAs(file));
    if (view_.scene.file() != file) return;
    window_.setTitle(titleFor(file));
    recent_.add(file);
}

void SceneFiles::open(const std::string& file, size_t of) {
    // What cannot be opened is refused before anybody is asked about losing anything.
    if (!canOpen(file)) return show(file, of);
    leaving_.ask([this, file, of] { show(file, of); });
}

void SceneFiles::show(const std::string& file, size_t of) {
    ++attempts_;
    droppedWith_ = of;
    view_.open(file);
}

void SceneFiles::finishOpening(const SceneView::Opened& opened) {
    if (opened.problems.hasErrors()) return notices_.refuse(opened.problems);
    notices_.forgetRefusal();
    window_.setTitle(titleFor(opened.file));
    recent_.add(opened.file);
    notices_.say(droppedWith_ == 1
                     ? "opened " + opened.file
                     : fmt::format("opened {}, the first of {}", opened.file, droppedWith_));
}

}  // namespace vitrine
