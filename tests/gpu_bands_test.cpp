// SPDX-License-Identifier: MIT
// A sample in many small bands is, to the last bit, the sample drawn at once.
#include "gpu_support.hpp"
#include "pack/hit_record.hpp"

namespace vitrine {
namespace {

constexpr int kWidth = 96, kHeight = 64, kSamples = 3;

class BandsTest : public test::GpuTest {};

FrameRequest request(View view, int bounces, Primary primary) {
    FrameRequest r;
    r.width = kWidth;
    r.height = kHeight;
    r.ssaa = view == View::kNormal ? 2 : 1;
    r.camera.eye = {0.5f, 1.5f, 4};
    r.camera.fov = 45;
    r.samples = kSamples;
    r.bounces = bounces;
    r.view = view;
    r.primary = primary;
    return r;
}

struct Drawn {
    ImageRgba8 picture;
    FrameStatistics statistics;
    int calls = 0;
};

Drawn atOnce(Frame& frame, const FrameRequest& r) {
    frame.begin(r);
    for (int i = 0; i < r.samples; ++i) frame.drawSample();
    return {frame.picture(), frame.statistics(), r.samples};
}

Drawn inBands(Frame& frame, const FrameRequest& r) {
    frame.begin(r);
    Drawn drawn;
    while (frame.samplesDrawn() < r.samples) {
        frame.advance(0);
        ++drawn.calls;
    }
    drawn.picture = frame.picture();
    drawn.statistics = frame.statistics();
    return drawn;
}

void expectSame(Frame& frame, const FrameRequest& r) {
    const Drawn whole = atOnce(frame, r), bands = inBands(frame, r);
    if (frame.backend() == Backend::kFragment) {
        EXPECT_GT(bands.calls, 10 * kSamples);
    }
    EXPECT_EQ(whole.picture.pixels, bands.picture.pixels);
    EXPECT_EQ(whole.statistics.nodes, bands.statistics.nodes);
    EXPECT_EQ(whole.statistics.steps, bands.statistics.steps);
    EXPECT_EQ(whole.statistics.shadowRays, bands.statistics.shadowRays);
    EXPECT_EQ(whole.statistics.bounceRays, bands.statistics.bounceRays);
    EXPECT_GT(*std::max_element(whole.picture.pixels.begin(), whole.picture.pixels.end()), 60);
}

TEST_F(BandsTest, MakeTheSamePicture) {
    for (const bool glass : {false, true}) {
        const LoadedScene loaded = test::mixedScene(glass);
        for (const bool counters : {false, true}) {
            Frame frame(context(), loaded.packed, Backend::kFragment, counters);
            for (const Primary primary : {Primary::kRaster, Primary::kTrace})
                for (const int bounces : {0, 1, 2}) {
                    SCOPED_TRACE(fmt::format("glass {} counters {} trace {} bounces {}", glass,
                                             counters, primary == Primary::kTrace, bounces));
                    expectSame(frame, request(View::kColor, bounces, primary));
                }
        }
    }
}

TEST_F(BandsTest, MakeTheSameViews) {
    const LoadedScene loaded = test::mixedScene(true);
    Frame frame(context(), loaded.packed, Backend::kFragment, true);
    for (const View view : {View::kNormal, View::kReflection, View::kShadow, View::kNodes}) {
        SCOPED_TRACE(viewNames()[static_cast<size_t>(view)]);
        expectSame(frame, request(view, 2, Primary::kRaster));
    }
}

FrameRequest throughAFilter(int ssaa) {
    FrameRequest r = request(View::kColor, 1, Primary::kRaster);
    r.camera.fStop = 0.05f;
    r.camera.focusDistance = 3;
    r.camera.lens = LensBlur::kFilter;
    r.ssaa = ssaa;
    return r;
}

/// A lens that is a filter is worked on in bands as well, and begins anew when somebody asks what
/// is under the cursor meanwhile.
TEST_F(BandsTest, BlurTheSamePicture) {
    const LoadedScene loaded = test::mixedScene(false);
    for (const bool counters : {false, true}) {
        Frame frame(context(), loaded.packed, Backend::kFragment, counters);
        FrameRequest r = throughAFilter(counters ? 2 : 1);
        expectSame(frame, r);
        r.samples = 1;
        const ImageRgba8 wanted = atOnce(frame, r).picture;
        for (const float focus : {1.5f, 6.0f}) {
            FrameRequest other = r;
            other.camera.focusDistance = focus;
            EXPECT_NE(atOnce(frame, other).picture.pixels, wanted.pixels);
        }
        frame.begin(r);
        const glm::uvec4 hit = frame.pick({0.5f, 0.5f});
        int calls = 0, whole = 0;
        while (frame.samplesDrawn() < r.samples) {
            whole += frame.advance(0);
            EXPECT_EQ(whole, frame.samplesDrawn());
            // In each phase, for either height.
            for (const int when : {5, 27, 45, 70, 90, 140})
                if (calls == when) {
                    EXPECT_EQ(frame.pick({0.5f, 0.5f}), hit);
                }
            ++calls;
        }
        EXPECT_EQ(frame.picture().pixels, wanted.pixels);
    }
}

/// Rows from the top that two pictures have in common.
int sameRows(const ImageRgba8& a, const ImageRgba8& b) {
    const size_t row = size_t{4} * kWidth;
    for (int y = 0; y < kHeight; ++y)
        if (!std::equal(a.pixels.begin() + y * row, a.pixels.begin() + (y + 1) * row,
                        b.pixels.begin() + y * row))
            return y;
    return kHeight;
}

ImageRgba8 imageOf(const Texture& picture) {
    const std::vector<uint8_t> bytes = picture.readBytes();
    ImageRgba8 image(picture.width(), picture.height());
    const size_t row = size_t{4} * static_cast<size_t>(picture.width());
    for (int y = 0; y < picture.height(); ++y)
        std::copy_n(bytes.begin() + (picture.height() - 1 - y) * row, row,
                    image.pixels.begin() + y * row);
    return image;
}

/// What is done of the first sample stands at the top; below, what was there before, stretched.
TEST_F(BandsTest, AreSeenOneByOneOverTheLastPicture) {
    const LoadedScene loaded = test::mixedScene(false);
    for (const int ssaa : {1, 2}) {
        SCOPED_TRACE(ssaa);
        Frame frame(context(), loaded.packed, Backend::kFragment, false);
        FrameRequest fine = request(View::kColor, 1, Primary::kRaster);
        fine.samples = 1;
        fine.ssaa = ssaa;
        const ImageRgba8 wanted = atOnce(frame, fine).picture;
        frame.begin(fine);
        EXPECT_EQ(sameRows(imageOf(*frame.preview()), wanted), kHeight) << "nothing is lost";
        FrameRequest coarse = fine;
        coarse.width = kWidth / 4;
        coarse.height = kHeight / 4;
        coarse.view = View::kNormal;
        frame.begin(coarse);
        frame.drawSample();
        (void)frame.display();
        frame.begin(fine);
        const ImageRgba8 before = imageOf(*frame.preview());
        EXPECT_EQ(sameRows(before, wanted), 0);
        int last = 0, grown = 0;
        while (!frame.advance(0)) {
            const ImageRgba8 now = imageOf(*frame.preview());
            const int rows = sameRows(now, wanted);
            EXPECT_GE(rows, last);
            grown += rows > last;
            last = rows;
            EXPECT_TRUE(std::equal(now.pixels.begin() + size_t{4} * kWidth * (rows + 1),
                                   now.pixels.end(),
                                   before.pixels.begin() + size_t{4} * kWidth * (rows + 1)))
                << "below row " << rows;
        }
        EXPECT_GT(grown, 4);
        EXPECT_EQ(imageOf(frame.display()).pixels, wanted.pixels);
    }
}

/// The window asks what a camera runs into while a sample is being worked on.
TEST_F(BandsTest, RaysAskedInBetweenChangeNothing) {
    const LoadedScene loaded = test::mixedScene(false);
    for (const bool counters : {false, true}) {
        SCOPED_TRACE(counters);
        RayQuery query(context(), loaded.packed, Backend::kFragment);
        Frame frame(context(), loaded.packed, Backend::kFragment, counters);
        const FrameRequest r = request(View::kColor, 2, Primary::kRaster);
        const Drawn undisturbed = inBands(frame, r);
        frame.begin(r);
        while (frame.samplesDrawn() < r.samples) {
            frame.advance(0);
            std::vector<QueryRay> rays;
            for (int i = 0; i <= 40 * frame.samplesDrawn(); ++i)
                rays.push_back(
                    {{0.5f, 1.5f, 4},
                     1e-3f,
                     glm::normalize(glm::vec3(0.03f * static_cast<float>(i) - 0.5f, -0.4f, -1)),
                     i % 7 == 0 ? 1.0f : 50.0f});
            const std::vector<glm::uvec4> found = frame.closest(rays);
            EXPECT_TRUE(found == query.closest(rays));
            EXPECT_FALSE(record::isSurface(found[0])) << "it ends before the ground";
        }
        EXPECT_EQ(frame.picture().pixels, undisturbed.picture.pixels);
        EXPECT_EQ(frame.statistics().nodes, undisturbed.statistics.nodes);
        EXPECT_EQ(frame.statistics().bounceRays, undisturbed.statistics.bounceRays);
    }
}

/// Layers are of the sharp first sample, whatever the lens.
TEST_F(BandsTest, MakeTheSameLayers) {
    const LoadedScene loaded = test::mixedScene(false);
    Frame frame(context(), loaded.packed, Backend::kFragment, true);
    for (const float fStop : {0.0f, 0.5f}) {
        SCOPED_TRACE(fStop);
        FrameRequest r = request(View::kColor, 1, Primary::kRaster);
        r.camera.fStop = fStop;
        r.layers = true;
        expectSame(frame, r);
        const LayerImages bands = frame.layers();
        atOnce(frame, r);
        const LayerImages whole = frame.layers();
        EXPECT_EQ(whole.depth.pixels, bands.depth.pixels);
        EXPECT_EQ(whole.ids.pixels, bands.ids.pixels);
        EXPECT_EQ(whole.normal.pixels, bands.normal.pixels);
    }
}

TEST_F(BandsTest, ComputeDrawsAllAtOnce) {
    if (!context().info().compute) GTEST_SKIP() << "no compute shaders";
    const LoadedScene loaded = test::mixedScene(false);
    Frame frame(context(), loaded.packed, Backend::kCompute, false);
    expectSame(frame, request(View::kColor, 2, Primary::kRaster));
}

/// The window shows the last picture while it works on a finer one.
TEST_F(BandsTest, KeepTheLastPictureUntilTheNextIsWhole) {
    const LoadedScene loaded = test::mixedScene(false);
    Frame frame(context(), loaded.packed, Backend::kFragment, false);
    FrameRequest coarse = request(View::kColor, 1, Primary::kRaster);
    coarse.width /= 4;
    coarse.height /= 4;
    frame.begin(coarse);
    frame.drawSample();
    const Texture& shown = frame.display();
    const std::vector<uint8_t> before = shown.readBytes();
    frame.begin(request(View::kColor, 1, Primary::kRaster));
    ASSERT_FALSE(frame.advance(0));
    EXPECT_EQ(shown.width(), kWidth / 4);
    EXPECT_EQ(shown.readBytes(), before);
    while (!frame.advance(0)) {
    }
    EXPECT_EQ(frame.display().width(), kWidth);
}

}  // namespace
}  // namespace vitrine
