// SPDX-License-Identifier: MIT
// For the tests that draw: a GL context, scenes made by code, rays through the shaders' tracer.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "app/session/session.hpp"
#include "bvh/triangle.hpp"
#include "frame/pass_query.hpp"
#include "mesh/mesh.hpp"
#include "pack/hit_record.hpp"

namespace vitrine::test {

/// `standard`, or the number in the environment variable VITRINE_TEST_SEED.
uint32_t seedOr(uint32_t standard);

inline constexpr std::array kBackends{Backend::kFragment, Backend::kCompute};
std::string nameOf(Backend backend);

/// Skips where no GL context can be made, unless VITRINE_REQUIRE_GL is set: then that is a failure.
class GpuTest : public ::testing::Test {
  protected:
    void SetUp() override;
    [[nodiscard]] const Context& context() const { return *context_; }

  private:
    std::unique_ptr<Context> context_;
};

/// A scene made by code, so that tests need no files. Black surroundings, no lights, no ambient
/// occlusion, no tone map: what is seen is what the test puts there.
class TestScene {
  public:
    TestScene();

    /// Each returns the number of the shape. Trees are built after scene.bvh.
    int addMesh(vitrine::Mesh mesh);
    int addMesh(const std::vector<glm::vec3>& positions, const std::vector<glm::uvec3>& triangles);
    int addField(const std::string& snippet);
    /// The field as it is after measuring.
    int addField(std::shared_ptr<const Snippet> field);
    /// `snippet`: text of a .mat.glsl file, or nothing.
    int addMaterial(const Material& material, const std::string& snippet = "");
    /// The node becomes instance number nodes - 1 of the records. `material` -1: the default.
    Node& add(int shape, int material = -1);
    void addSun(const glm::vec3& direction, float intensity);
    void setEnvironment(float radiance);
    /// A picture of all directions (pack/sky_map.hpp).
    void setSky(const ImageRgba32f& picture);

    /// Throws InputError, with the messages, if something is wrong with the scene.
    [[nodiscard]] LoadedScene load() const;
    [[nodiscard]] PackedScene pack() const { return load().packed; }

    Scene scene;

  private:
    Assets assets_;
};

/// Mesh, field, mirror and, if asked for, glass, which follows two sets of paths.
LoadedScene mixedScene(bool glass);

/// `count` points on the unit sphere, evenly distributed and at random.
std::vector<glm::vec3> randomDirections(std::mt19937& random, int count);
float uniform(std::mt19937& random, float low, float high);
/// Two unit vectors that make a frame with unit n.
std::array<glm::vec3, 2> frameOf(const glm::vec3& n);

/// A picture, in 8 bits, on one back end. Makes and drops a context of its own.
ImageRgba8 drawPicture(const LoadedScene& loaded, Backend backend, const PictureRequest& request);

/// Undoes the sRGB curve: 0..255 to linear 0..1.
double linearFromSrgb(double value);
/// The ray through the centre of a pixel; (0, 0) is the top left one, as in the picture.
Ray pixelRay(const Camera& camera, int width, int height, int x, int y);

}  // namespace vitrine::test
