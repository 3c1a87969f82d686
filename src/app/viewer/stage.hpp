// SPDX-License-Identifier: MIT
// Draws the scene into a texture for the window: coarse while something moves, then finer and
// finer, then not at all.
#pragma once

#include <memory>
#include <optional>

#include "app/viewer/pace.hpp"
#include "app/viewer/pass_graph.hpp"
#include "app/viewer/scene_frame.hpp"

namespace vitrine {

class Stage {
  public:
    /// Shows another scene, or the same with other programs, which are ready.
    void setFrame(std::shared_ptr<SceneFrame> frame);
    /// Whether this view can be shown without another frame.
    [[nodiscard]] bool canShow(View view, bool counting = false) const {
        return frame_ != nullptr && frame_->canShow(view, counting);
    }
    /// Whether the frame is one that wants to be replaced by a whole one.
    [[nodiscard]] bool isSketch() const { return frame_ != nullptr && frame_->isSketch(); }
    /// Whether these numbers can be shown without another frame.
    [[nodiscard]] bool covers(const PackedMoment& moment) const;
    /// The same scene with other numbers.
    void update(const PackedMoment& moment);
    /// The record under a pixel of the window's picture, from the upper left.
    [[nodiscard]] glm::uvec4 pick(glm::ivec2 pixel);
    /// What these rays meet in the scene.
    [[nodiscard]] std::vector<glm::uvec4> closest(std::span<const QueryRay> rays);
    /// What such a pixel has cost in the last sample; nothing while it is drawn, or if the frame
    /// does not count.
    [[nodiscard]] std::optional<PixelCounts> counts(glm::ivec2 pixel);
    [[nodiscard]] bool empty() const { return frame_ == nullptr; }

    using Wish = vitrine::Wish;
    /// Draws a little more of it, for about so long.
    void draw(const Wish& wish, double budgetSeconds);
    /// Nothing is left to draw for the last wish.
    [[nodiscard]] bool finished() const { return finished_; }
    [[nodiscard]] const Texture* picture() const { return picture_; }
    /// The picture's pixels, top row first. Only when finished.
    [[nodiscard]] ImageRgba8 image();
    /// Whether to measure the passes, which costs time.
    void measure(bool wanted);
    /// What the passes of the last whole sample took, once; nothing if none is new.
    [[nodiscard]] std::optional<PassSeconds> takePassSeconds();
    [[nodiscard]] int samplesDrawn() const { return samplesDrawn_; }
    [[nodiscard]] float scale() const { return drawnScale_; }
    [[nodiscard]] double lastSeconds() const { return lastSeconds_; }

  private:
    void begin(const Wish& wish);
    /// Shares of the picture from the lower left.
    [[nodiscard]] glm::vec2 placeOf(glm::ivec2 pixel) const;
    std::shared_ptr<SceneFrame> frame_;
    Pace pace_;
    Wish wish_;
    bool begun_ = false, finished_ = false, measures_ = false;
    const Texture* picture_ = nullptr;
    PassSeconds passSums_;  ///< since begin()
    std::optional<PassSeconds> passSeconds_;
    int samplesDrawn_ = 0;
    float drawnScale_ = 1;
    double lastSeconds_ = 0;
};

}  // namespace vitrine
