// SPDX-License-Identifier: MIT
#include "app/viewer/file_dialogues.hpp"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <system_error>

#include "app/viewer/open_scene.hpp"
#include "app/viewer/save_target.hpp"

namespace vitrine {
namespace {

namespace fs = std::filesystem;

const ImVec4 kWarning{1, 0.72f, 0.35f, 1};

/// In letters, so that it grows with them, and never wider than the window.
float widthOf(float letters) {
    return std::min(letters * ImGui::GetFontSize() / 2, ImGui::GetIO().DisplaySize.x - 40);
}

void warning(const std::string& text) {
    ImGui::PushTextWrapPos(widthOf(80));
    ImGui::TextColored(kWarning, "%s", text.c_str());
    ImGui::PopTextWrapPos();
}

}  // namespace

void OpenDialogue::open(const std::string& file) {
    std::error_code error;
    const fs::path absolute = fs::absolute(file, error);
    enter(error ? fs::path("/") : absolute.parent_path());
    box_.open();
}

void OpenDialogue::enter(const fs::path& folder) {
    folder_ = folder.lexically_normal();
    if (!folder_.has_filename() && folder_.has_relative_path()) folder_ = folder_.parent_path();
    list_ = listFolder(folder_);
    problem_ = list_.problem;
    typed_.clear();
    window_.wake();
}

std::optional<std::string> OpenDialogue::accept() {
    const fs::path path = typedPath(folder_, typed_);
    std::error_code error;
    if (typed_.empty()) return {};
    if (fs::is_directory(path, error)) {
        enter(path);
        return {};
    }
    problem_.clear();
    if (!fs::exists(path, error))
        problem_ = fmt::format("There is no {}.", path.string());
    else if (!canOpen(path.string()))
        problem_ = "Files that can be opened end in .toml, .glb, .gltf, .obj or .sdf.glsl.";
    return problem_.empty() ? std::optional(path.string()) : std::nullopt;
}

std::optional<std::string> OpenDialogue::draw() {
    if (!box_.begin()) return {};
    ImGui::TextDisabled("%s", folder_.c_str());
    std::optional<std::string> chosen = drawList();
    if (box_.isFresh()) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(widthOf(80));
    ImGui::InputTextWithHint("##name", "a name or a path", &typed_);
    if (!problem_.empty()) warning(problem_);
    const bool answered = box_.answer("Open");
    if (answered) chosen = accept();
    box_.end(answered, chosen.has_value());
    return chosen;
}

std::optional<std::string> OpenDialogue::drawList() {
    std::optional<std::string> chosen;
    std::optional<fs::path> next;
    const float height = std::min(20 * ImGui::GetFrameHeight(), ImGui::GetIO().DisplaySize.y / 2);
    ImGui::BeginChild("list", {widthOf(80), height}, true);
    const ImGuiSelectableFlags flags = ImGuiSelectableFlags_DontClosePopups;
    if (folder_.has_relative_path() && ImGui::Selectable("../", false, flags))
        next = folder_.parent_path();
    for (const std::string& name : list_.folders)
        if (ImGui::Selectable((name + "/").c_str(), false, flags)) next = folder_ / name;
    for (const std::string& name : list_.files)
        if (ImGui::Selectable(name.c_str(), typed_ == name,
                              flags | ImGuiSelectableFlags_AllowDoubleClick)) {
            typed_ = name;
            if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) chosen = accept();
        }
    if (list_.folders.empty() && list_.files.empty())
        ImGui::TextDisabled("nothing here that can be opened");
    ImGui::EndChild();
    if (next) enter(*next);
    return chosen;
}

void SaveDialogue::open(const std::string& scene) {
    scene_ = scene;
    typed_ = freeSceneName(scene);
    agreed_.clear();
    box_.open();
}

std::optional<std::string> SaveDialogue::draw() {
    if (!box_.begin()) return {};
    ImGui::TextDisabled("in %s", fs::path(scene_).has_parent_path()
                                     ? fs::path(scene_).parent_path().c_str()
                                     : "the current folder");
    if (box_.isFresh()) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(widthOf(60));
    ImGui::InputText("##name", &typed_);
    const SaveTarget target = saveTarget(scene_, typed_);
    const bool known = !target.exists || target.file == agreed_;
    if (!target.problem.empty()) warning(target.problem);
    if (target.exists)
        warning(fs::path(target.file).filename().string() +
                (known ? " will be overwritten." : " is there already."));
    std::optional<std::string> chosen;
    const bool answered = box_.answer(target.exists && known ? "Overwrite it" : "Save");
    if (answered && known && !target.file.empty()) chosen = target.file;
    if (answered) agreed_ = target.file;  // it is overwritten only by who says so twice
    box_.end(answered, chosen.has_value());
    return chosen;
}

}  // namespace vitrine
