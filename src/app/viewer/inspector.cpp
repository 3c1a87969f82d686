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
                        view_.countRays(shown_);
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
    const std::optional<PixelCounts> counts = view_.countsUnderMouse();
    if (pixel_ == pixel && changes_ == view_.changes() && counted_ == counts.has_value()) return;
    pixel_ = pixel;
    counted_ = counts.has_value();
    changes_ = view_.changes();
    facts_ = inspect(view_.scene.loaded().packed, view_.moment(), view_.pick(),
                     view_.pilot.camera.eye, view_.cursorDirection());
    facts_.emplace(facts_.begin(), "pixel", fmt::format("{}  {}", pixel.x, pixel.y));
    if (counts) {
        facts_.emplace_back("rays", fmt::format("1 of the camera, {} bounced, {} to lights",
                                                counts->bounceRays, counts->shadowRays));
        facts_.emplace_back("work", fmt::format("{} nodes and triangles, {} steps in fields",
                                                counts->nodes, counts->steps));
    }
    window_.wake();
}

}  // namespace vitrine
