// SPDX-License-Identifier: MIT
#include "pack/hit_record.hpp"

#include <gtest/gtest.h>

#include <random>

namespace vitrine {
namespace {

using glm::uvec4;
using glm::vec2;
using glm::vec3;

double degreesBetween(const vec3& a, const vec3& b) {
    // The chord keeps its precision where the cosine does not.
    const double chord = glm::length(glm::dvec3(a) - glm::dvec3(b));
    return glm::degrees(2 * std::asin(chord / 2));
}

TEST(HitRecord, KeepsItsWords) {
    const uvec4 r = record::packHit(17, 123456, 0xdeadbeef, 0.1f);
    EXPECT_EQ(r.x, 17u);
    EXPECT_EQ(r.y, 123456u);
    EXPECT_EQ(r.z, 0xdeadbeefu);
    for (const float t : {0.0f, 1e-30f, 0.1f, 1e30f})
        EXPECT_EQ(record::recordDistance(record::packHit(0, 0, 0, t)), t);
}

TEST(HitRecord, TellsSurfacesFromMisses) {
    EXPECT_TRUE(record::isSurface(record::packHit(0, 0, 0, 1)));
    EXPECT_TRUE(record::isSurface(record::packHit(VITRINE_RECORD_MISS - 1, 0, 0, 1)));
    EXPECT_FALSE(record::isSurface(record::missRecord()));
    EXPECT_FALSE(record::isSurface(record::noRecord()));
    EXPECT_NE(record::missRecord().x, record::noRecord().x);
}

TEST(HitRecord, Barycentrics) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> unit(0, 1);
    for (int i = 0; i < 10000; ++i) {
        const float u = unit(random), v = (1 - u) * unit(random);
        const vec2 back = record::unpackBarycentrics(record::packBarycentrics({u, v}));
        EXPECT_NEAR(back.x, u, 0.51f / 65535);
        EXPECT_NEAR(back.y, v, 0.51f / 65535);
    }
    for (const vec2 corner : {vec2(0, 0), vec2(1, 0), vec2(0, 1)})
        EXPECT_EQ(record::unpackBarycentrics(record::packBarycentrics(corner)), corner);
}

TEST(HitRecord, NormalsAreGoodToAThousandthOfADegreeOrSo) {
    std::mt19937 random(2);
    std::normal_distribution<float> normal;
    double worst = 0;
    const auto check = [&](const vec3& n) {
        const vec3 back = record::unpackNormal(record::packNormal(n));
        ASSERT_NEAR(glm::length(back), 1, 1e-6f);
        worst = std::max(worst, degreesBetween(n, back));
    };
    for (int i = 0; i < 300000; ++i)
        check(glm::normalize(vec3(normal(random), normal(random), normal(random))));
    // The folds of the octahedron: its edges and what is close to them.
    for (int i = 0; i < 100000; ++i) {
        vec3 n(normal(random), normal(random), normal(random));
        n[i % 3] *= i % 2 == 0 ? 0.0f : 1e-5f;
        check(glm::normalize(n));
    }
    EXPECT_LT(worst, 0.005);
    EXPECT_GT(worst, 0.0005) << "16 bits cannot be that good: the test measures nothing";
}

TEST(HitRecord, AxesAreExact) {
    for (int axis = 0; axis < 3; ++axis)
        for (const float sign : {-1.0f, 1.0f}) {
            vec3 n(0);
            n[axis] = sign;
            EXPECT_EQ(record::unpackNormal(record::packNormal(n)), n) << axis << " " << sign;
            n[(axis + 1) % 3] = -0.0f;
            EXPECT_LT(degreesBetween(record::unpackNormal(record::packNormal(n)), n), 1e-6);
        }
}

}  // namespace
}  // namespace vitrine
