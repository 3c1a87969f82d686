// SPDX-License-Identifier: MIT
// Films of what the window shows: asks how, draws every frame in full, tells how far it is.
#pragma once

#include <chrono>
#include <memory>

#include "app/viewer/dialogue.hpp"
#include "app/viewer/film_take.hpp"
#include "app/viewer/notices.hpp"
#include "app/viewer/tool.hpp"

namespace vitrine {

class Recorder : public Tool {
  public:
    Recorder(Window& window, SceneView& view, Notices& notices)
        : window_(window), view_(view), notices_(notices), question_(window, "Record a film") {}

    void addCommands(std::vector<Command>& list) override;
    void draw(glm::vec2 pictureSize) override;
    void finishStep() override;
    void show() override;
    [[nodiscard]] bool busy() const override { return isRecording(); }
    [[nodiscard]] bool holdsScene() const override { return isRecording(); }
    [[nodiscard]] bool needsScene() const override { return false; }
    bool takeKey(const KeyPress& press) override;

    /// Asks how to record, and then does.
    void ask();
    [[nodiscard]] bool isRecording() const { return take_ != nullptr; }
    /// Nothing of the film stays; but one that is drawn to its end is finished.
    void cancel();

  private:
    using Clock = std::chrono::steady_clock;
    struct Choice {
        int size = 0, rate = 2;
        bool webm = false;
    };
    void drawQuestion();
    void drawChoices();
    void drawProgress(glm::vec2 pictureSize);
    [[nodiscard]] FilmSettings settings() const;
    void start();
    void end();

    Window& window_;
    SceneView& view_;
    Notices& notices_;
    Dialogue question_;
    FilmPlan plan_;
    std::string plannedFor_;  ///< the file that the plan is of
    Choice choice_;
    std::unique_ptr<FilmTake> take_;
    Clock::time_point startedAt_{};
};

/// "0:35" or "1:02:00".
std::string clockText(double seconds);

}  // namespace vitrine
