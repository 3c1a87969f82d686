// SPDX-License-Identifier: MIT
#include "frame/frame.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>

#include "frame/sharp_lens.hpp"
#include "pack/camera.hpp"

namespace vitrine {
namespace {

// Of a picture of one sample.
constexpr int kAmbientProbes = 16, kSkyProbes = 4, kSubstanceProbes = 8;
constexpr int kQuickProbes = 3;

}  // namespace

Frame::Frame(const Context& context, const PackedScene& scene, Backend backend, bool counters,
             FrameOptions options)
    : context_(context.info(),
               ProgramSet(context.info(), backend, scene.shaders,
                          featuresOf(scene, counters, options.sketch)),
               counters, std::move(options.images)),
      rasterPossible_(context.info().clipControl),
      maxSide_(context.info().maxTextureSize) {
    context_.scene.upload(scene);
    sky_ = scene.sky;
    use(scene);
}

void Frame::update(const PackedMoment& moment) {
    context_.scene.update(moment);
    use(moment);
}

void Frame::use(const PackedMoment& moment) {
    context_.programs.require(moment);
    context_.block = moment.block;
    instances_ = moment.instances;
    quick_ = moment.block.quick;
    fieldRoot_ = moment.fieldRoot;
    // Glass needs another set of paths, which begin() makes with the other images.
    if (moment.hasTransmission && !transmissive_) allocated_ = false;
    transmissive_ = transmissive_ || moment.hasTransmission;
}

void Frame::begin(const FrameRequest& request) {
    const bool resized = request.layers != request_.layers || request.width != request_.width ||
                         request.height != request_.height || request.ssaa != request_.ssaa ||
                         !allocated_;
    request_ = request;
    sample_ = 0;
    phase_ = Phase::kSample;
    rowsDone_ = previewRows_ = 0;
    blurredSamples_ = -1;
    statistics_ = {};
    context_.timer().reset();
    context_.timing = context_.counting || request.timing;

    FrameBlock& block = context_.block;
    const int width = request.width * request.ssaa, height = request.height * request.ssaa;
    if (std::max(width, height) > maxSide_)
        throw MachineError(
            fmt::format("{}x{} pixels are drawn with render.ssaa = {}; this driver "
                        "allows {} a side",
                        width, height, request.ssaa, maxSide_));
    packCamera(request.camera, width, height, block);
    filters_ = request.camera.lens == LensBlur::kFilter && block.lens.x > 0 &&
               !showsRecords(request.view) && !showsCounters(request.view);
    if (filters_) block.lens.w = block.lens.x;
    // One sample, and what is to be filtered, looks through the middle of the lens.
    if (request.samples <= 1 || filters_) block.lens.x = 0;
    // The reference takes no short cuts with light.
    block.quick = request.mode == RenderMode::kReference ? glm::ivec4(0) : quick_;
    block.shading.x = request.time;
    block.image.w = static_cast<int>(request.view);
    block.path.x = static_cast<int>(request.mode);
    const bool firstHitOnly = request.view == View::kDirect || request.view == View::kShadow ||
                              request.view == View::kAo || request.view == View::kThickness;
    block.path.y = firstHitOnly ? 0 : request.bounces;
    block.sampling.y = request.samples;
    block.sampling.w = request.seed;
    chooseProbes();
    if (request.view == View::kBvh) treeBoxes_.upload(treeLevel(instances_, request.treeLevel));
    if (filters_ && (resized || !lensFilter_))
        lensFilter_.emplace(context_, width, height, maxSide_);
    if (resized) allocate();
}

void Frame::allocate() {
    const int width = request_.width * request_.ssaa, height = request_.height * request_.ssaa;
    layers_ = {};
    if (request_.layers) layers_.allocate(width, height);
    const auto image = [&](TexelFormat f) { return context_.image(width, height, f); };
    for (size_t i = 0; i < (transmissive_ ? 3 : 2); ++i)
        paths_[i] = context_.pathImages(width, height);
    for (Texture& t : radiance_) t = image(TexelFormat::kRgba32f);
    for (Texture& t : mean_) t = image(TexelFormat::kRgba32f);
    for (Texture& t : context_.counters) t = image(TexelFormat::kRgba32ui);
    if (context_.counting) counted_ = image(TexelFormat::kRgba32ui);
    depth_ = DepthImage(width, height);
    black_ = image(TexelFormat::kRgba32f);
    black_.clear();
    allocated_ = true;
}

/// How many ways each hit looks for light. Few samples a pixel look more often each, so that a
/// picture of one sample is not speckled; later hits look less often.
void Frame::chooseProbes() {
    FrameBlock& block = context_.block;
    const auto share = [&](int all) { return std::clamp(all / request_.samples, 1, all); };
    const auto later = [](int first) { return std::max(1, first / 4); };
    const bool reference = request_.mode == RenderMode::kReference;
    const int ambient = reference ? 0 : share(request_.quick ? kQuickProbes : kAmbientProbes);
    block.probes.y = ambient;
    block.probes.z = reference ? 0 : later(ambient);
    block.probes.w = share(kSubstanceProbes);
    block.sky.w = reference ? 1.0f : 0.0f;
    block.skyTree = glm::ivec4(0);
    if (sky_ == nullptr) return;
    const SkyMap& map = sky_->map;
    const SkyTree& tree = reference ? map.whole : map.bright;
    block.skyTree.x = reference ? static_cast<int>(map.bright.nodes.size()) : 0;
    block.skyTree.y = tree.levels;
    if (tree.levels == 0) return;
    block.skyTree.z = reference ? 1 : share(request_.quick ? 1 : kSkyProbes);
    block.skyTree.w = reference ? 1 : later(block.skyTree.z);
}

void Frame::drawSample() {
    startPhase(Phase::kSample);
    drawRows(Phase::kSample, {});
    finishSample();
}

bool Frame::advance(double seconds) {
    if (backend() == Backend::kCompute) {
        drawSample();
        finishGpu();
        return true;
    }
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    const auto since = [](Clock::time_point t) {
        return std::chrono::duration<double>(Clock::now() - t).count();
    };
    const int height = request_.height * request_.ssaa;
    do {
        if (rowsDone_ == 0) startPhase(phase_);
        const auto bandStart = Clock::now();
        const int end = std::min(rowsDone_ + bandRows_, height);
        drawRows(phase_, {height - end, height - rowsDone_});  // from the top, as people read
        finishGpu();
        rowsDone_ = end;
        // Rows differ in what they cost: a quarter of the time leaves room for dearer ones.
        const double ratio = seconds / 4 / std::max(since(bandStart), 1e-6);
        bandRows_ = std::clamp(static_cast<int>(bandRows_ * std::clamp(ratio, 0.2, 2.0)), 4, 4096);
        if (rowsDone_ == height && finishPhase()) return true;
    } while (since(start) < seconds);
    return false;
}

bool Frame::finishPhase() {
    rowsDone_ = 0;
    if (phase_ == Phase::kSample) {
        finishSample();
        if (!filters_) return true;
        phase_ = Phase::kHits;
        return false;
    }
    if (phase_ == Phase::kHits) {
        phase_ = Phase::kBlur;
        return false;
    }
    phase_ = Phase::kSample;
    blurredSamples_ = sample_;
    return true;
}

/// What is done for the whole picture at once.
void Frame::startPhase(Phase phase) {
    context_.block.jitter = glm::vec4(0, 0, request_.ssaa, 0);
    // The bounces have overwritten the records.
    if (phase == Phase::kHits) rasterise();
    if (phase == Phase::kBlur) lensFilter_->prepare(context_, mean_[0], paths_[0].records);
    if (phase != Phase::kSample) return;
    context_.block.sampling.x = sample_;
    const glm::vec2 jitter = sampleOffset(sample_, request_.samples);
    context_.block.jitter = glm::vec4(jitter, request_.ssaa, 0);
    std::optional<SharpLens> sharp;
    if (request_.layers && sample_ == 0) sharp.emplace(context_.block);
    rasterise();
}

/// A phase's passes over some rows. No pass reads another pixel of this phase than its own, so that
/// rows are independent of each other; every call finds the counters, which change places, as the
/// first did.
void Frame::drawRows(Phase phase, PixelRows rows) {
    const auto firstCounters = context_.counters[0].id();
    context_.rows = rows;
    if (phase == Phase::kSample) drawSampleRows();
    if (phase == Phase::kHits) findFirstHits();
    if (phase == Phase::kBlur) lensFilter_->blur(context_);
    context_.rows = {};
    const bool turned = context_.counters[0].id() != firstCounters;
    if (turned) std::swap(context_.counters[0], context_.counters[1]);
    if (phase == Phase::kSample) countersTurned_ = turned;
}

void Frame::drawSampleRows() {
    if (request_.layers && sample_ == 0) {
        const SharpLens sharp(context_.block);
        findFirstHits();
        layersPass(context_, paths_[0].records, layers_);
    }
    // A lens has other rays than the rasteriser.
    if (sample_ > 0 || !request_.layers || context_.block.lens.x > 0) findFirstHits();
    if (!showsRecords(request_.view)) followPaths();
    if (showsRecords(request_.view) || showsCounters(request_.view)) {
        // The records of the camera rays are gone after the bounces; counters need no records.
        viewPass(context_, paths_[0].records, radiance_[0]);
    }
    accumulatePass(context_, radiance_[0], mean_[0], mean_[1]);
}

void Frame::finishSample() {
    if (countersTurned_) std::swap(context_.counters[0], context_.counters[1]);
    std::swap(mean_[0], mean_[1]);
    if (context_.counting) {
        addCounts();
        std::swap(context_.counters[0], counted_);  // picking counts, too
    }
    ++sample_;
}

/// The rasteriser has one eye; through a lens each pixel looks from a point of its own.
bool Frame::rasters() const {
    return request_.primary == Primary::kRaster && rasterPossible_ && context_.block.lens.x <= 0;
}

/// What of the first hits is found for the whole picture at once, if they are rasterised: meshes
/// and, with counters, which are written as a whole, fields.
void Frame::rasterise() {
    if (!rasters()) return;
    hits_ = planFirstHits(context_, instances_, request_.finder);
    rasterMeshes(context_, hits_, depth_, paths_[1].records, paths_[0].records);
    if (context_.counting)
        findFields(context_, hits_, fieldRoot_, depth_, paths_[1].records, paths_[0].records);
}

void Frame::findFirstHits() {
    context_.block.sampling.z = 0;
    if (!rasters())
        visibilityPass(context_, paths_[0].records);
    else if (!context_.counting)
        findFields(context_, hits_, fieldRoot_, depth_, paths_[1].records, paths_[0].records);
}

/// Light at the first hits, then bounce by bounce. Leaves the result in radiance_[0].
void Frame::followPaths() {
    const bool reflectionOnly = request_.view == View::kReflection;
    context_.block.path.z = transmissive_ ? VITRINE_SPLIT_REFLECT : VITRINE_SPLIT_NONE;
    if (reflectionOnly)
        radiance_[0].clear();
    else
        lightPass(context_, paths_[0], black_, radiance_[0]);
    followBounces();
    if (!transmissive_ || reflectionOnly) return;
    // The first glass both mirrors and lets through, without noise; what stands behind chooses.
    context_.block.path.z = VITRINE_SPLIT_TRANSMIT;
    context_.block.sampling.z = 0;
    followBounces();
}

/// From the first hits in paths_[0], which scenes with glass need twice and which stay there then.
void Frame::followBounces() {
    const PathImages* from = &paths_[0];
    PathImages *to = &paths_[1], *next = &paths_[transmissive_ ? 2 : 0];
    for (int bounce = 0; bounce < context_.block.path.y; ++bounce) {
        bouncePass(context_, *from, *to);
        lightPass(context_, *to, radiance_[0], radiance_[1]);
        std::swap(radiance_[0], radiance_[1]);
        from = to;
        std::swap(to, next);
    }
}

}  // namespace vitrine
