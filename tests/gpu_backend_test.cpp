// SPDX-License-Identifier: MIT
// Fragment against compute, and a second run against the first.
//
// Records: equal to the bit, because both back ends run the same text through the same compiler;
// drivers that fuse multiply-adds differently in the two stages may differ at edges, hence at most
// one ray in a thousand. Pictures: fewer than 0.1 % of the pixels off by more than 5 of 255 (the
// bound of Filament's image tests, see image/compare.hpp). Two runs: the same bytes.
#include "bvh/test_meshes.hpp"
#include "gpu_support.hpp"
#include "image/compare.hpp"

namespace vitrine {
namespace {

using test::Random;

class BackendTest : public test::GpuTest {};

LoadedScene lesson(const std::string& name) {
    Diagnostics diagnostics;
    LoadedScene loaded = loadAll("scenes/" + name + ".toml", {}, diagnostics);
    diagnostics.throwIfErrors();
    return loaded;
}

std::vector<QueryRay> raysAround(const Aabb& box, uint32_t seed) {
    Random random(seed);
    std::vector<QueryRay> rays;
    for (int i = 0; i < 20000; ++i) {
        const Ray ray = test::ray(random, 3);
        rays.push_back({box.centre() + glm::vec3(0, 0.5f, 0) + ray.origin, 1e-3f,
                        glm::normalize(ray.direction)});
    }
    return rays;
}

class LessonTest : public BackendTest, public ::testing::WithParamInterface<const char*> {};

TEST_P(LessonTest, RecordsAreEqual) {
    const LoadedScene loaded = lesson(GetParam());
    const uint32_t seed = test::seedOr(701);
    const auto rays = raysAround(loaded.packed.worldBox, seed);
    RayQuery fragment(context(), loaded.packed, Backend::kFragment);
    RayQuery compute(context(), loaded.packed, Backend::kCompute);
    const auto a = fragment.closest(rays), b = compute.closest(rays);
    const auto anyA = fragment.any(rays), anyB = compute.any(rays);
    const auto again = fragment.closest(rays);
    int different = 0, differentAny = 0, hits = 0;
    for (size_t i = 0; i < rays.size(); ++i) {
        different += a[i] != b[i];
        differentAny += record::isSurface(anyA[i]) != record::isSurface(anyB[i]);
        hits += record::isSurface(a[i]);
        ASSERT_EQ(a[i], again[i]) << "a second run differs, seed " << seed;
    }
    RecordProperty("different_records", different);
    EXPECT_LE(different, static_cast<int>(rays.size()) / 1000) << "seed " << seed;
    EXPECT_LE(differentAny, static_cast<int>(rays.size()) / 1000) << "seed " << seed;
    EXPECT_GT(hits, 2000);
}

TEST_P(LessonTest, PicturesAreEqual) {
    const LoadedScene loaded = lesson(GetParam());
    PictureRequest request;
    request.width = 240;
    request.height = 150;
    request.samples = 2;
    const ImageRgba8 fragment = test::drawPicture(loaded, Backend::kFragment, request);
    const ImageRgba8 compute = test::drawPicture(loaded, Backend::kCompute, request);
    const Comparison comparison = compareImages(fragment, compute);
    RecordProperty("fraction_over", std::to_string(comparison.fractionOver));
    RecordProperty("largest_difference", std::to_string(comparison.maxDifference));
    EXPECT_LT(comparison.fractionOver, 0.001);
    EXPECT_TRUE(test::drawPicture(loaded, Backend::kFragment, request) == fragment)
        << "a second run gives other bytes";
    EXPECT_TRUE(test::drawPicture(loaded, Backend::kCompute, request) == compute)
        << "a second run gives other bytes";
}

TEST_P(LessonTest, OneRendererDrawsTheSameTwice) {
    const LoadedScene loaded = lesson(GetParam());
    PictureRequest request;
    request.width = 120;
    request.height = 75;
    request.samples = 2;
    Renderer renderer(loaded, Backend::kAuto, false);
    const ImageRgba8 first = renderer.draw(request, nullptr);
    request.time = 0.5f;
    request.width = 64;
    (void)renderer.draw(request, nullptr);
    request.time = 0;
    request.width = 120;
    EXPECT_TRUE(renderer.draw(request, nullptr) == first);
}

std::string withoutDash(const ::testing::TestParamInfo<const char*>& parameter) {
    std::string name = parameter.param;
    name.erase(name.find('-'), 1);
    return name;
}

INSTANTIATE_TEST_SUITE_P(Scenes, LessonTest,
                         ::testing::Values("lesson-march", "lesson-trace", "lesson-both"),
                         withoutDash);

}  // namespace
}  // namespace vitrine
