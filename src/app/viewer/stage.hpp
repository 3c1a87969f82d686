// SPDX-License-Identifier: MIT
// Draws the scene into a texture for the window: coarse while something moves, then finer and
// finer, then not at all.
#pragma once

#include <memory>
#include <optional>

#include "app/session/session.hpp"
#include "app/viewer/pace.hpp"
#include "app/viewer/pass_graph.hpp"

namespace vitrine {

class Stage {
  public:
    explicit Stage(const Context& context) : context_(context) {}

    /// Shows another scene. Throws InputError if a snippet does not compile; then the scene before
    /// stays. Views that show counters need `counters`, which cost time.
    void setScene(const LoadedScene& scene, bool counters);
    /// Whether this view can be shown without another setScene().
    [[nodiscard]] bool canShow(View view) const { return counters_ || !showsCounters(view); }
    /// The same scene with other numbers.
    void update(const PackedMoment& moment);
    /// The record under a pixel of the window's picture, from the upper left.
    [[nodiscard]] glm::uvec4 pick(glm::ivec2 pixel);
    [[nodiscard]] bool empty() const { return frame_ == nullptr; }

    /// What is to be seen. A picture that differs from the last one starts anew.
    struct Wish {
        int width = 0, height = 0;
        Camera camera;
        float time = 0;
        View view = View::kColor;
        int samples = 1, bounces = 2, ssaa = 1, seed = 0;
        bool moving = false;  ///< more changes are coming: stay within the budget
    };
    /// Draws a little more of it, for about so long.
    void draw(const Wish& wish, double budgetSeconds);
    /// Nothing is left to draw for the last wish.
    [[nodiscard]] bool finished() const { return finished_; }
    [[nodiscard]] const Texture* picture() const { return picture_; }
    /// The picture's pixels, top row first. Only when finished.
    [[nodiscard]] ImageRgba8 image() { return frame_->picture(); }
    /// Whether to measure the passes, which costs time.
    void measure(bool wanted);
    /// What the passes of the last whole sample took, once; nothing if none is new.
    [[nodiscard]] std::optional<PassSeconds> takePassSeconds();
    [[nodiscard]] int samplesDrawn() const { return samplesDrawn_; }
    [[nodiscard]] float scale() const { return drawnScale_; }
    [[nodiscard]] double lastSeconds() const { return lastSeconds_; }

  private:
    void begin(Frame& frame, const Wish& wish);
    const Context& context_;
    std::unique_ptr<Frame> frame_;
    Pace pace_;
    Wish wish_;
    bool begun_ = false, finished_ = false, counters_ = false, measures_ = false;
    const Texture* picture_ = nullptr;
    PassSeconds passSums_;  ///< since begin()
    std::optional<PassSeconds> passSeconds_;
    int samplesDrawn_ = 0;
    float drawnScale_ = 1;
    double lastSeconds_ = 0;
};

}  // namespace vitrine
