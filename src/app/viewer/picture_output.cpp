// SPDX-License-Identifier: MIT
#include "app/viewer/picture_output.hpp"

#include <fmt/format.h>
#include <imgui.h>

#include <cstdio>

#include "base/file.hpp"
#include "image/png.hpp"

namespace vitrine {

void PictureOutput::addCommands(std::vector<Command>& list) {
    list.push_back({"File", "Write the picture", "F12", kKeyF12, false, false, [this] {
                        wanted_ = true;
                        notices_.say("the picture will be written when it is finished");
                    }});
    list.push_back(
        {"File", "Copy as a command", "Ctrl+Shift+C", 'C', true, true, [this] { copyCommand(); }});
}

void PictureOutput::finishStep() {
    if (wanted_ && view_.finished()) write();
}

void PictureOutput::write() {
    wanted_ = false;
    try {
        const std::string name = nextFileName(".png");
        writeFileAtomically(name, encodePng(view_.image(), {}));
        notices_.say("wrote " + name);
    } catch (const MachineError& error) {
        notices_.say(error.what());
    }
}

void PictureOutput::copyCommand() {
    const Stage::Wish& w = view_.wish();
    const std::string text =
        renderCommand({view_.scene.file(), view_.pilot.camera, view_.scene.overrides(), w.width,
                       w.height, viewNames()[static_cast<size_t>(w.view)], w.time});
    ImGui::SetClipboardText(text.c_str());
    // Not every clipboard outlives the window.
    fmt::print("{}\n", text);
    std::fflush(stdout);
    notices_.say("copied: " + text);
}

}  // namespace vitrine
