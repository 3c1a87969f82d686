// SPDX-License-Identifier: MIT
#include "app/viewer/commands.hpp"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>

namespace vitrine {
namespace {

const std::array<std::pair<std::string, std::string>, 8> kMouse{
    {{"left drag", "turn around the target"},
     {"right or middle drag", "move sideways and up"},
     {"wheel", "nearer and farther, at the cursor"},
     {"click", "select what is under the cursor"},
     {"W A S D  Q E", "walk or fly, down and up; Shift: faster"},
     {"right drag while walking", "look around"},
     {"double click", "fly to what is under the cursor"},
     {"Ctrl+click on a slider", "type its value"}}};

std::string quoted(const std::string& text) {
    if (text.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"
                               "-_./=,:+@%") == std::string::npos)
        return text;
    std::string result = "'";
    for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return result + "'";
}

std::string list(const glm::vec3& v) {
    return fmt::format("[{},{},{}]", v.x, v.y, v.z);
}

using HelpRow = std::pair<std::string, std::string>;  // keys, what they do

void helpColumn(const char* name, const HelpRow* first, const HelpRow* last) {
    if (!ImGui::BeginTable(name, 2, ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_NoHostExtendX))
        return;
    for (; first != last; ++first) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::TextColored(ImVec4(1.0f, 0.78f, 0.36f, 1), "%s", first->first.c_str());
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(first->second.c_str());
    }
    ImGui::EndTable();
}

/// The menus in a menu ("": in the bar), and its entries, in the order of the list.
void drawMenus(const std::vector<Command>& commands, const std::string& in) {
    std::vector<std::string> drawn;
    for (const Command& c : commands) {
        if (c.menu == in) {
            if (ImGui::MenuItem(c.name.c_str(), c.keys.c_str(), c.chosen)) c.run();
            continue;
        }
        const std::string prefix = in.empty() ? "" : in + "/";
        if (c.menu.compare(0, prefix.size(), prefix) != 0) continue;
        const std::string name =
            c.menu.substr(prefix.size(), c.menu.find('/', prefix.size()) - prefix.size());
        if (std::find(drawn.begin(), drawn.end(), name) != drawn.end()) continue;
        drawn.push_back(name);
        if (!ImGui::BeginMenu(name.c_str())) continue;
        drawMenus(commands, prefix + name);
        ImGui::EndMenu();
    }
}

}  // namespace

void runKeys(const std::vector<Command>& commands, const std::vector<KeyPress>& presses) {
    for (const KeyPress& press : presses)
        for (const Command& c : commands)
            if (c.key == press.key && c.control == press.control && c.shift == press.shift) c.run();
}

void drawMenus(const std::vector<Command>& commands) {
    if (!ImGui::BeginMenuBar()) return;
    drawMenus(commands, "");
    ImGui::EndMenuBar();
}

void drawHelp(const std::vector<Command>& commands) {
    std::vector<HelpRow> rows(kMouse.begin(), kMouse.end());
    for (const Command& command : commands)
        if (!command.keys.empty()) rows.emplace_back(command.keys, command.name);
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({screen.x / 2, screen.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSizeConstraints({0, 0}, screen);
    ImGui::SetNextWindowBgAlpha(0.96f);
    ImGui::Begin("Keys", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing);
    const HelpRow *begin = rows.data(), *end = begin + rows.size();
    const HelpRow* middle = begin + (rows.size() + 1) / 2;
    helpColumn("left", begin, middle);
    ImGui::SameLine(0, 2 * ImGui::GetFontSize());
    helpColumn("right", middle, end);
    ImGui::End();
}

std::string renderCommand(const ShownPicture& picture) {
    std::string text = "vitrine render " + quoted(picture.file) + " -o picture.png" +
                       fmt::format(" --resolution {}x{}", picture.width, picture.height);
    if (picture.view != "color") text += " --view " + picture.view;
    if (picture.time != 0) text += fmt::format(" --time {}", picture.time);
    for (const std::string& assignment : picture.overrides) text += " --set " + quoted(assignment);
    const Camera& camera = picture.camera;
    if (!camera.name.empty()) text += " --camera " + quoted(camera.name);
    const std::string key =
        " --set " + (camera.name.empty() ? "camera" : quoted("camera." + camera.name));
    text += key + quoted(".eye=" + list(camera.eye));
    text += key + quoted(".target=" + list(camera.target));
    text += key + quoted(".up=" + list(camera.up));
    return text;
}

std::string nextFileName(const std::string& ending) {
    std::string name;
    int number = 1;
    do name = fmt::format("vitrine-{:04}{}", number++, ending);
    while (std::filesystem::exists(name));
    return name;
}

}  // namespace vitrine
