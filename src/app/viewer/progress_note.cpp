// SPDX-License-Identifier: MIT
#include "app/viewer/progress_note.hpp"

#include "app/viewer/overlay.hpp"

namespace vitrine {

void ProgressNote::draw(glm::vec2 pictureSize) {
    if (!text_.empty()) drawProgress(text_, pictureSize);
}

void ProgressNote::update() {
    std::string text = view_.pending();
    if (text == text_) return;
    text_ = std::move(text);
    window_.wake();
}

}  // namespace vitrine
