// SPDX-License-Identifier: MIT
// A sketch: fields are seen, but by no light and in no mirror, and none of its long programs
// changes when a field does.
#include "frame/programs.hpp"
#include "gpu_support.hpp"
#include "mesh/primitives.hpp"

namespace vitrine {
namespace {

class SketchTest : public test::GpuTest {};

constexpr int kSide = 64;

/// A field above a plane on the left, a mesh on the right, the sun above both; seen from the front
/// and above.
LoadedScene things(float radius) {
    test::TestScene made;
    const int ball =
        made.addField(fmt::format("// bounds[-1, -1, -1,  1, 1, 1]\n"
                                  "float sdf(vec3 p) {{ return length(p) - {:.6f}; }}\n",
                                  radius));
    made.add(made.addMesh(makePlane(20, 20)));
    made.add(ball).at = {-1.5f, 1.5f, 0};
    made.add(made.addMesh(makeTorus(0.3f, 0.25f, 24, 12))).at = {1.5f, 1.5f, 0};
    made.addSun({0, -1, 0}, 2);
    made.setEnvironment(0.2f);
    return made.load();
}

FrameRequest request() {
    FrameRequest r;
    r.width = r.height = kSide;
    r.camera.eye = {0, 3, 7};
    r.camera.target = {0, 0.75f, 0};
    r.camera.fov = 45;
    r.bounces = 1;
    return r;
}

/// How light the place of the scene is in the picture, 0 to 255.
int brightness(const ImageRgba8& picture, const glm::vec3& place) {
    const Camera camera = request().camera;
    const glm::vec3 forward = glm::normalize(camera.target - camera.eye);
    const glm::vec3 right = glm::normalize(glm::cross(forward, camera.up));
    const glm::vec3 up = glm::cross(right, forward), way = place - camera.eye;
    const float scale = 0.5f / std::tan(glm::radians(45.0f) / 2) / glm::dot(way, forward);
    const auto at = [](float share) { return static_cast<int>(share * kSide); };
    const int x = at(0.5f + scale * glm::dot(way, right)), y = at(0.5f - scale * glm::dot(way, up));
    return picture.pixels[static_cast<size_t>((y * kSide + x) * ImageRgba8::kChannels + 1)];
}

TEST_F(SketchTest, ShowsFieldsThatNoLightSees) {
    const LoadedScene loaded = things(0.55f);
    for (const Backend backend : test::kBackends) {
        SCOPED_TRACE(test::nameOf(backend));
        const auto draw = [&](bool sketch) {
            Frame frame(context(), loaded.packed, backend, false, FrameOptions{nullptr, sketch});
            frame.begin(request());
            frame.drawSample();
            return frame.picture();
        };
        const ImageRgba8 whole = draw(false), sketch = draw(true);
        const glm::vec3 topOfBall{-1.5f, 2, 0.2f}, shadowOfBall{-1.5f, 0, 0}, free{0, 0, 1};
        const glm::vec3 topOfRing{1.8f, 1.7f, 0}, shadowOfRing{1.8f, 0, 0};
        // Black where the field would be missing, as the surroundings are behind it.
        EXPECT_GT(brightness(whole, topOfBall), 150);
        EXPECT_NEAR(brightness(sketch, topOfBall), brightness(whole, topOfBall), 3);
        EXPECT_NEAR(brightness(sketch, topOfRing), brightness(whole, topOfRing), 3);
        EXPECT_LT(brightness(whole, shadowOfBall), brightness(whole, free) - 60);
        EXPECT_NEAR(brightness(sketch, shadowOfBall), brightness(sketch, free), 3);
        EXPECT_LT(brightness(sketch, shadowOfRing), brightness(sketch, free) - 60);
        EXPECT_NEAR(brightness(sketch, shadowOfRing), brightness(whole, shadowOfRing), 3);
    }
}

TEST_F(SketchTest, HasLongProgramsWithoutFields) {
    const LoadedScene one = things(0.55f), other = things(0.45f);
    const auto text = [](const LoadedScene& loaded, const std::string& pass, bool sketch) {
        const ProgramFeatures features = featuresOf(loaded.packed, false, sketch);
        return assembleShader(shaderKey(pass, features, ShaderStage::kFragment, Dialect::kGl450),
                              includesOf(pass, features, loaded.packed.shaders))
            .text;
    };
    for (const char* pass : {"light", "bounce"}) {
        SCOPED_TRACE(pass);
        EXPECT_EQ(text(one, pass, true), text(other, pass, true));
        EXPECT_NE(text(one, pass, false), text(other, pass, false));
    }
    EXPECT_NE(text(one, "march", true), text(other, "march", true));
    EXPECT_EQ(text(one, "march", true), text(one, "march", false));
}

}  // namespace
}  // namespace vitrine
