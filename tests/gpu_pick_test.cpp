// SPDX-License-Identifier: MIT
// What is asked of single pixels is what whole pictures say.
#include "frame/layers.hpp"
#include "gpu_support.hpp"
#include "mesh/primitives.hpp"

namespace vitrine {
namespace {

constexpr int kWidth = 48, kHeight = 32;

class PickTest : public test::GpuTest {
  protected:
    static LoadedScene things() {
        test::TestScene made;
        Material mirror;
        mirror.metallic = 1;
        mirror.roughness = 0;
        const int ball = made.addField(
            "// bounds[-1, -1, -1,  1, 1, 1]\nfloat sdf(vec3 p) { return length(p) - 0.9; }\n");
        made.add(made.addMesh(makeTorus(0.6f, 0.25f, 24, 12)), made.addMaterial(mirror)).at = {1, 0,
                                                                                               0};
        made.add(ball).at = {-0.7f, 0.2f, 0.4f};
        made.addSun({-0.4f, -1, -0.5f}, 2);
        return made.load();
    }
    static FrameRequest request() {
        FrameRequest r;
        r.width = kWidth;
        r.height = kHeight;
        r.camera.eye = {0.5f, 1.5f, 4};
        r.camera.fov = 45;
        r.layers = true;
        return r;
    }
    static glm::vec2 middle(int x, int y) {
        return {(static_cast<float>(x) + 0.5f) / kWidth, (static_cast<float>(y) + 0.5f) / kHeight};
    }
};

TEST_F(PickTest, FindsWhatTheLayersShow) {
    const LoadedScene loaded = things();
    Frame frame(context(), loaded.packed, Backend::kFragment, false);
    frame.begin(request());
    frame.drawSample();
    const LayerImages layers = frame.layers();
    std::array<int, 3> seen{};
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const glm::uvec4 record = frame.pick(middle(x, kHeight - 1 - y));
            const uint32_t instance = layers.ids.at(x, y)[0];
            const bool surface = record::isSurface(record);
            ASSERT_EQ(surface, instance < 2) << x << ", " << y;
            ++seen[surface ? instance : 2];
            if (!surface) continue;
            ASSERT_EQ(record.x, instance) << x << ", " << y;
            if (instance == 0) {
                ASSERT_EQ(record.y, layers.ids.at(x, y)[1]) << x << ", " << y;
            }
        }
    for (const int count : seen) EXPECT_GT(count, 100);
}

TEST_F(PickTest, CountsOfPixelsAreTheCountsOfThePicture) {
    const LoadedScene loaded = things();
    for (const Backend backend : test::kBackends) {
        SCOPED_TRACE(test::nameOf(backend));
        Frame frame(context(), loaded.packed, backend, true);
        frame.begin(request());
        frame.drawSample();
        const FrameStatistics all = frame.statistics();
        (void)frame.pick({0.5f, 0.5f});
        FrameStatistics sum;
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x) {
                const PixelCounts counts = frame.countsAt(middle(x, y));
                sum.nodes += counts.nodes;
                sum.steps += counts.steps;
                sum.shadowRays += counts.shadowRays;
                sum.bounceRays += counts.bounceRays;
                sum.largestLoopCount = std::max(sum.largestLoopCount, counts.loops);
            }
        EXPECT_EQ(sum.nodes, all.nodes);
        EXPECT_EQ(sum.steps, all.steps);
        EXPECT_EQ(sum.shadowRays, all.shadowRays);
        EXPECT_EQ(sum.bounceRays, all.bounceRays);
        EXPECT_EQ(sum.largestLoopCount, all.largestLoopCount);
        EXPECT_GT(all.steps, 0u);
        EXPECT_GT(all.bounceRays, 0u);
        // Above everything there is nothing to be counted but the ray's own search.
        EXPECT_EQ(frame.countsAt({0.5f, 0.999f}).bounceRays, 0u);
    }
}

}  // namespace
}  // namespace vitrine
