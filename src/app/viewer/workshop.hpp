// SPDX-License-Identifier: MIT
// Reads scenes, uploads them and compiles their programs on threads of its own, while the window
// shows what it has. Each frame is made on a context of its own, which changes threads with it: a
// software driver keeps what it has compiled for the context in which it was drawn first.
//
// There are two benches, because to compile the whole of a scene may take a second on a CPU: at one
// of them what the user has just changed is read, at the other a whole frame is made to follow a
// sketch.
#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "app/viewer/load.hpp"
#include "app/viewer/scene_frame.hpp"
#include "gpu/window.hpp"

namespace vitrine {

/// The contexts of frames, used again when those are gone. All of it on the window's thread, but
/// for the going.
class ContextPool {
  public:
    explicit ContextPool(Window& window) : window_(window) {}
    /// Current nowhere. Throws MachineError if the driver has none to give.
    std::shared_ptr<const SharedContext> take();
    /// When there is time: new ones instead of those that have been used. llvmpipe keeps programs
    /// and images of the last scenes that it has drawn in a context until it draws there again, or
    /// the context goes. Whether any went.
    bool renew();

  private:
    using List = std::vector<std::unique_ptr<const SharedContext>>;
    struct Used {
        std::mutex mutex;
        List list;
    };
    Window& window_;
    List fresh_;
    std::shared_ptr<Used> used_ = std::make_shared<Used>();
};

/// What the driver has compiled and knows again; see ProgramFeatures::sketch.
struct CompiledText {
    std::string fields;           ///< of the last whole frame; "": there was none
    std::string sketchMaterials;  ///< of the last sketch
    ProgramFeatures sketchFeatures;
};

class Workshop {
  public:
    struct Order {
        std::optional<LoadRequest> load;
        /// Without `load`: frames of this scene, at this moment. The scene's text,
        /// LoadedScene::scene, is left to the window's thread.
        std::shared_ptr<const LoadedScene> scene;
        PackedMoment moment;
        std::optional<PackedMoment> splitMoment;  ///< if it is another one
        Wish wish;
        /// The wish is for the camera of this name of the scene that is loaded ("": the first).
        std::optional<std::string> camera;
        /// The views that frames are wanted for.
        std::optional<View> view, splitView;
        bool afterSketch = false;  ///< may be slow: there is a picture of it
    };
    struct Delivery {
        std::optional<LoadResult> load;
        Diagnostics problems;  ///< of snippets; then there are no frames
        /// Of this scene. A sketch wants to be replaced soon.
        std::shared_ptr<SceneFrame> frame, splitFrame;
        std::shared_ptr<const LoadedScene> scene;
        bool learnt = false;  ///< a sketch to teach the driver, not to be seen
        double seconds = 0;   ///< since it was ordered
    };

    /// The window outlives this, and this outlives all frames.
    explicit Workshop(Window& window);

    /// Takes the place of the order before at the same bench, if that is not done.
    void order(Order order);
    /// Once, what was ordered last at each. Throws MachineError, and UsageError for a camera that
    /// is not there.
    std::optional<Delivery> take();
    [[nodiscard]] bool busy() const { return changes_.busy() || (wholes_.busy() && !learning_); }
    /// When nothing else is being made: sees to it that the driver knows what a sketch of this
    /// scene needs besides its fields.
    void learnSketch(const std::shared_ptr<const LoadedScene>& scene, const PackedMoment& moment,
                     const Wish& wish);
    /// When there is nothing to do: lets go of what frames no longer need. Whether any have gone.
    bool settle();
    /// Since the order in hand.
    [[nodiscard]] double seconds() const;

  private:
    using Clock = std::chrono::steady_clock;
    Delivery make(Order& order, const CompiledText& compiled, Delivery delivery,
                  const Checkpoint& checkpoint);
    void remember(const Delivery& delivery);

    ContextPool contexts_;
    std::shared_ptr<ImageStore> images_ = ImageStore::create();
    CompiledText compiled_;
    std::weak_ptr<const LoadedScene> learntFrom_;
    bool learning_ = false;  ///< what wholes_ does, nobody waits for
    FieldProber prober_;     ///< the thread's of changes_, and so is
    SceneCache cache_;
    Clock::time_point orderedAt_{};
    Background<Delivery> changes_, wholes_;  // last: their threads use the others
};

}  // namespace vitrine
