// SPDX-License-Identifier: MIT
#include "app/viewer/inspector.hpp"

#include <fmt/format.h>
#include <imgui.h>

#include "app/viewer/overlay.hpp"

namespace vitrine {

void Inspector::addCommands(std::vector<Command>& list) {
    list.push_back({"View", "What is under the cursor", "I", 'I', false, false,
                    [this] {
                        shown_ = !shown_;
                        pixel_.reset();
                    },
                    shown_});
}

void Inspector::draw(glm::vec2 pictureSize) {
    if (shown_) drawFacts(facts_, pictureSize);
}

void Inspector::update() {
    if (!shown_ || view_.moving()) return;
    if (ImGui::GetIO().WantCaptureMouse || !ImGui::IsMousePosValid()) return;
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const glm::ivec2 pixel(mouse.x, mouse.y);
    if (pixel_ == pixel && changes_ == view_.changes()) return;
    pixel_ = pixel;
    changes_ = view_.changes();
    facts_ = inspect(view_.scene.loaded().packed, view_.moment(), view_.pick(),
                     view_.pilot.camera.eye, view_.cursorDirection());
    facts_.emplace(facts_.begin(), "pixel", fmt::format("{}  {}", pixel.x, pixel.y));
    window_.wake();
}

}  // namespace vitrine
