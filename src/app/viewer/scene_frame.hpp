// SPDX-License-Identifier: MIT
// A frame on a context of its own: uploaded and compiled on one thread, drawn on another.
#pragma once

#include <memory>

#include "app/session/session.hpp"
#include "app/viewer/background.hpp"
#include "app/viewer/wish.hpp"
#include "gpu/shared_context.hpp"

namespace vitrine {

class SceneFrame {
  public:
    /// The context is current nowhere. Nothing is uploaded yet.
    SceneFrame(std::shared_ptr<const SharedContext> context, std::shared_ptr<ImageStore> images)
        : context_(std::move(context)), images_(std::move(images)) {}
    ~SceneFrame();
    SceneFrame(const SceneFrame&) = delete;
    SceneFrame& operator=(const SceneFrame&) = delete;

    enum class Extent {
        kWhole,
        kSketch,  ///< what is there soon after a field has changed: see ProgramFeatures
    };
    /// Uploads and compiles all that is needed to draw `wish`, moving and at rest, and from where
    /// the whole scene is seen. Throws InputError if a snippet does not compile.
    void prepare(const LoadedScene& scene, const PackedMoment& moment, const Wish& wish,
                 Extent extent, const Checkpoint& checkpoint);
    [[nodiscard]] bool isSketch() const { return extent_ == Extent::kSketch; }
    /// Whether all is there for this view: it is for those that show the same kind of thing as the
    /// wish. Light takes other programs than records do, and counting costs time.
    [[nodiscard]] bool canShow(View view, bool counting) const {
        return kindOf(view) == kind_ && (counting || showsCounters(view)) == counts_;
    }
    /// Whether each sample leaves counts of every pixel.
    [[nodiscard]] bool counts() const { return counts_; }

    [[nodiscard]] const SharedContext& context() const { return *context_; }
    /// Only after prepare(), and while the context is in use.
    [[nodiscard]] Frame& frame() { return *frame_; }
    [[nodiscard]] const Frame& frame() const { return *frame_; }

  private:
    enum class Kind { kLight, kRecords, kCounters };
    static Kind kindOf(View view) {
        return showsCounters(view)  ? Kind::kCounters
               : showsRecords(view) ? Kind::kRecords
                                    : Kind::kLight;
    }
    void compile(const Wish& wish, const PackedMoment& moment);
    std::shared_ptr<const SharedContext> context_;
    std::shared_ptr<ImageStore> images_;
    std::unique_ptr<Frame> frame_;
    Kind kind_ = Kind::kLight;
    Extent extent_ = Extent::kWhole;
    bool counts_ = false;
};

}  // namespace vitrine
