// SPDX-License-Identifier: MIT
#include "gltf/test_model.hpp"
#include "image/png.hpp"

namespace vitrine {
namespace {

using Json = nlohmann::json;
using GltfTextures = GltfTest;

std::string pngOf(int width, int height) {
    ImageRgba8 image(width, height);
    for (uint8_t& value : image.pixels) value = 200;
    const auto bytes = encodePng(image);
    return {bytes.begin(), bytes.end()};
}

TEST_F(GltfTextures, PicturesComeFromViewsFilesAndUris) {
    TestModel model;
    const std::string png = pngOf(3, 2);
    std::filesystem::create_directory(folder / "maps");
    write("maps/ä 1.png", pngOf(5, 4));
    model.add("images", {{"bufferView", model.addView(std::vector<char>(png.begin(), png.end()))},
                         {"mimeType", "image/png"},
                         {"name", "inside"}});
    model.add("images", {{"uri", "maps/%C3%A4%201.png"}});
    model.add("images", {{"uri", "data:image/png;base64," + base64(png)}});
    const GltfModel read = readGood(model);
    ASSERT_EQ(read.images.size(), 3u);
    EXPECT_EQ(read.images[0].name, "inside");
    EXPECT_EQ(read.images[0].bytes, png);
    EXPECT_EQ(read.images[0].width, 3);
    EXPECT_EQ(read.images[1].name, "maps/%C3%A4%201.png");
    EXPECT_EQ(read.images[1].height, 4);
    EXPECT_EQ(read.images[2].name, "image 2");
    EXPECT_EQ(read.images[2].bytes, png);
    Diagnostics diagnostics;
    const ImageRgba8 pixels = decodeGltfImage(read.images[1], "m.glb", diagnostics);
    EXPECT_EQ(pixels.width, 5);
    EXPECT_EQ(pixels.at(4, 3)[0], 200);
    EXPECT_TRUE(diagnostics.list().empty());
}

TEST_F(GltfTextures, ReadsSamplers) {
    TestModel model;
    model.add("images", {{"uri", "data:image/png;base64," + base64(pngOf(1, 1))}});
    model.add("samplers",
              {{"wrapS", 33071}, {"wrapT", 33648}, {"magFilter", 9728}, {"minFilter", 9985}});
    model.add("samplers", {{"minFilter", 9728}});
    model.add("textures", {{"source", 0}, {"sampler", 0}});
    model.add("textures", {{"source", 0}, {"sampler", 1}});
    model.add("textures", {{"source", 0}});
    const auto textures = readGood(model).textures;
    ASSERT_EQ(textures.size(), 3u);
    EXPECT_EQ(textures[0].image, 0);
    EXPECT_EQ(textures[0].wrapS, GltfWrap::kClampToEdge);
    EXPECT_EQ(textures[0].wrapT, GltfWrap::kMirroredRepeat);
    EXPECT_EQ(textures[0].magFilter, GltfFilter::kNearest);
    EXPECT_EQ(textures[0].minFilter, GltfFilter::kLinear);
    EXPECT_EQ(textures[0].mipmap, GltfMipmap::kNearest);
    EXPECT_EQ(textures[1].minFilter, GltfFilter::kNearest);
    EXPECT_EQ(textures[1].mipmap, GltfMipmap::kNone);
    EXPECT_EQ(textures[2].wrapS, GltfWrap::kRepeat);
    EXPECT_EQ(textures[2].mipmap, GltfMipmap::kLinear);
}

TEST_F(GltfTextures, BadPicturesAreWarningsAndBecomeACheckerboard) {
    TestModel model;
    std::string lying = pngOf(4, 4);
    lying.replace(16, 4, std::string("\x00\x01\x00\x00", 4));
    write("lying.png", lying);
    const std::string whole = pngOf(4, 4);
    write("cut.png", whole.substr(0, whole.size() - 4));
    write("text.png", "hello");
    write("empty.png", "");
    for (const char* file : {"missing.png", "lying.png", "text.png", "empty.png", "cut.png"})
        model.add("images", {{"uri", file}});
    model.add("textures", {{"source", 0}});
    model.add("textures", {{"extensions", {{"EXT_texture_webp", {{"source", 0}}}}}});
    const auto result = read(model.glb());
    ASSERT_TRUE(result) << messages;
    EXPECT_NE(messages.find("m.glb: warning: /images/0: cannot read: No such file or directory"),
              std::string::npos)
        << messages;
    for (const char* place : {"/images/1: PNG", "/images/2: ", "/images/3: ", "/textures/1: "})
        EXPECT_NE(messages.find(std::string("m.glb: warning: ") + place), std::string::npos)
            << place << "\n"
            << messages;
    EXPECT_EQ(result->textures[1].image, kNoIndex);
    EXPECT_EQ(result->images[4].width, 4) << "the damage is behind the header";
    for (const GltfImage& image : result->images) {
        Diagnostics diagnostics;
        const ImageRgba8 pixels = decodeGltfImage(image, "m.glb", diagnostics);
        EXPECT_EQ(pixels.width, 8);
        EXPECT_EQ(pixels.at(0, 0)[0], 255);
        EXPECT_EQ(pixels.at(0, 0)[1], 0);
        EXPECT_EQ(pixels.at(1, 0)[2], 0);
        EXPECT_EQ(diagnostics.list().size(), image.bytes.empty() ? 0u : 1u);
    }
}

TEST_F(GltfTextures, PixelsOfAllPicturesTogetherAreLimited) {
    TestModel model;
    for (int i = 0; i < 3; ++i)
        model.add("images", {{"uri", "data:image/png;base64," + base64(pngOf(10, 10))}});
    GltfLimits limits;
    limits.pixels = 250;
    const auto result = read(model.glb(), "m.glb", limits);
    ASSERT_TRUE(result);
    EXPECT_EQ(
        messages,
        "m.glb: warning: /images/2: too many pixels: 100 here, 250 in all; the picture is left "
        "out");
    EXPECT_TRUE(result->images[2].bytes.empty());
}

}  // namespace
}  // namespace vitrine
