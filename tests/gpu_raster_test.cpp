// SPDX-License-Identifier: MIT
// The `raster` finder against the `trace` finder: the same picture, whoever finds the first hits.
//
// Fewer than 0.1 % of the pixels may be off by more than 5 of 255. They are pixels whose centre
// lies within the rasteriser's 1/256 of an edge. A picture shifted by a tenth of a pixel fails
// (below).
#include <cstdlib>
#include <filesystem>

#include "gpu_support.hpp"
#include "image/compare.hpp"
#include "mesh/primitives.hpp"

namespace vitrine {
namespace {

class RasterTest : public test::GpuTest {};

constexpr double kMostPixels = 0.001;

PictureRequest request(Primary primary) {
    PictureRequest r;
    r.width = 320;
    r.height = 200;
    r.samples = 1;
    r.primary = primary;
    return r;
}

double differing(const LoadedScene& loaded, const LoadedScene& other) {
    const ImageRgba8 raster =
        test::drawPicture(loaded, Backend::kFragment, request(Primary::kRaster));
    const ImageRgba8 trace = test::drawPicture(other, Backend::kFragment, request(Primary::kTrace));
    return compareImages(raster, trace).fractionOver;
}

LoadedScene load(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
    Diagnostics diagnostics;
    LoadedScene loaded = loadAll(file, overrides, diagnostics);
    diagnostics.throwIfErrors();
    return loaded;
}

LoadedScene lesson(const std::string& name, const std::vector<std::string>& overrides) {
    return load("scenes/" + name + ".toml", overrides);
}

}  // namespace

TEST_F(RasterTest, ScenesLookTheSame) {
    for (const char* name : {"lesson-trace", "lesson-both", "lesson-march", "tank"})
        for (const char* ssaa : {"render.ssaa=1", "render.ssaa=2"}) {
            const LoadedScene loaded = lesson(name, {ssaa});
            EXPECT_LT(differing(loaded, loaded), kMostPixels) << name << ' ' << ssaa;
        }
}

/// Models that people made, if the environment variable VITRINE_TEST_DATA names a folder with them.
TEST_F(RasterTest, RealModelsLookTheSame) {
    const char* data = std::getenv("VITRINE_TEST_DATA");
    if (data == nullptr) GTEST_SKIP() << "VITRINE_TEST_DATA is not set";
    for (const char* name : {"FlightHelmet/FlightHelmet.gltf", "ToyCar/ToyCar.glb"}) {
        const std::filesystem::path file = std::filesystem::path(data) / name;
        if (!std::filesystem::exists(file)) continue;
        const LoadedScene loaded = load(file, {"render.ao=0", "render.bounces=1"});
        EXPECT_LT(differing(loaded, loaded), kMostPixels) << name;
    }
}

TEST_F(RasterTest, AMovingTankLooksTheSame) {
    const LoadedScene loaded = lesson("tank", {});
    for (const float time : {1.9f, 6.4f, 10.3f}) {
        PictureRequest raster = request(Primary::kRaster), trace = request(Primary::kTrace);
        raster.time = trace.time = time;
        const ImageRgba8 picture = test::drawPicture(loaded, Backend::kFragment, raster);
        EXPECT_LT(compareImages(picture, test::drawPicture(loaded, Backend::kFragment, trace))
                      .fractionOver,
                  kMostPixels)
            << time;
        trace.time += 0.1f;
        EXPECT_GT(compareImages(picture, test::drawPicture(loaded, Backend::kFragment, trace))
                      .fractionOver,
                  kMostPixels)
            << "the turret stands still at " << time;
    }
}

TEST_F(RasterTest, AShiftOfATenthOfAPixelIsNoticed) {
    const LoadedScene loaded = lesson("lesson-trace", {});
    LoadedScene shifted = loaded;
    Camera& camera = shifted.scene.cameras[0];
    const glm::vec3 forward = camera.target - camera.eye;
    const glm::vec3 right = glm::normalize(glm::cross(forward, camera.up));
    const float pixel = glm::length(forward) * 36 / camera.focalLength / 320;
    camera.target += 0.1f * pixel * right;
    EXPECT_GT(differing(loaded, shifted), kMostPixels);
}

TEST_F(RasterTest, MirroredAndSqueezedInstancesAndAnEyeInsideAMesh) {
    test::TestScene made;
    const int torus = made.addMesh(makeTorus(0.5f, 0.2f, 48, 24));
    const int room = made.addMesh(makeBox(glm::vec3(4)));
    const int ball = made.addField(
        "// bounds[-0.5, -0.5, -0.5, 0.5, 0.5, 0.5]\nfloat sdf(vec3 p) { return length(p) - 0.45; "
        "}\n");
    Material matt;
    matt.roughness = 1;
    const int material = made.addMaterial(matt);
    made.add(room, material);
    Node& mirrored = made.add(torus, material);
    mirrored.scale = {-1, 1, 1};
    mirrored.rotate = {20, 30, 40};
    Node& squeezed = made.add(torus, material);
    squeezed.scale = {0.4f, 1.7f, 0.9f};
    squeezed.at = {1.2f, 0.2f, 0};
    made.add(ball, material).at = {0.4f, 0.1f, 0.1f};
    made.setEnvironment(0.2f);
    made.scene.render.ao = 0;
    Light lamp;
    lamp.type = LightType::kPoint;
    lamp.at = {1, 3, 3};
    lamp.intensity = 12;
    made.scene.lights.push_back(lamp);
    Camera camera;
    camera.eye = {1, 1.2f, 3};
    camera.target = {0.3f, 0, 0};
    camera.fov = 50;
    made.scene.cameras = {camera};
    const LoadedScene loaded = made.load();
    EXPECT_LT(differing(loaded, loaded), kMostPixels);
}

// Where the backs of a solid are left out, none may be missing: from inside, through a hole, turned
// inside out, mirrored, and through holes in a material.
TEST_F(RasterTest, BacksAreSeenWhereTheyAreSeen) {
    Mesh open = makeBox(glm::vec3(0.5f)), reversed = makeBox(glm::vec3(0.5f));
    open.triangles.erase(open.triangles.begin());
    Mesh tube = makeBox(glm::vec3(0.5f));
    std::erase_if(tube.triangles,
                  [&](const glm::uvec3& t) { return std::abs(tube.normals[t.x].z) > 0.5f; });
    for (glm::uvec3& t : reversed.triangles) std::swap(t.y, t.z);
    const Mesh solid = makeBox(glm::vec3(0.5f));
    struct Case {
        const char* name;
        const Mesh& mesh;
        glm::vec3 scale, eye;
    };
    const glm::vec3 one(1), mirror(-1, 1, 1), far(2, 1.5f, 2.5f);
    const glm::vec3 hole = 4.0f * open.normals[makeBox(glm::vec3(0.5f)).triangles[0].x];
    const Case cases[] = {{"outside", solid, one, far},
                          {"mirrored", solid, mirror, far},
                          {"inside", solid, one, {0.1f, 0.2f, 0.3f}},
                          {"inside out", reversed, one, far},
                          {"inside out and mirrored", reversed, mirror, far},
                          {"into the hole", open, one, 0.6f * hole + glm::vec3(0.2f, 0.3f, 0.1f)},
                          {"into the mirrored hole", open, mirror,
                           glm::vec3(-1, 1, 1) * (0.6f * hole + glm::vec3(0.2f, 0.3f, 0.1f))},
                          {"against the hole", open, one, -hole + glm::vec3(0.2f, 0.3f, 0.1f)},
                          {"into one end", tube, one, {0.9f, 0.7f, 1.7f}},
                          {"into the other end", tube, one, {0.9f, 0.7f, -1.7f}},
                          {"across the tube", tube, one, {1.7f, 0.9f, 0.3f}}};
    for (const bool veiled : {false, true})
        for (const Case& c : cases) {
            test::TestScene made;
            Material material;
            material.roughness = 1;
            if (veiled) {
                material.alphaMode = AlphaMode::kBlend;
                material.opacity = 0.5f;
            }
            made.add(made.addMesh(c.mesh), made.addMaterial(material)).scale = c.scale;
            made.setEnvironment(0.2f);
            made.addSun({-0.5f, -0.7f, -0.3f}, 2);
            Camera camera;
            camera.eye = c.eye;
            camera.target = {-0.05f, 0.02f, 0.03f};
            camera.fov = 60;
            made.scene.cameras = {camera};
            const LoadedScene loaded = made.load();
            EXPECT_LT(differing(loaded, loaded), kMostPixels)
                << c.name << (veiled ? ", veiled" : "");
        }
}

}  // namespace vitrine
