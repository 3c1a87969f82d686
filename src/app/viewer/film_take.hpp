// SPDX-License-Identifier: MIT
// One film being recorded: its frames are drawn one after the other, each to its last sample, and
// handed to the encoder. The scene on show must stand still meanwhile.
#pragma once

#include <string>

#include "app/viewer/film_plan.hpp"
#include "app/viewer/film_thread.hpp"
#include "app/viewer/scene_view.hpp"

namespace vitrine {

struct FilmSettings {
    FilmPlan plan;
    std::string file;
    int width = 1280, height = 720;
};

class FilmTake {
  public:
    /// Of what `view` shows, from its camera. Throws MachineError, InputError.
    FilmTake(const Context& context, SceneView& view, const FilmSettings& settings);

    /// Works for about as long as a frame of the window may take. Throws MachineError, InputError.
    void step();
    /// Nothing is left to do: the film is there.
    [[nodiscard]] bool written() const { return written_; }
    /// All is drawn, and the encoder has to finish.
    [[nodiscard]] bool drawn() const { return frame_ == settings_.plan.frames(); }
    [[nodiscard]] int framesDone() const { return frame_; }
    /// The share of the frame that is being drawn.
    [[nodiscard]] float frameShare() const;
    /// The last whole frame, the first one as far as it is drawn; null: there is nothing to see.
    [[nodiscard]] const Texture* picture() const { return picture_; }
    [[nodiscard]] const FilmSettings& settings() const { return settings_; }

  private:
    void begin();
    SceneView& view_;
    FilmSettings settings_;
    FilmThread film_;
    Frame drawing_;
    Pilot pilot_;
    FrameRequest request_;
    const Texture* picture_ = nullptr;
    double budgetSeconds_ = 0;
    int frame_ = 0;
    bool written_ = false;
};

}  // namespace vitrine
