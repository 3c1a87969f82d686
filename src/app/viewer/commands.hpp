// SPDX-License-Identifier: MIT
// All that can be asked of the window in one list: keys, menu and help are made from it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "gpu/window.hpp"
#include "scene/scene.hpp"

namespace vitrine {

struct Command {
    std::string menu;  ///< "File", or "File/Open recent" for a menu in a menu
    std::string name;
    std::string keys;  ///< as people write them: "Ctrl+S"
    int key = 0;       ///< a KeyPress::key; 0: in the menu only
    bool control = false, shift = false;
    std::function<void()> run;
    bool chosen = false;  ///< the menu ticks it
};

/// Runs the commands of these keys.
void runKeys(const std::vector<Command>& commands, const std::vector<KeyPress>& presses);
/// The menu bar of the current ImGui window: menus, and entries in them, in the order of the list.
void drawMenus(const std::vector<Command>& commands);
/// A list of all keys in the middle of the window.
void drawHelp(const std::vector<Command>& commands);

/// The picture in the window as a command line.
struct ShownPicture {
    std::string file;
    Camera camera;  ///< with the name of the scene's camera that it came from
    std::vector<std::string> overrides;
    int width = 0, height = 0;
    std::string view;
    float time = 0;
};
/// `vitrine render ...`, quoted for a shell, that draws the same.
std::string renderCommand(const ShownPicture& picture);

/// vitrine-0001.png, or the first number after it that is not taken in the current folder.
/// `ending`:
/// ".png".
std::string nextFileName(const std::string& ending);

}  // namespace vitrine
