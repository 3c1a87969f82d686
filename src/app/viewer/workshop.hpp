// SPDX-License-Identifier: MIT
// Reads scenes, uploads them and compiles their programs on a thread of its own, while the window
// shows what it has. Each frame is made on a context of its own, which changes threads with it: a
// software driver keeps what it has compiled for the context in which it was drawn first.
#pragma once

#include <chrono>
#include <optional>

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

  private:
    struct Free {
        std::mutex mutex;
        std::vector<std::unique_ptr<const SharedContext>> list;
    };
    Window& window_;
    std::shared_ptr<Free> free_ = std::make_shared<Free>();
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
    };
    struct Delivery {
        std::optional<LoadResult> load;
        Diagnostics problems;  ///< of snippets; then there are no frames
        std::shared_ptr<SceneFrame> frame, splitFrame;
        double seconds = 0;  ///< since it was ordered
    };

    /// The window outlives this, and this outlives all frames.
    explicit Workshop(Window& window);

    /// Takes the place of the order before, if that is not done.
    void order(Order order);
    /// Once, what was ordered last. Throws MachineError, and UsageError for a camera that is not
    /// there.
    std::optional<Delivery> take() { return background_.take(); }
    [[nodiscard]] bool busy() const { return background_.busy(); }
    /// Lets go of images that frames no longer need. When there is nothing to do.
    void settle() { images_->settle(); }
    /// Since the order in hand.
    [[nodiscard]] double seconds() const;

  private:
    using Clock = std::chrono::steady_clock;
    Delivery make(Order& order, Delivery delivery, const Checkpoint& checkpoint);

    ContextPool contexts_;
    std::shared_ptr<ImageStore> images_ = ImageStore::create();
    FieldProber prober_;  ///< the thread's, and so is
    SceneCache cache_;
    Clock::time_point orderedAt_{};
    Background<Delivery> background_;  // last: the thread uses the others
};

}  // namespace vitrine
