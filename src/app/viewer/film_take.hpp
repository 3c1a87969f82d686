// SPDX-License-Identifier: MIT
// One film being recorded: its frames are drawn one after the other, each to its last sample, and
// handed to the encoder. The scene on show must stand still meanwhile.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

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
    /// Shows the last whole frame, the first one as far as it is drawn, in a part of the window's
    /// picture. False: there is nothing to see.
    bool show(Window& window, PixelRectangle part) const;
    [[nodiscard]] const FilmSettings& settings() const { return settings_; }

  private:
    /// What stands left or right of the line of a split.
    struct Side {
        Side(const Context& context, const LoadedScene& scene, View view, bool isPlain);
        Frame frame;
        FrameRequest request;
        bool plain;  ///< without the edits
        const Texture* picture = nullptr;
        [[nodiscard]] bool whole() const { return frame.samplesDrawn() == request.samples; }
    };
    void begin();
    void begin(Side& side);
    SceneView& view_;
    FilmSettings settings_;
    FilmThread film_;
    std::optional<float> line_;  ///< of a split
    std::vector<std::unique_ptr<Side>> sides_;
    size_t side_ = 0;  ///< that is being drawn
    Pilot pilot_;
    double budgetSeconds_ = 0;
    int frame_ = 0;
    bool written_ = false;
};

}  // namespace vitrine
