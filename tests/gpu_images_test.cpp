// SPDX-License-Identifier: MIT
// Images that go from one frame to the next: none is made anew, no more are kept than are of use,
// and what is in them is not seen.
#include <epoxy/gl.h>

#include <bit>

#include "gpu/image_store.hpp"
#include "gpu_support.hpp"

namespace vitrine {
namespace {

constexpr size_t kBytes = size_t{64} * 32 * 16;  // of image()

class ImagesTest : public test::GpuTest {
  protected:
    [[nodiscard]] Texture image() const { return store->take(64, 32, TexelFormat::kRgba32f); }
    [[nodiscard]] std::vector<Texture> images(size_t count) const {
        std::vector<Texture> list(count);
        for (Texture& t : list) t = image();
        return list;
    }
    std::shared_ptr<ImageStore> store = ImageStore::create();
};

TEST_F(ImagesTest, ComeAgainWhereTheyFit) {
    Texture first = image();
    const unsigned id = first.id();
    EXPECT_NE(image().id(), id) << "it is in use";
    first = {};
    EXPECT_NE(store->take(32, 32, TexelFormat::kRgba32f).id(), id);
    EXPECT_NE(store->take(64, 16, TexelFormat::kRgba32f).id(), id);
    EXPECT_NE(store->take(64, 32, TexelFormat::kRgba32ui).id(), id);
    Texture moved = image();
    EXPECT_EQ(moved.id(), id);
    first = std::move(moved);
    EXPECT_EQ(first.id(), id);
    EXPECT_EQ(store->bytesInUse(), kBytes);
    first = {};
    EXPECT_EQ(store->bytesInUse(), 0U);
}

TEST_F(ImagesTest, AreKeptForHalfAsMuchAgainAtMost) {
    std::vector<Texture> whole = images(8);
    EXPECT_EQ(store->bytesInUse(), 8 * kBytes);
    whole.clear();
    EXPECT_EQ(store->bytesKept(), 8 * kBytes) << "the whole set, while a coarse one is used";
    // Coarse ones of several sizes, one after the other: 16 by 8 pixels to 64 by 32.
    for (const int part : {1, 2, 3, 4}) {
        std::vector<Texture> coarse;
        for (int i = 0; i < 8; ++i)
            coarse.push_back(store->take(16 * part, 8 * part, TexelFormat::kRgba32f));
        EXPECT_LE(store->bytesInUse() + store->bytesKept(), 12 * kBytes);
    }
    store->settle();
    EXPECT_EQ(store->bytesKept(), 0U) << "nothing is in use";
    whole = images(8);
    {
        const std::vector<Texture> more = images(8);
        EXPECT_EQ(store->bytesInUse(), 16 * kBytes);
    }
    EXPECT_EQ(store->bytesKept(), 8 * kBytes);
    store->settle();
    EXPECT_EQ(store->bytesKept(), 4 * kBytes);
}

TEST_F(ImagesTest, OutliveTheirStore) {
    const Texture last = image();
    store.reset();
    EXPECT_EQ(last.width(), 64);
}

/// Of a size for which llvmpipe would compile every program once more (texture.cpp).
bool isUnusual(const TexelBuffer& buffer) {
    GLint size = 0;
    glBindTexture(GL_TEXTURE_BUFFER, buffer.id());
    glGetTexLevelParameteriv(GL_TEXTURE_BUFFER, 0, GL_TEXTURE_BUFFER_SIZE, &size);
    EXPECT_GT(size, 0);
    return std::has_single_bit(static_cast<unsigned>(size)) || (size >> 8 & 0xff) == 0;
}

TEST_F(ImagesTest, AndBuffersAreOfUsualSizes) {
    for (const size_t texels : {0, 1, 3, 16, 17, 64, 512, 513, 4096, 4097, 4112, 8192, 16384}) {
        SCOPED_TRACE(texels);
        const std::vector<glm::vec4> data(texels, glm::vec4(1, 2, 3, 4));
        TexelBuffer buffer(TexelFormat::kRgba32f);
        buffer.upload(std::as_bytes(std::span(data)));
        EXPECT_FALSE(isUnusual(buffer));
        buffer.upload(std::as_bytes(std::span(data)), 16);
        EXPECT_FALSE(isUnusual(buffer));
        buffer.replaceEnd(texels, std::as_bytes(std::span(data)));
        EXPECT_FALSE(isUnusual(buffer));
    }
}

FrameRequest request(int width, int height, View view) {
    FrameRequest r;
    r.width = width;
    r.height = height;
    r.camera.eye = {0.5f, 1.5f, 4};
    r.camera.fov = 45;
    r.camera.fStop = 0.05f;
    r.camera.focusDistance = 3;
    r.camera.lens = LensBlur::kFilter;
    r.samples = 2;
    r.view = view;
    r.layers = view == View::kColor;
    return r;
}

std::vector<uint8_t> draw(Frame& frame, const FrameRequest& r) {
    frame.begin(r);
    for (int i = 0; i < r.samples; ++i) frame.drawSample();
    return frame.picture().pixels;
}

/// Not a number, and records of what does not exist.
void spoil(ImageStore& store, int width, int height) {
    std::vector<Texture> list;
    for (int i = 0; i < 24; ++i)
        for (const TexelFormat format : {TexelFormat::kRgba32f, TexelFormat::kRgba32ui}) {
            list.push_back(store.take(width, height, format));
            list.back().write(std::vector<std::byte>(list.back().bytes(), std::byte{0xff}));
        }
}

/// As in a window, where frames come and go and the picture is coarse while it moves.
TEST_F(ImagesTest, ShowNothingOfWhatWasInThem) {
    const LoadedScene loaded = test::mixedScene(true);
    for (const bool counters : {false, true}) {
        Frame own(context(), loaded.packed, Backend::kFragment, counters);
        std::optional<Frame> frame;
        for (const View view : {View::kColor, View::kNormal, View::kReflection})
            for (const int part : {1, 2, 1}) {
                SCOPED_TRACE(fmt::format("{} 1/{} counters {}",
                                         viewNames()[static_cast<size_t>(view)], part, counters));
                const int width = 96 / part, height = 64 / part;
                // The picture, the atlas of the filter, the tiles of it (lens_filter.cpp).
                spoil(*store, width, height);
                spoil(*store, width + width / 2, height);
                spoil(*store, width / 16, height / 16);
                if (part == 1)
                    frame.emplace(context(), loaded.packed, Backend::kFragment, counters,
                                  FrameOptions{store});
                const FrameRequest r = request(width, height, view);
                const std::vector<uint8_t> wanted = draw(own, r);
                EXPECT_EQ(draw(*frame, r), wanted);
                EXPECT_GT(*std::max_element(wanted.begin(), wanted.end()), 60);
            }
    }
}

}  // namespace
}  // namespace vitrine
