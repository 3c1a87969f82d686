// SPDX-License-Identifier: MIT
// Where a frame's time goes, on a scene: who finds the first hits faster, the rasteriser (with the
// boxes of the fields or with the tree over them) or the tracer, and what each pass of a whole
// frame costs, with the rays that it traced.
//
// The finders run in turn, so that a slow moment of the machine hits both; the ratio is the
// median over the rounds. On a software driver the time is that of the processor, which counts no
// waiting for other programs; on a GPU it is wall time.
//
//   frame_bench [--scene FILE] [--size WxH] [--pairs N] [--first-hits] [--json FILE]
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/session/session.hpp"
#include "base/file.hpp"
#include "first_hits.hpp"
#include "frame/frame.hpp"

namespace vitrine {
namespace {

struct Options {
    std::string scene = VITRINE_ROOT "/scenes/tank.toml", json;
    int width = 1920, height = 1200;
    int pairs = 7;
    bool frame = true;
};

LoadedScene load(const Options& options, const std::vector<std::string>& overrides) {
    Diagnostics diagnostics;
    LoadedScene loaded = loadAll(options.scene, overrides, diagnostics);
    diagnostics.throwIfErrors();
    return loaded;
}

nlohmann::json benchFirstHits(const Context& gpu, const LoadedScene& loaded, const Options& options,
                              int ssaa) {
    const int width = options.width * ssaa, height = options.height * ssaa;
    FirstHits finders(gpu, loaded.packed, loaded.scene.cameras[0], width, height);
    const FirstHits::Result r = finders.compare(options.pairs);
    std::printf(
        "%5d x %-5d raster %7.1f ms (cover %.2f)  with the tree %7.1f ms, ratio %.2f  trace %7.1f "
        "ms, ratio %.2f\n",
        width, height, 1e3 * r.boxes, finders.cover(), 1e3 * r.tree, r.treeRatio, 1e3 * r.trace,
        r.traceRatio);
    return {{"width", width},
            {"height", height},
            {"cover", finders.cover()},
            {"raster_seconds", r.boxes},
            {"raster_with_tree_seconds", r.tree},
            {"trace_seconds", r.trace},
            {"tree_ratio", r.treeRatio},
            {"ratio", r.traceRatio}};
}

/// One whole frame, twice: without counters for the time, with them for the rays.
nlohmann::json benchFrame(const Context& gpu, const Options& options) {
    const LoadedScene loaded = load(options, {"render.ssaa=2", "render.bounces=2"});
    FrameRequest request;
    request.width = options.width;
    request.height = options.height;
    request.camera = loaded.scene.cameras[0];
    request.ssaa = 2;
    request.bounces = 2;
    const auto draw = [&](Frame& frame, int samples) {
        frame.begin(request);
        for (int i = 0; i < samples; ++i) frame.drawSample();
        (void)frame.picture();
        return frame.statistics();
    };
    Frame timed(gpu, loaded.packed, Backend::kAuto, false);
    request.timing = true;
    draw(timed, 1);  // compiles
    const FrameStatistics time = draw(timed, 1);
    Frame counted(gpu, loaded.packed, Backend::kAuto, true);
    const FrameStatistics rays = draw(counted, 1);

    std::printf("\n%d x %d pixels, ssaa 2, 2 bounces, one sample; seconds of wall time\n",
                options.width, options.height);
    const std::map<std::string, uint64_t> raysByPass{{"raster", rays.primaryRays},
                                                     {"march", rays.primaryRays},
                                                     {"visibility", rays.primaryRays},
                                                     {"light", rays.shadowRays},
                                                     {"bounce", rays.bounceRays}};
    nlohmann::json rows;
    std::printf("%-12s %8s %12s %10s\n", "pass", "seconds", "rays", "Mrays/s");
    for (const auto& [pass, seconds] : time.secondsByPass) {
        const auto found = raysByPass.find(pass);
        const double count = found == raysByPass.end() ? 0 : static_cast<double>(found->second);
        std::printf("%-12s %8.3f", pass.c_str(), seconds);
        if (count > 0) std::printf(" %12.0f %10.2f", count, 1e-6 * count / seconds);
        std::printf("\n");
        rows.push_back({{"pass", pass}, {"seconds", seconds}, {"rays", count}});
    }
    return rows;
}

int run(const Options& options) {
    const auto context = Context::createHeadless();
    std::printf("%s\n%s\n", context->info().renderer.c_str(), options.scene.c_str());
    const LoadedScene loaded = load(options, {});
    nlohmann::json report{{"renderer", context->info().renderer}, {"scene", options.scene}};
    for (const int ssaa : {1, 2})
        report["first_hits"].push_back(benchFirstHits(*context, loaded, options, ssaa));
    if (options.frame) report["frame"] = benchFrame(*context, options);
    if (!options.json.empty()) writeFileAtomically(options.json, report.dump(2) + "\n");
    return 0;
}

}  // namespace
}  // namespace vitrine

int main(int argc, char** argv) {
    vitrine::Options options;
    for (int i = 1; i < argc; ++i) {
        const std::string argument = argv[i];
        const bool valued = i + 1 < argc;
        if (argument == "--first-hits") {
            options.frame = false;
        } else if (argument == "--scene" && valued) {
            options.scene = argv[++i];
        } else if (argument == "--json" && valued) {
            options.json = argv[++i];
        } else if (argument == "--pairs" && valued) {
            options.pairs = std::max(1, std::atoi(argv[++i]));
        } else if (argument == "--size" && valued &&
                   std::sscanf(argv[++i], "%dx%d", &options.width, &options.height) == 2 &&
                   options.width > 0 && options.height > 0) {
            continue;
        } else {
            std::fprintf(stderr,
                         "usage: frame_bench [--scene FILE] [--size WxH] [--pairs N] "
                         "[--first-hits] [--json FILE]\n");
            return 2;
        }
    }
    try {
        return vitrine::run(options);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "frame_bench: %s\n", error.what());
        return 1;
    }
}
