// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cstdio>
#include <nlohmann/json.hpp>

#include "app/cli/commands.hpp"
#include "app/cli/exr_layers.hpp"
#include "app/cli/frames.hpp"
#include "app/cli/progress.hpp"
#include "base/file.hpp"
#include "base/text.hpp"
#include "image/png.hpp"
#include "image/video.hpp"

namespace vitrine {
namespace {

Backend parseBackend(const std::string& name) {
    if (name == "fragment") return Backend::kFragment;
    if (name == "compute") return Backend::kCompute;
    return Backend::kAuto;
}

void checkOutputName(const std::string& output, bool several) {
    if (isVideoName(output)) {
        if (!several) throw UsageError(fmt::format("-o: the film '{}' needs --frames", output));
        return;
    }
    if (!endsWith(output, ".png") && !endsWith(output, ".exr"))
        throw UsageError(fmt::format(
            "-o: '{}' must end in .png or .exr, or for a film in .mp4, .webm or .gif", output));
}

struct FileNotes {
    std::string software, title;
};

/// The bytes of a picture file, of the kind that the name asks for.
std::vector<uint8_t> drawFile(Renderer& renderer, const PictureRequest& picture,
                              const std::string& file, const FileNotes& notes,
                              const std::function<void(int, int)>& progress) {
    if (endsWith(file, ".exr"))
        return encodeLayers(renderer.drawLayers(picture, progress),
                            {{"software", notes.software}, {"title", notes.title}});
    return encodePng(renderer.draw(picture, progress),
                     {{"Software", notes.software}, {"Title", notes.title}});
}

nlohmann::ordered_json describe(const LoadedScene& loaded, Renderer& renderer,
                                const PictureRequest& picture, int samples, double seconds,
                                const std::string& version) {
    const FrameStatistics s = renderer.statistics();
    nlohmann::ordered_json json;
    json["vitrine"] = version;
    json["scene"] = loaded.scene.file;
    json["resolution"] = {picture.width, picture.height};
    json["samples"] = samples;
    json["mode"] = picture.mode == RenderMode::kReference ? "reference" : "hybrid";
    json["bounces"] = loaded.scene.render.bounces;
    json["triangles"] = loaded.packed.triangleCount;
    json["instances"] = loaded.packed.instances.size();
    json["rays"] = {{"primary", s.primaryRays}, {"shadow", s.shadowRays}, {"bounce", s.bounceRays}};
    json["primary_found_by"] =
        picture.primary == Primary::kRaster && renderer.gpu().clipControl ? "raster" : "trace";
    json["nodes_visited"] = s.nodes;
    json["field_evaluations"] = s.steps;
    json["largest_loop_count"] = s.largestLoopCount;
    json["seconds_by_pass"] = s.secondsByPass;
    json["seconds_compiling"] = renderer.compileSeconds();
    json["seconds"] = seconds;
    json["renderer"] = renderer.gpu().renderer;
    json["gl_vendor"] = renderer.gpu().vendor;
    json["gl_version"] = renderer.gpu().version;
    json["backend"] = renderer.backend() == Backend::kCompute ? "compute" : "fragment";
    return json;
}

}  // namespace

int render(const RenderOptions& options) {
    const bool several = !options.frames.empty();
    checkOutputName(options.output, several);
    const bool film = isVideoName(options.output);
    PictureRequest picture;
    std::tie(picture.width, picture.height) = parseResolution(options.resolution);
    picture.camera = options.camera;
    picture.samples = options.samples;
    picture.seed = options.seed;
    const ViewChoice view = parseView(options.view);
    picture.view = view.view;
    picture.treeLevel = view.treeLevel;
    picture.primary = options.primary == "trace" ? Primary::kTrace : Primary::kRaster;
    picture.mode = options.mode == "reference" ? RenderMode::kReference : RenderMode::kHybrid;
    const FrameRange range = several ? parseFrames(options.frames) : FrameRange{};
    // Better to fail now than after an hour of rendering.
    checkWritable(several && !film ? frameFileName(options.output, range.first) : options.output);
    if (!options.json.empty() && options.json != "-") checkWritable(options.json);

    Diagnostics diagnostics;
    FieldProber prober;
    const LoadedScene loaded = loadAll(options.file, options.overrides, prober, diagnostics);
    if (diagnostics.hasErrors()) compileSnippets(loaded, prober, diagnostics);
    diagnostics.throwIfErrors();
    if (!diagnostics.list().empty()) fmt::print(stderr, "{}\n", diagnostics.text());
    (void)findCamera(loaded.scene, options.camera);

    const bool counters = !options.json.empty() || showsCounters(picture.view);
    Renderer renderer(loaded, parseBackend(options.backend), counters);
    const int samples = options.samples.value_or(loaded.scene.render.samples);
    const int frames = (range.last - range.first) / range.step + 1;
    Progress progress(static_cast<int64_t>(frames) * samples);
    const auto start = std::chrono::steady_clock::now();
    std::optional<VideoWriter> video;
    if (film) video.emplace(options.output, picture.width, picture.height, options.fps);
    for (int i = 0; i < frames; ++i) {
        const int frame = range.first + i * range.step;
        picture.time = several ? static_cast<float>(frame) / options.fps : options.time;
        if (film) {
            video->add(renderer.draw(picture, [&](int, int) { progress.step(options.output); }));
            continue;
        }
        const std::string file = several ? frameFileName(options.output, frame) : options.output;
        writeFileAtomically(file, drawFile(renderer, picture, file,
                                           {"Vitrine " + options.version, loaded.scene.title},
                                           [&](int, int) { progress.step(file); }));
    }
    if (film) video->finish();
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    if (!options.json.empty())
        writeJson(
            options.json,
            describe(loaded, renderer, picture, samples, elapsed.count(), options.version).dump(2));
    return 0;
}

void writeJson(const std::string& file, const std::string& text) {
    if (file == "-")
        fmt::print("{}\n", text);
    else
        writeFileAtomically(file, text + "\n");
}

}  // namespace vitrine
