// SPDX-License-Identifier: MIT
// A second picture of the same scene, in another view or without the changes made by hand, right of
// a line that can be dragged.
#pragma once

#include <optional>

#include "app/viewer/stage.hpp"
#include "gpu/window.hpp"

namespace vitrine {

class Split {
  public:
    /// Shows `view` right of the line as soon as there is a frame for it: at once if the one there
    /// is will do, else with the next setFrame().
    /// `plain`: the scene without the edits.
    void open(View view, bool plain = false);
    void close();
    [[nodiscard]] bool isOpen() const { return open_; }
    [[nodiscard]] View view() const { return view_; }
    [[nodiscard]] bool isPlain() const { return open_ && plain_; }
    /// Whether it is open and waits for a frame.
    [[nodiscard]] bool needsFrame() const { return open_ && shown_ != view_; }
    /// A frame of the scene of the window's own stage. Nothing if closed meanwhile.
    void setFrame(std::shared_ptr<SceneFrame> frame);
    /// Follow the window's own stage; nothing if there is no picture.
    [[nodiscard]] bool covers(const PackedMoment& moment) const;
    void update(const PackedMoment& moment);
    void draw(Stage::Wish wish, double budgetSeconds);
    [[nodiscard]] bool finished() const {
        return stage_ == nullptr || !shown_ || stage_->finished();
    }

    /// Shows the picture right of the line, over the other one, which has this size.
    void show(Window& window, int width, int height) const;
    /// The same into the other one's pixels. Only when finished; nothing if closed.
    void putInto(ImageRgba8& picture);
    /// Where the line is, a share of the width; nothing if there is no second picture.
    [[nodiscard]] std::optional<float> line() const {
        return stage_ != nullptr && shown_ ? std::optional(line_) : std::nullopt;
    }
    /// The first column right of a line.
    [[nodiscard]] static int columnOf(float line, int width);
    /// Puts what is right of a line of `right` into `left`, which has the same size.
    static void join(ImageRgba8& left, const ImageRgba8& right, float line);
    /// The line, to be dragged, over a picture of this size in ImGui units.
    void drawLine(glm::vec2 pictureSize, const std::string& leftName, const std::string& rightName);

  private:
    std::unique_ptr<Stage> stage_;
    bool open_ = false, plain_ = false;
    View view_ = View::kNormal;  ///< that is asked for
    std::optional<View> shown_;  ///< of the stage
    float line_ = 0.5f;          ///< share of the picture's width
};

}  // namespace vitrine
