// SPDX-License-Identifier: MIT
// No program takes more than a second from text to its first pixels without the driver's cache:
// with the features and snippets of the scenes that ask most of it. llvmpipe generates code at the
// first draw, so that is measured too. The seconds are the processor's on a software driver, which
// compiles where it is called. A busy machine's caches and clock stretch these too, by up to one
// and a half as measured, and so is the limit; the printed table is what to read.
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <functional>

#include "frame/passes.hpp"
#include "gpu_support.hpp"
#include "pack/camera.hpp"

namespace vitrine {
namespace {

constexpr double kLimitSeconds = 1.5;
constexpr int kSide = 8;

// Mesa reads this when it makes its first context.
const int kCacheIsOff = setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);

class CompileTest : public test::GpuTest {};

double secondsOf(const Context& gpu, const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    const std::clock_t cpuStart = std::clock();
    work();
    const std::clock_t cpuEnd = std::clock();
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
    return gpu.info().software ? static_cast<double>(cpuEnd - cpuStart) / CLOCKS_PER_SEC
                               : wall.count();
}

void measurePasses(const Context& gpu, const LoadedScene& loaded, Backend backend, bool counters) {
    PassContext context(
        gpu.info(),
        ProgramSet(gpu.info(), backend, loaded.packed.shaders, featuresOf(loaded.packed, counters)),
        counters);
    context.scene.upload(loaded.packed);
    context.block = loaded.packed.block;
    packCamera(loaded.scene.cameras[0], kSide, kSide, context.block);
    const auto image = [](TexelFormat format) { return Texture(kSide, kSide, format); };
    for (Texture& t : context.counters) t = image(TexelFormat::kRgba32ui);
    PathImages from = context.pathImages(kSide, kSide), to = context.pathImages(kSide, kSide);
    Texture before = image(TexelFormat::kRgba32f), after = image(TexelFormat::kRgba32f);
    Texture picture = image(TexelFormat::kRgba8);
    before.clear();
    // Two tiles of the lens filter and their atlas would do with less.
    FocusImages focus{image(TexelFormat::kRgba32f), image(TexelFormat::kRgba32f),
                      image(TexelFormat::kRgba32f)};
    struct Step {
        const char* pass;
        std::function<void()> draw;
        int onlyField = kAllFields;
    };
    std::vector<Step> steps{
        {"visibility", [&] { visibilityPass(context, from.records); }},
        {"light", [&] { lightPass(context, from, before, after); }},
        {"bounce", [&] { bouncePass(context, from, to); }},
        {"view", [&] { viewPass(context, to.records, after); }},
        {"accumulate", [&] { accumulatePass(context, before, before, after); }},
        {"focus_levels", [&] { focusLevelsPass(context, before, from.records, focus); }},
        {"focus_reach", [&] { focusReachPass(context, focus); }},
        {"focus", [&] { focusPass(context, focus, after); }},
        {"display", [&] { displayPass(context, after, picture); }},
    };
    const DepthImage depth(kSide, kSide);
    for (const auto& group : fieldBoxes(context.block, loaded.packed.instances).groups)
        steps.push_back({"march",
                         [&, one = FieldBoxes{{group}, 0}] {
                             marchPass(context, one, depth, true, from.records);
                         },
                         group.field});
    for (const Step& step : steps) {
        const double compile =
            secondsOf(gpu, [&] { (void)context.programs.get(step.pass, step.onlyField); });
        const double draw = secondsOf(gpu, [&] {
            step.draw();
            finishGpu();
        });
        fmt::print("{:<15} {:<9} {:<8} {:8.0f} {:10.0f} {:8.0f}\n", step.pass,
                   test::nameOf(backend), counters ? "yes" : "no", 1e3 * compile, 1e3 * draw,
                   1e3 * (compile + draw));
        EXPECT_LT(compile + draw, kLimitSeconds) << step.pass;
    }
}

void measureQueries(const Context& gpu, const LoadedScene& loaded, Backend backend) {
    RayQuery query(gpu, loaded.packed, backend);
    const std::vector<QueryRay> rays(1, {{0, 1, 5}, 0, {0, 0, -1}});
    query.prepare(rays);
    for (const bool any : {false, true}) {
        const double seconds = secondsOf(gpu, [&] { query.repeat(any); });
        fmt::print("{:<15} {:<9} {:<8} {:>8} {:>10} {:8.0f}\n", any ? "query_any" : "query_closest",
                   test::nameOf(backend), "no", "", "", 1e3 * seconds);
        EXPECT_LT(seconds, kLimitSeconds);
    }
}

TEST_F(CompileTest, EveryProgramIsReadyInASecond) {
    ASSERT_EQ(kCacheIsOff, 0);
    fmt::print("{}\n", context().info().renderer);
    struct Case {
        const char* name;
        bool counters = false;
        std::vector<std::string> overrides = {};
    };
    // The last: with the short cuts of fields, which no scene takes unasked.
    const std::vector<std::string> quick{"render.ao_mode=taps", "render.shadows=penumbra",
                                         "light.key.radius=2"};
    const Case scenes[] = {{"lesson-both"},  {"lesson-both", true}, {"robot"},
                           {"vitrine-case"}, {"patterns"},          {"robot", false, quick}};
    for (const auto& [name, counters, overrides] : scenes) {
        SCOPED_TRACE(name);
        Diagnostics diagnostics;
        const LoadedScene loaded =
            loadAll(fmt::format("scenes/{}.toml", name), overrides, diagnostics);
        diagnostics.throwIfErrors();
        fmt::print("{:<15} {:<9} {:<8} {:>8} {:>10} {:>8}\n", name, "back end", "counters",
                   "text ms", "pixels ms", "sum ms");
        for (const Backend backend : test::kBackends) {
            measurePasses(context(), loaded, backend, counters);
            if (!counters) measureQueries(context(), loaded, backend);
        }
    }
}

// With textures (tank) and with a sky's picture, whose samplers are of another kind.
TEST_F(CompileTest, TheSecondSampleCompilesNothing) {
    ASSERT_EQ(kCacheIsOff, 0);
    for (const char* name : {"lesson-both", "tank", "patterns"}) {
        Diagnostics diagnostics;
        const LoadedScene loaded = loadAll(fmt::format("scenes/{}.toml", name), {}, diagnostics);
        diagnostics.throwIfErrors();
        Frame frame(context(), loaded.packed, Backend::kFragment, false);
        FrameRequest request;
        request.width = request.height = kSide + 1;
        request.camera = loaded.scene.cameras[0];
        request.samples = 2;
        frame.begin(request);
        const auto sample = [&] {
            return secondsOf(context(), [&] {
                frame.drawSample();
                finishGpu();
            });
        };
        const double first = sample(), second = sample();
        fmt::print("{:<15} first sample {:6.0f} ms, second {:6.0f} ms\n", name, 1e3 * first,
                   1e3 * second);
        EXPECT_LT(second, first / 4) << name;
        // Nor does one after a view that reads its images in the places of buffers.
        request.view = View::kNormal;
        frame.begin(request);
        (void)sample();
        request.view = View::kColor;
        frame.begin(request);
        const double later = sample();
        EXPECT_LT(later, first / 4) << name << " after a view of normals";
    }
}

}  // namespace
}  // namespace vitrine
