// SPDX-License-Identifier: MIT
// --view bvh=N against projections worked out here: lines are where the boxes' edges are, dimmer
// behind a surface, equally wide near and far, and the picture below is dimmed.
#include "gpu_support.hpp"
#include "mesh/primitives.hpp"
#include "pack/camera.hpp"

namespace vitrine {
namespace {

constexpr int kWidth = 160, kHeight = 120;

class BoxesTest : public test::GpuTest {};

/// A dark cube, turned.
struct Stage {
    test::TestScene scene;
    Stage() {
        Material dark;
        dark.baseColor.rgb = glm::vec3(0.1f);
        const int material = scene.addMaterial(dark);
        scene.scene.cameras[0].eye = {0, 0, 6};
        scene.scene.cameras[0].target = {0, 0, 0};
        const int cube = scene.addMesh(makeBox(glm::vec3(1)));
        scene.add(cube, material).rotate = {20, 30, 0};
        scene.setEnvironment(0.2f);
    }
};

float luminance(const ImageRgba8& image, glm::ivec2 p) {
    const size_t i = (static_cast<size_t>(p.y) * kWidth + static_cast<size_t>(p.x)) * 4;
    return 0.3f * image.pixels[i] + 0.6f * image.pixels[i + 1] + 0.1f * image.pixels[i + 2];
}

/// Pixel (top row first) of a point of the world, and its depth.
glm::vec3 project(const Camera& camera, const glm::vec3& world) {
    FrameBlock block{};
    packCamera(camera, kWidth, kHeight, block);
    const glm::vec4 p = packProjection(block) * glm::vec4(world, 1);
    return {(0.5f + 0.5f * p.x / p.w) * kWidth, (0.5f - 0.5f * p.y / p.w) * kHeight, p.w};
}

ImageRgba8 draw(const LoadedScene& loaded, Backend backend, View view, int level,
                Primary primary = Primary::kRaster) {
    PictureRequest request;
    request.width = kWidth;
    request.height = kHeight;
    request.view = view;
    request.treeLevel = level;
    request.primary = primary;
    return test::drawPicture(loaded, backend, request);
}

TEST_F(BoxesTest, EdgesAreWhereTheyBelongAndFainterBehindSurfaces) {
    const Stage stage;
    const LoadedScene loaded = stage.scene.load();
    const PackedInstance& instance = loaded.packed.instances[0];
    for (const Backend backend : test::kBackends) {
        for (const Primary primary : {Primary::kRaster, Primary::kTrace}) {
            SCOPED_TRACE(test::nameOf(backend));
            const ImageRgba8 plain = draw(loaded, backend, View::kColor, 0, primary);
            const ImageRgba8 boxes = draw(loaded, backend, View::kBvh, 0, primary);
            double front = 0, behind = 0, elsewhere = 0;
            int fronts = 0, behinds = 0;
            // The cube is its own box: the corner farthest from the eye and its edges are hidden.
            float farthest = 0;
            int hidden = 0;
            std::array<glm::vec3, 8> corners;
            for (int i = 0; i < 8; ++i) {
                const glm::vec3 p((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1,
                                  (i & 4) != 0 ? 1 : -1);
                corners[static_cast<size_t>(i)] = p;
                const float depth = project(stage.scene.scene.cameras[0],
                                            glm::vec3(instance.worldFromObject * glm::vec4(p, 1)))
                                        .z;
                if (depth > farthest) {
                    farthest = depth;
                    hidden = i;
                }
            }
            for (int i = 0; i < 8; ++i)
                for (int axis = 0; axis < 3; ++axis) {
                    const int j = i | (1 << axis);
                    if (j == i) continue;
                    const bool isHidden = i == hidden || j == hidden;
                    for (int step = 2; step < 19; ++step) {
                        const glm::vec3 p =
                            glm::mix(corners[static_cast<size_t>(i)],
                                     corners[static_cast<size_t>(j)], float(step) / 20);
                        const glm::vec3 at =
                            project(stage.scene.scene.cameras[0],
                                    glm::vec3(instance.worldFromObject * glm::vec4(p, 1)));
                        const glm::ivec2 pixel(int(at.x), int(at.y));
                        (isHidden ? behind : front) += luminance(boxes, pixel);
                        ++(isHidden ? behinds : fronts);
                    }
                }
            const glm::ivec2 middle(kWidth / 2 + 7, kHeight / 2 + 3), corner(3, 3);
            elsewhere = luminance(boxes, corner);
            EXPECT_LT(elsewhere, 0.75 * luminance(plain, corner)) << "the picture is dimmed";
            EXPECT_NE(luminance(boxes, middle), luminance(plain, middle));
            front /= fronts;
            behind /= behinds;
            EXPECT_GT(front, 1.4 * luminance(boxes, middle)) << "in front";
            EXPECT_LT(behind, 0.85 * front) << "behind";
        }
    }
}

TEST_F(BoxesTest, BackEndsAndFindersAgree) {
    Stage stage;
    stage.scene
        .add(stage.scene.addField("// bounds[-0.6, -0.6, -0.6, 0.6, 0.6, 0.6]\n"
                                  "float sdf(vec3 p) { return length(p) - 0.5; }"))
        .at = {1.2f, 0.6f, 1};
    stage.scene.add(stage.scene.addMesh(makeSphere(0.8f))).at = {-1.4f, 0, 1};
    const LoadedScene loaded = stage.scene.load();
    for (const int level : {0, 3, 63}) {
        const ImageRgba8 one = draw(loaded, Backend::kFragment, View::kBvh, level);
        const ImageRgba8 other =
            draw(loaded, Backend::kCompute, View::kBvh, level, Primary::kTrace);
        int differ = 0;
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x)
                differ += std::abs(luminance(one, {x, y}) - luminance(other, {x, y})) > 12;
        // Pixels on silhouettes, where the rasteriser and the tracer may see different triangles.
        EXPECT_LT(differ, kWidth * kHeight / 50) << "level " << level;
    }
}

TEST_F(BoxesTest, FromInsideABoxNothingBreaks) {
    Stage stage;
    stage.scene.scene.cameras[0].eye = {0.1f, 0.2f, 0.3f};
    stage.scene.scene.cameras[0].target = {1, 0.2f, -0.3f};
    const LoadedScene loaded = stage.scene.load();
    const ImageRgba8 picture = draw(loaded, Backend::kFragment, View::kBvh, 0);
    // Edges that pass the eye are cut there and do not smear over the picture.
    double sum = 0;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) sum += luminance(picture, {x, y}) > 150;
    EXPECT_LT(sum, 0.2 * kWidth * kHeight);
}

}  // namespace
}  // namespace vitrine
