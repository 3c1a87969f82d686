// SPDX-License-Identifier: MIT
// Loop iterations of one invocation. llvmpipe ends all loops, silently, after 65,535 of them,
// counted over the eight pixels that run in lockstep; VITRINE_LOOP_BUDGET ends them before that,
// and what is shipped stays far below.
#include <filesystem>

#include "gpu_support.hpp"
#include "shared/limits.glsl"

namespace vitrine {
namespace {

// Each loop that finds the budget spent has asked once more.
constexpr uint32_t kLimit = VITRINE_LOOP_BUDGET + 512;

class LoopsTest : public test::GpuTest {};

TEST_F(LoopsTest, EverySceneStaysFarBelowTheLimit) {
    int scenes = 0;
    for (const auto& entry : std::filesystem::directory_iterator("scenes")) {
        if (entry.path().extension() != ".toml") continue;
        SCOPED_TRACE(entry.path().string());
        ++scenes;
        Diagnostics diagnostics;
        const LoadedScene loaded = loadAll(entry.path(), {}, diagnostics);
        diagnostics.throwIfErrors();
        PictureRequest request;
        request.width = 320;
        request.height = 200;
        request.samples = 1;
        Renderer renderer(loaded, Backend::kAuto, true);
        (void)renderer.draw(request, nullptr);
        const uint32_t count = renderer.statistics().largestLoopCount;
        fmt::print("{}: {} iterations at most\n", entry.path().filename().string(), count);
        EXPECT_GT(count, 10u);
        EXPECT_LT(count, VITRINE_LOOP_BUDGET / 2);
    }
    EXPECT_GE(scenes, 3);
}

/// `field` in the middle of the picture, lit by three suns with ambient occlusion.
uint32_t largestCount(const std::string& field, Backend backend) {
    test::TestScene scene;
    scene.add(scene.addField(field));
    scene.scene.render.ao = 1;
    scene.setEnvironment(0.5f);
    scene.addSun({-1, -1, -1}, 1);
    scene.addSun({1, -1, -1}, 1);
    scene.addSun({0, -1, 0}, 1);
    const LoadedScene loaded = scene.load();
    PictureRequest request;
    request.width = 32;
    request.height = 24;
    Renderer renderer(loaded, backend, true);
    (void)renderer.draw(request, nullptr);
    const uint32_t count = renderer.statistics().largestLoopCount;
    fmt::print("{} iterations at most\n", count);
    return count;
}

TEST_F(LoopsTest, AnEndlessLoopInASnippetEnds) {
    for (const Backend backend : test::kBackends) {
        SCOPED_TRACE(test::nameOf(backend));
        EXPECT_LT(largestCount("// bounds[-1, -1, -1, 1, 1, 1]\n"
                               "float sdf(vec3 p) {\n"
                               "    float d = length(p) - 0.9;\n"
                               "    while (true) { d += 0.0; }\n"
                               "    return d;\n"
                               "}",
                               backend),
                  kLimit);
        EXPECT_LT(largestCount("// bounds[-1, -1, -1, 1, 1, 1]\n"
                               "float sdf(vec3 p) {\n"
                               "    float d = length(p) - 0.9;\n"
                               "    for (int i = 0; i < 100000; i++)\n"
                               "        for (int j = 0; j < 100000; j++) d += 1.0e-12;\n"
                               "    return d;\n"
                               "}",
                               backend),
                  kLimit);
    }
}

}  // namespace
}  // namespace vitrine
