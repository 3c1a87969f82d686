// SPDX-License-Identifier: MIT
#include "app/viewer/start_page.hpp"

#include <imgui.h>

#include <algorithm>
#include <filesystem>

#include "app/viewer/user_folders.hpp"
#include "gpu/interface_look.hpp"
#include "scene/heading.hpp"

namespace vitrine {
namespace {

namespace fs = std::filesystem;

constexpr float kTileWidth = 250;  // ImGui units, about: what is left of a row is shared out
constexpr float kLeftWidth = 230;
const ImVec4 kAccent{1.0f, 0.78f, 0.36f, 1};
const ImVec4 kQuiet{0.62f, 0.64f, 0.68f, 1};

ImTextureID idOf(const Texture& picture) {
    return reinterpret_cast<ImTextureID>(static_cast<intptr_t>(picture.id()));
}

}  // namespace

void StartPage::addCommands(std::vector<Command>& list) {
    list.push_back({"File", "Start screen", "", 0, false, false, [this] { open(); }, shown_});
}

void StartPage::open() {
    if (shown_) return;
    shown_ = true;
    attempts_ = files_.attempts();
    recent_.refresh();
    if (thumbnails_ == nullptr) {
        readScenes();
        std::vector<std::string> names;
        for (const Tile& tile : tiles_) names.push_back(tile.file);
        const fs::path cache = cacheFolder();
        thumbnails_ = std::make_unique<Thumbnails>(std::move(names), cache, version_);
    }
    thumbnails_->setPaused(false);
    window_.wake();
}

void StartPage::close() {
    shown_ = false;
    thumbnails_->setPaused(true);
    window_.wake();
}

void StartPage::readScenes() {
    for (const std::string& name : listFolder(scenes_).files) {
        if (fs::path(name).extension() != ".toml") continue;
        Tile tile;
        tile.file = (fs::path(scenes_) / name).string();
        const SceneHeading heading = readHeading(tile.file);
        tile.title = heading.title.empty() ? fs::path(name).stem().string() : heading.title;
        tile.description = heading.description;
        tiles_.push_back(std::move(tile));
    }
    std::sort(tiles_.begin(), tiles_.end(),
              [](const Tile& a, const Tile& b) { return a.title < b.title; });
}

void StartPage::update() {
    if (!shown_) return;
    if (files_.attempts() != attempts_) return close();
    for (Thumbnails::Result& result : thumbnails_->take()) {
        Tile& tile = tiles_[result.scene];
        tile.failed = result.picture.pixels.empty();
        if (!tile.failed) {
            tile.picture =
                Texture(result.picture.width, result.picture.height, TexelFormat::kRgba8);
            tile.picture.smooth();
            tile.picture.write(std::as_bytes(std::span(result.picture.pixels)));
        }
        window_.wake();
    }
}

bool StartPage::takeKey(const KeyPress& press) {
    if (!shown_) return false;
    if (press.key == kKeyEscape) close();
    // What has to do with the scene waits until it can be seen.
    const bool general =
        press.key == kKeyF11 || (press.control && (press.key == 'O' || press.key == 'Q'));
    return !general;
}

void StartPage::draw(glm::vec2 /*pictureSize*/) {
    if (!shown_) return;
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSize(ImGui::GetIO().DisplaySize);
    ImGui::PushStyleColor(ImGuiCol_WindowBg, ImVec4(0.055f, 0.058f, 0.065f, 1));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding,
                        ImVec2(24 * window_.scale(), 20 * window_.scale()));
    ImGui::Begin("Start", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
    ImGui::PopStyleVar();
    ImGui::PushFont(headingFont());
    ImGui::TextColored(kAccent, "Vitrine");
    ImGui::PopFont();
    ImGui::TextColored(kQuiet, "Meshes and distance fields in one scene, and every ray sees both.");
    ImGui::Dummy({0, 8 * window_.scale()});
    const float left = std::min(kLeftWidth * window_.scale(), 0.4f * ImGui::GetWindowWidth());
    ImGui::BeginChild("left", {left, 0});
    drawLeft();
    ImGui::EndChild();
    ImGui::SameLine(0, 20 * window_.scale());
    ImGui::BeginChild("tiles");
    drawTiles();
    ImGui::EndChild();
    ImGui::End();
    ImGui::PopStyleColor();
}

void StartPage::drawLeft() {
    if (mainButton("Open a file ...")) files_.askToOpen();
    ImGui::PushTextWrapPos(0);
    ImGui::TextColored(kQuiet,
                       "or drop one on this window: a scene (.toml), a model (.glb, .gltf, "
                       ".obj) or a field (.sdf.glsl)");
    ImGui::PopTextWrapPos();
    ImGui::Dummy({0, 8 * window_.scale()});
    if (ImGui::Button("Back to the picture (Esc)")) close();
    if (recent_.files().empty()) return;
    ImGui::Dummy({0, 12 * window_.scale()});
    ImGui::TextColored(kAccent, "Opened last");
    for (const std::string& file : std::vector(recent_.files())) {
        ImGui::PushID(file.c_str());
        const fs::path path = file;
        if (ImGui::Selectable(path.filename().c_str())) files_.open(file);
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", file.c_str());
        ImGui::PopID();
    }
}

void StartPage::drawTiles() {
    if (tiles_.empty()) {
        ImGui::TextColored(kQuiet, "There are no scenes in %s.", scenes_.c_str());
        return;
    }
    const float gap = 16 * window_.scale(), room = ImGui::GetContentRegionAvail().x;
    const int columns =
        std::max(1, static_cast<int>((room + gap) / (kTileWidth * window_.scale() + gap)));
    const float width = std::floor((room + gap) / static_cast<float>(columns) - gap);
    // Room for a line of title and two of what it shows.
    const float height = std::floor(width * Thumbnails::kHeight / Thumbnails::kWidth) +
                         3.6f * ImGui::GetTextLineHeightWithSpacing();
    std::string chosen;
    for (size_t i = 0; i < tiles_.size(); ++i) {
        if (i % static_cast<size_t>(columns) != 0) ImGui::SameLine(0, gap);
        if (drawTile(tiles_[i], {width, height})) chosen = tiles_[i].file;
    }
    if (!chosen.empty()) files_.open(chosen);
}

bool StartPage::drawTile(const Tile& tile, glm::vec2 size) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const bool chosen = ImGui::InvisibleButton(tile.file.c_str(), {size.x, size.y});
    const bool touched = ImGui::IsItemHovered();
    if (touched) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    ImDrawList* list = ImGui::GetWindowDrawList();
    const float height = std::floor(size.x * Thumbnails::kHeight / Thumbnails::kWidth);
    const ImVec2 end(at.x + size.x, at.y + height);
    if (tile.picture.valid()) {
        list->AddImage(idOf(tile.picture), at, end);
    } else {
        list->AddRectFilled(at, end, IM_COL32(30, 32, 37, 255));
        const char* text = tile.failed ? "cannot be drawn here" : "drawing ...";
        const ImVec2 room = ImGui::CalcTextSize(text);
        list->AddText({(at.x + end.x - room.x) / 2, (at.y + end.y - room.y) / 2},
                      IM_COL32(110, 114, 124, 255), text);
    }
    if (touched) list->AddRect(at, end, IM_COL32(255, 199, 92, 255), 0, 0, 2);
    const float line = ImGui::GetTextLineHeightWithSpacing();
    list->PushClipRect(at, {at.x + size.x, at.y + size.y}, true);
    list->AddText({at.x, end.y + 4}, ImGui::GetColorU32(touched ? kAccent : ImVec4(1, 1, 1, 1)),
                  tile.title.c_str());
    list->AddText(ImGui::GetFont(), ImGui::GetFontSize(), {at.x, end.y + 4 + line},
                  ImGui::GetColorU32(kQuiet), tile.description.c_str(), nullptr, size.x);
    list->PopClipRect();
    return chosen;
}

}  // namespace vitrine
