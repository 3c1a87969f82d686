// SPDX-License-Identifier: MIT
// The library of distance functions on the GPU, in single precision and through the whole renderer,
// against the same functions marched in double precision on the CPU: every picture of docs/sdf.md,
// by rays. A dozen stand in one program, so that what they share is there once.
//
// Rays that graze a surface may end on either side of it: one in fifty may differ.
#include "gpu_support.hpp"
#include "sdf/library_in_cpp.hpp"
#include "sdf_pages.hpp"

namespace vitrine {
namespace {

constexpr int kFieldsPerScene = 12;
constexpr int kRaysPerField = 256;
constexpr float kApart = 8;
constexpr double kTolerance = 2e-3;

class LibraryOnTheGpu : public test::GpuTest {};

/// The first example of a function, extruded and cut as for its picture.
double value(const Example& example, const glm::dvec3& p) {
    const bool flat = example.function.compare(0, 3, "sd2") == 0;
    const double d = example.value(p);
    return std::max(flat ? library::opExtrude(d, p.z, 0.12) : d,
                    library::sdBox(p, glm::dvec3(1.19)));
}

/// The way from `origin` to the surface, or 0 if the ray misses.
double marched(const Example& example, const glm::dvec3& origin, const glm::dvec3& direction) {
    double t = 0;
    for (int i = 0; i < 20000 && t < 8; ++i) {
        const double d = value(example, origin + t * direction);
        if (d < 1e-6) return t;
        t += d / 1.42;  // no example is steeper
    }
    return 0;
}

TEST_F(LibraryOnTheGpu, LooksAsItDoesInDoublePrecision) {
    std::vector<const Example*> firsts;
    for (const Example& example : library::kExamples)
        if (firsts.empty() || firsts.back()->function != example.function)
            firsts.push_back(&example);
    const auto& functions = sdfLibrary().functions();
    ASSERT_EQ(firsts.size(), static_cast<size_t>(std::count_if(
                                 functions.begin(), functions.end(),
                                 [](const LibraryFunction& f) { return !f.examples.empty(); })));

    std::mt19937 random(test::seedOr(501));
    for (size_t first = 0; first < firsts.size(); first += kFieldsPerScene) {
        const size_t count = std::min<size_t>(kFieldsPerScene, firsts.size() - first);
        test::TestScene scene;
        scene.scene.render.marchSteps = 1024;
        std::vector<QueryRay> rays;
        for (size_t i = 0; i < count; ++i) {
            const LibraryFunction& f = *sdfLibrary().find(firsts[first + i]->function);
            const glm::vec3 at(kApart * static_cast<float>(i), 0, 0);
            scene.add(scene.addField(sdfPictureField(f))).at = at;
            for (const glm::vec3& out : test::randomDirections(random, kRaysPerField)) {
                const glm::vec3 aim(test::uniform(random, -0.9f, 0.9f),
                                    test::uniform(random, -0.9f, 0.9f),
                                    test::uniform(random, -0.9f, 0.9f));
                rays.push_back({at + 2.5f * out, 0, glm::normalize(aim - 2.5f * out)});
            }
        }
        RayQuery query(context(), scene.pack(), Backend::kFragment);
        const std::vector<glm::uvec4> records = query.closest(rays);
        for (size_t i = 0; i < count; ++i) {
            const Example& example = *firsts[first + i];
            const glm::dvec3 at(kApart * static_cast<double>(i), 0, 0);
            int different = 0, hits = 0;
            for (size_t r = i * kRaysPerField; r < (i + 1) * kRaysPerField; ++r) {
                const double truth =
                    marched(example, glm::dvec3(rays[r].origin) - at, rays[r].direction);
                const bool hit =
                    record::isSurface(records[r]) && record::recordDistance(records[r]) < 5;
                hits += truth > 0 ? 1 : 0;
                const double found = hit ? record::recordDistance(records[r]) : 0;
                different += std::abs(found - truth) > kTolerance ? 1 : 0;
            }
            EXPECT_LE(different, kRaysPerField / 50) << example.text;
            EXPECT_GT(hits, 5) << example.text;
        }
    }
}

}  // namespace
}  // namespace vitrine
