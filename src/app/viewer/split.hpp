// SPDX-License-Identifier: MIT
// A second picture of the same scene, in another view, right of a line that can be dragged.
#pragma once

#include "app/viewer/stage.hpp"
#include "gpu/window.hpp"

namespace vitrine {

class Split {
  public:
    explicit Split(const Context& context) : context_(context) {}

    /// Shows `view` right of the line. The scene is that of the window's own stage: as loaded, and
    /// as it is at the moment. Throws InputError if a snippet does not compile.
    void open(View view, const LoadedScene& scene, const PackedMoment& moment);
    void close() { stage_.reset(); }
    [[nodiscard]] bool isOpen() const { return stage_ != nullptr; }
    [[nodiscard]] View view() const { return view_; }

    /// Follow the window's own stage; nothing if closed.
    void setScene(const LoadedScene& scene);
    void update(const PackedMoment& moment);
    void draw(Stage::Wish wish, double budgetSeconds);
    [[nodiscard]] bool finished() const { return stage_ == nullptr || stage_->finished(); }

    /// Shows the picture right of the line, over the other one, which has this size.
    void show(Window& window, int width, int height) const;
    /// The same into the other one's pixels. Only when finished; nothing if closed.
    void putInto(ImageRgba8& picture);
    /// The line, to be dragged, over a picture of this size in ImGui units.
    void drawLine(glm::vec2 pictureSize, const std::string& leftName, const std::string& rightName);

  private:
    /// The first column right of the line.
    [[nodiscard]] int leftOf(int width) const;
    const Context& context_;
    std::unique_ptr<Stage> stage_;
    View view_ = View::kNormal;
    float line_ = 0.5f;  ///< share of the picture's width
};

}  // namespace vitrine
