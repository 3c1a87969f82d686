// SPDX-License-Identifier: MIT
// Draws a packed scene, sample by sample.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>

#include "frame/first_hits.hpp"
#include "frame/pass_query.hpp"
#include "frame/passes.hpp"
#include "frame/tree_boxes.hpp"
#include "frame/view.hpp"
#include "image/image.hpp"

namespace vitrine {

/// Who finds what the camera sees.
enum class Primary { kRaster, kTrace };

/// How light is followed, in the order of VITRINE_MODE_* (shaders/shared/limits.glsl).
enum class RenderMode {
    kHybrid,     ///< mirrors and glass are followed, diffuse light between surfaces is ambient
    kReference,  ///< paths: all light there is, free of noise after enough samples
};

struct FrameRequest {
    int width = 640, height = 400;
    int ssaa = 1;  ///< what is drawn is this many times as wide and high, then averaged
    Camera camera;
    float time = 0;  ///< seconds
    int samples = 1;
    int bounces = 2;
    int seed = 0;
    View view = View::kColor;
    int treeLevel = 0;  ///< of View::kBvh
    Primary primary = Primary::kRaster;
    FieldFinder finder = FieldFinder::kFaster;  ///< behind what is rasterised
    bool timing = false;                        ///< measure the passes; always with counters
    bool layers = false;                        ///< keep what layers() needs
    RenderMode mode = RenderMode::kHybrid;
    bool quick = false;  ///< few looks for light, for a picture that moves
};

/// What one pixel of one sample has cost.
struct PixelCounts {
    uint32_t loops = 0;  ///< iterations of loops, the most in one pass
    uint32_t nodes = 0, steps = 0, shadowRays = 0, bounceRays = 0;
};

/// Sums over all samples drawn since begin(). Ray counts need counters.
struct FrameStatistics {
    uint64_t primaryRays = 0, shadowRays = 0, bounceRays = 0;
    uint64_t nodes = 0;             ///< nodes and triangles visited
    uint64_t steps = 0;             ///< evaluations of fields
    uint32_t largestLoopCount = 0;  ///< loop iterations of one pixel in one pass
    std::map<std::string, double> secondsByPass;
};

struct FrameOptions {
    /// Where frames that come and go find their images; nullptr: they make their own.
    std::shared_ptr<ImageStore> images;
    bool sketch = false;  ///< see ProgramFeatures
};

class Frame {
  public:
    /// `counters`: count rays, nodes and loops; needed by some views and for statistics.
    Frame(const Context& context, const PackedScene& scene, Backend backend, bool counters,
          FrameOptions options = {});

    /// Whether update() leaves the programs as they are; else all are compiled anew.
    [[nodiscard]] bool covers(const PackedMoment& moment) const {
        return context_.programs.covers(moment);
    }
    /// To be called before each program is compiled. If it throws, the frame can only be destroyed.
    void callBeforeCompiling(std::function<void()> call) {
        context_.programs.callBefore(std::move(call));
    }
    /// Shows another moment of the scene from the next begin() on: transforms, materials,
    /// parameters, lights, settings.
    void update(const PackedMoment& moment);
    /// Starts a picture. Throws MachineError if the GPU cannot hold its images.
    void begin(const FrameRequest& request);
    /// Draws one more sample. Throws InputError if a snippet does not compile.
    void drawSample();
    /// Works for about so many seconds on one more sample, and waits for the GPU; true when the
    /// sample is whole. Draws in bands of rows, as long as each takes a part of the time, with
    /// fragment shaders, and the whole sample at once with compute shaders, which a GPU has that
    /// needs no bands. The picture is the same as drawSample()'s to the last bit.
    bool advance(double seconds);
    [[nodiscard]] int samplesDrawn() const {
        return phase_ == Phase::kSample ? sample_ : sample_ - 1;
    }
    /// The picture of the samples so far as a texture, which stays, through begin() as well, until
    /// the next call. Not while a sample is being worked on.
    const Texture& display();
    /// The first sample as far as advance() has come, from the top, over the last display(), as a
    /// texture like that one's. nullptr where there is nothing to show before the sample is whole.
    const Texture* preview();
    /// The hit record at a place of the picture, shares of its width and height from the lower
    /// left. A sample that is being worked on begins anew.
    [[nodiscard]] glm::uvec4 pick(glm::vec2 place);
    /// What a place, as above, of the last sample has cost. Needs counters, and a sample; not while
    /// one is being worked on.
    [[nodiscard]] PixelCounts countsAt(glm::vec2 place) const;
    /// What rays meet that have nothing to do with the picture. Between samples or not.
    [[nodiscard]] std::vector<glm::uvec4> closest(std::span<const QueryRay> rays);
    /// The same as display(), top row first.
    [[nodiscard]] ImageRgba8 picture();
    /// The picture as data. Needs a request with `layers`.
    [[nodiscard]] LayerImages layers();
    [[nodiscard]] FrameStatistics statistics();
    [[nodiscard]] Backend backend() const { return context_.programs.backend(); }
    [[nodiscard]] double compileSeconds() const { return context_.programs.compileSeconds(); }

  private:
    void use(const PackedMoment& moment);
    void chooseProbes();
    void allocate();
    /// What advance() works on: a sample, and for a lens that is a filter the first hits through
    /// the middles of the pixels and the blur.
    enum class Phase { kSample, kHits, kBlur };
    void startPhase(Phase phase);
    void drawRows(Phase phase, PixelRows rows);
    void drawSampleRows();
    /// Whether it was the last one of the sample.
    bool finishPhase();
    void finishSample();
    [[nodiscard]] bool rasters() const;
    void rasterise();
    void findFirstHits();
    void followPaths();
    void followBounces();
    const Texture& finished();
    [[nodiscard]] bool fits(const Texture& picture) const;
    void addCounts();

    PassContext context_;
    RayImages queries_;
    FrameRequest request_;
    int sample_ = 0;
    Phase phase_ = Phase::kSample;
    int rowsDone_ = 0;         ///< of that phase
    int blurredSamples_ = -1;  ///< in what the filter has blurred last
    int bandRows_ = 16;
    bool countersTurned_ = false;  ///< a sample leaves its counts in the other image
    std::array<PathImages, 3> paths_;
    std::array<Texture, 2> radiance_, mean_;
    Texture black_, picture_;
    Texture preview_;
    bool previewIsOld_ = true;  ///< display() has shown more since
    int previewRows_ = 0;       ///< of preview_ that are of this sample, from the top
    Texture counted_;           ///< the counts of the last sample
    bool allocated_ = false;
    LayerTextures layers_;
    DepthImage depth_;
    FirstHitPlan hits_;
    std::vector<PackedInstance> instances_;
    TreeBoxes treeBoxes_;
    std::optional<LensFilter> lensFilter_;
    glm::ivec4 quick_{0};   ///< approximations that the scene asks for
    bool filters_ = false;  ///< the lens is a filter
    std::shared_ptr<const SkyAsset> sky_;
    int fieldRoot_ = -1;
    bool transmissive_ = false;  ///< there is glass
    bool rasterPossible_;
    int maxSide_;
    FrameStatistics statistics_;
};

}  // namespace vitrine
