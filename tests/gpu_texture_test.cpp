// SPDX-License-Identifier: MIT
// Textures on a plane: each pixel shows the texel that lies under it, and from afar the mean.
#include <cmath>

#include "gpu_support.hpp"
#include "mesh/primitives.hpp"

namespace vitrine {
namespace {

class TextureTest : public test::GpuTest {};

/// Eight by eight squares of random colours, far enough from black and white to be told apart.
std::shared_ptr<ImageRgba8> squares() {
    std::mt19937 random(5);
    auto image = std::make_shared<ImageRgba8>(8, 8);
    for (size_t i = 0; i < image->pixels.size(); ++i)
        image->pixels[i] = i % 4 == 3 ? 255 : static_cast<uint8_t>(40 + random() % 180);
    return image;
}

/// The texture seen from straight above, on a plane of 2 x 2 m; up in the picture is -z.
LoadedScene lookDown(const std::shared_ptr<ImageRgba8>& image, float height,
                     const glm::mat3& place) {
    test::TestScene made;
    Material material;
    material.baseColor.rgb = glm::vec3(1);
    material.baseColorTexture.image = image;
    material.baseColorTexture.pictureFromMesh = place;
    const int plane = made.addMesh(makePlane(1, 1));
    made.add(plane, made.addMaterial(material));
    Camera camera;
    camera.eye = {0, height, 0};
    camera.target = {0, 0, 0};
    camera.up = {0, 0, -1};
    camera.fov = glm::degrees(2 * std::atan(1 / height));
    made.scene.cameras = {camera};
    return made.load();
}

ImageRgba8 albedo(const LoadedScene& loaded, int size) {
    PictureRequest request;
    request.width = request.height = size;
    request.samples = 1;
    request.view = View::kAlbedo;
    return test::drawPicture(loaded, Backend::kFragment, request);
}

}  // namespace

TEST_F(TextureTest, EachTexelIsWhereItBelongs) {
    const auto image = squares();
    // The middle of a texel, magnified 16 times, where bilinear filtering gives the texel itself.
    const ImageRgba8 picture = albedo(lookDown(image, 2, glm::mat3(1)), 136);
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x)
            for (size_t c = 0; c < 3; ++c)
                EXPECT_NEAR(picture.at(17 * x + 8, 17 * y + 8)[c], image->at(x, y)[c], 2)
                    << x << ' ' << y;
}

TEST_F(TextureTest, CoordinatesAreTransformedAndRepeat) {
    const auto image = squares();
    // Twice as dense, shifted by a quarter to the right: u' = 2u + 0.25.
    const glm::mat3 place{{2, 0, 0}, {0, 2, 0}, {0.25f, 0, 1}};
    const ImageRgba8 picture = albedo(lookDown(image, 2, place), 272);
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x)
            EXPECT_NEAR(picture.at(17 * x + 8, 17 * y + 8)[0], image->at((x + 2) % 8, y % 8)[0], 2)
                << x << ' ' << y;
}

TEST_F(TextureTest, FarAwayIsTheMean) {
    const auto image = squares();
    double mean = 0;
    for (int i = 0; i < 64; ++i)
        mean += test::linearFromSrgb(image->pixels[static_cast<size_t>(4 * i)]) / 64;
    // A pixel as wide as the whole picture.
    const ImageRgba8 picture = albedo(lookDown(image, 2, glm::mat3(1)), 1);
    EXPECT_NEAR(test::linearFromSrgb(picture.at(0, 0)[0]), mean, 0.01);
}

}  // namespace vitrine
