// SPDX-License-Identifier: MIT
// The scene on show: the file that is open, the pictures of it, the camera in hand and the time.
// Knows nothing of menus and messages.
#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/viewer/latencies.hpp"
#include "app/viewer/open_scene.hpp"
#include "app/viewer/pilot.hpp"
#include "app/viewer/split.hpp"
#include "app/viewer/stage.hpp"
#include "app/viewer/timeline.hpp"
#include "app/viewer/workshop.hpp"
#include "gpu/window.hpp"

namespace vitrine {

/// What is chosen in the picture or the tree: a node, by its place in Scene::nodes.
struct Selection {
    int node = -1;
    bool justMade = false;  ///< the panel scrolls to it once
    bool visited = false;   ///< fly to it, once
};

class SceneView {
  public:
    /// Shows `file` from the camera of this name ("": the first), in a picture of about this many
    /// pixels. Reads it in the background and calls `wait` until that is done. Throws InputError if
    /// it cannot be shown, UsageError if there is no such camera. The window outlives this.
    SceneView(Window& window, const std::string& file, const std::string& camera,
              const std::vector<std::string>& overrides, glm::ivec2 pixels,
              const std::function<void()>& wait);

    /// Shows another file, from its first camera, with nothing selected, as soon as it has been
    /// read. Until then, and if it cannot be shown, all stays as it is; takeOpened() tells.
    void open(const std::string& file);
    struct Opened {
        std::string file;
        Diagnostics problems;  ///< with errors: why it is not shown
    };
    /// What came of open(), once.
    std::optional<Opened> takeOpened() { return std::exchange(opened_, {}); }
    /// What is being made in the background, a sentence; "": nothing, or not for long.
    [[nodiscard]] std::string pending() const;
    /// When nothing is left to do. Whether much memory has become free.
    bool settle() { return workshop_.settle(); }
    /// How long it took from noticing a change to the picture of it, once.
    std::optional<double> takeSecondsBehind() { return std::exchange(secondsBehind_, {}); }

    /// Takes what has happened in `elapsed` seconds: hands on the camera, time, edits, files.
    /// `pictureSize` in ImGui units, from the window's upper left.
    void step(float elapsed, glm::vec2 pictureSize);
    /// Draws a little more into pictures of so many pixels.
    void draw(int width, int height);
    /// Puts them into the window's lower left.
    void show();
    /// What show() shows, top row first. Only when finished.
    [[nodiscard]] ImageRgba8 image();
    /// There is something to draw, or will be soon without anybody doing anything.
    [[nodiscard]] bool busy() const;
    /// More changes are expected at once: the picture is coarse.
    [[nodiscard]] bool moving() const;
    /// Nothing is left to draw for what is shown now.
    [[nodiscard]] bool finished() const;

    /// The hit record under the mouse, in the picture.
    [[nodiscard]] glm::uvec4 pick();
    /// What that pixel has cost; nothing while nobody counts or it is being drawn.
    [[nodiscard]] std::optional<PixelCounts> countsUnderMouse();
    /// Whether to count, which costs time. The frame that does is made in the background.
    void countRays(bool wanted);
    /// The ray through the mouse: its unit direction.
    [[nodiscard]] glm::vec3 cursorDirection() const;

    void showView(View view);
    /// `plain`: without the edits.
    void openSplit(View view, bool plain = false);
    /// Flies to a camera of the scene.
    void takeCamera(size_t camera);
    /// Flies back to the scene's camera, wherever that is by now.
    void goHome() { takeCamera(camera_); }
    /// Lets time pass, or stand. A camera that is all that moves goes on even if a hand has held
    /// it.
    void play(bool on);
    /// The timeline has been moved by hand.
    void showTime() { showMoment(Latencies::Kind::kPlay); }

    [[nodiscard]] View view() const { return view_; }
    /// The camera that the pilot has taken, as the scene has it now.
    [[nodiscard]] const Camera& sceneCamera() const;
    /// Its lens without the edits, at another camera's place.
    [[nodiscard]] Camera plainCamera(const Camera& place) const;
    [[nodiscard]] glm::vec2 pictureSize() const { return pictureSize_; }
    [[nodiscard]] float viewHeight() const { return pilot.viewHeight(pictureSize_); }
    [[nodiscard]] const PackedMoment& moment() const { return moment_; }
    [[nodiscard]] const Stage::Wish& wish() const { return wish_; }
    /// Counts the moments shown.
    [[nodiscard]] int moments() const { return moments_; }
    /// Counts what has made the picture another one.
    [[nodiscard]] int changes() const { return changes_; }
    /// The weightiest that has happened since the last call.
    Latencies::Kind takeKind();

  private:
    Workshop workshop_;  // before the frames that it makes

  public:
    OpenScene scene;
    Stage stage;
    Split split;
    Pilot pilot;
    Timeline timeline;
    Selection selection;

  private:
    void follow();
    void order(std::optional<LoadRequest> load, std::optional<std::string> camera = {});
    void accept(Workshop::Delivery delivery);
    void showDelivered(Workshop::Delivery& delivery);
    void orderMissingFrames();
    [[nodiscard]] bool needsFrame() const;
    void lookThrough(const Camera& camera, size_t index, float seconds);
    void showMoment(Latencies::Kind why);
    [[nodiscard]] Stage::Wish plainWish() const;
    [[nodiscard]] const PackedMoment& splitMoment() const {
        return plainMoment_ ? *plainMoment_ : moment_;
    }
    void touch(Latencies::Kind why);
    void note(Latencies::Kind why) { kind_ = std::max(kind_, why); }

    using Clock = std::chrono::steady_clock;
    Window& window_;
    size_t camera_ = 0;  ///< in Scene::cameras: the one that the pilot has taken
    std::optional<PackedMoment> plainMoment_;  ///< what the split shows, if it is another one
    PackedMoment moment_;                      ///< what the stage shows, or will
    View view_ = View::kColor;                 ///< that is asked for
    bool counting_ = false;
    View shown_ = View::kColor;                 ///< the last one for which the stage had a frame
    std::optional<LoadRequest> reading_;        ///< what was ordered and is not there
    std::optional<std::string> readingCamera_;  ///< to be shown then
    std::optional<Opened> opened_;
    std::optional<double> secondsBehind_;
    Stage::Wish wish_;
    glm::vec2 pictureSize_{1, 1};
    Clock::time_point lastMove_{}, lastLook_{};
    Latencies::Kind kind_ = Latencies::Kind::kRefine;
    int changes_ = 0, moments_ = 0;
};

}  // namespace vitrine
