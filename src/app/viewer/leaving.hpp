// SPDX-License-Identifier: MIT
// Nothing is lost without a question: changes that are not saved, a film that is being recorded.
#pragma once

#include <functional>

#include "app/viewer/recorder.hpp"

namespace vitrine {

class Leaving : public Tool {
  public:
    Leaving(Window& window, SceneView& view, Notices& notices, Recorder& recorder)
        : view_(view),
          notices_(notices),
          recorder_(recorder),
          film_(window, "A film is being recorded"),
          changes_(window, "Changes are not saved") {}

    /// Something takes the scene away, or the window: does it at once, or when nothing is lost by
    /// it any more, or the user says so, or never.
    void ask(std::function<void()> leave);

    void draw(glm::vec2 pictureSize) override;
    bool takeKey(const KeyPress& press) override;
    [[nodiscard]] bool needsScene() const override { return false; }

  private:
    void drawFilm();
    void drawChanges();
    SceneView& view_;
    Notices& notices_;
    Recorder& recorder_;
    Dialogue film_, changes_;
    std::function<void()> leave_;
};

}  // namespace vitrine
