// SPDX-License-Identifier: MIT
#include "scene/animation.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace vitrine {
namespace {

/// 10 at 1 s, 20 at 3 s, 0 at 4 s.
AnimationTrack track(LoopMode loop = LoopMode::kNone, Ease ease = Ease::kLinear) {
    AnimationTrack t;
    t.target.key = "exposure";
    t.times = {1, 3, 4};
    t.values = {{10, 1, 0, 0}, {20, 2, 0, 0}, {0, 3, 0, 0}};
    t.loop = loop;
    t.ease = ease;
    t.loopStart = 1;
    t.loopEnd = 4;
    return t;
}

float at(const AnimationTrack& t, double time) {
    return sampleTrack(t, time).x;
}

TEST(Animation, GoesStraightFromKeyToKeyAndStaysAtTheEnds) {
    const AnimationTrack t = track();
    EXPECT_FLOAT_EQ(at(t, -5), 10);
    EXPECT_FLOAT_EQ(at(t, 1), 10);
    EXPECT_FLOAT_EQ(at(t, 1.5), 12.5);
    EXPECT_FLOAT_EQ(at(t, 3), 20);
    EXPECT_FLOAT_EQ(at(t, 3.25), 15);
    EXPECT_FLOAT_EQ(at(t, 4), 0);
    EXPECT_FLOAT_EQ(at(t, 100), 0);
    EXPECT_FLOAT_EQ(sampleTrack(t, 2).y, 1.5f);
}

TEST(Animation, OneKeyHoldsForEver) {
    AnimationTrack t = track();
    t.times = {2};
    t.values = {{7, 0, 0, 0}};
    for (const double time : {0.0, 2.0, 9.0}) EXPECT_EQ(at(t, time), 7);
}

TEST(Animation, EasesHaveTheirFormulas) {
    // A quarter of the way in time, from 10 to 20.
    EXPECT_FLOAT_EQ(at(track(LoopMode::kNone, Ease::kStep), 2.999), 10);
    EXPECT_FLOAT_EQ(at(track(LoopMode::kNone, Ease::kStep), 3), 20);
    EXPECT_FLOAT_EQ(at(track(LoopMode::kNone, Ease::kSmooth), 1.5), 10 + 10 * 0.15625f);
    EXPECT_FLOAT_EQ(at(track(LoopMode::kNone, Ease::kSmoother), 1.5), 10 + 10 * 0.103515625f);
    EXPECT_FLOAT_EQ(at(track(LoopMode::kNone, Ease::kIn), 1.5), 10 + 10 * 0.015625f);
    EXPECT_FLOAT_EQ(at(track(LoopMode::kNone, Ease::kOut), 1.5), 10 + 10 * 0.578125f);
}

TEST(Animation, EasesStayBetweenTheKeysAndMeetThem) {
    for (const Ease ease :
         {Ease::kLinear, Ease::kStep, Ease::kSmooth, Ease::kSmoother, Ease::kIn, Ease::kOut}) {
        const AnimationTrack t = track(LoopMode::kNone, ease);
        float before = 10;
        for (int i = 0; i <= 100; ++i) {
            const float value = at(t, 1 + 0.02 * i);
            EXPECT_GE(value, before);
            EXPECT_LE(value, 20);
            before = value;
        }
        EXPECT_FLOAT_EQ(before, 20);
    }
    // Those that are smooth leave and arrive without a jolt: less than a tenth of the even speed.
    for (const Ease ease : {Ease::kSmooth, Ease::kSmoother}) {
        const AnimationTrack t = track(LoopMode::kNone, ease);
        EXPECT_LT(at(t, 1.02) - 10, 0.01f);
        EXPECT_LT(20 - at(t, 2.98), 0.01f);
    }
}

TEST(Animation, ARepeatedTrackComesAgain) {
    const AnimationTrack t = track(LoopMode::kRepeat);
    for (const double time : {1.0, 1.7, 2.9, 3.6, 3.99})
        for (const int round : {-2, -1, 1, 2, 1000})
            EXPECT_NEAR(at(t, time + 3 * round), at(t, time), 1e-4f) << time << ' ' << round;
    EXPECT_FLOAT_EQ(at(t, 4), 10);
    EXPECT_NEAR(at(t, 4 - 1e-6), 0, 1e-3f);
}

TEST(Animation, AMirroredTrackGoesBackAndForth) {
    const AnimationTrack t = track(LoopMode::kMirror);
    for (const double away : {0.0, 0.4, 1.9, 2.6}) {
        EXPECT_NEAR(at(t, 4 + away), at(t, 4 - away), 1e-4f);
        EXPECT_NEAR(at(t, 1 - away), at(t, 1 + away), 1e-4f);
        EXPECT_NEAR(at(t, 1 + 6 + away), at(t, 1 + away), 1e-4f);
    }
}

TEST(Animation, ALoopMayBeLongerThanTheKeys) {
    AnimationTrack t = track(LoopMode::kRepeat);
    t.loopStart = 0;
    t.loopEnd = 10;
    EXPECT_FLOAT_EQ(at(t, 0.5), 10);
    EXPECT_FLOAT_EQ(at(t, 9), 0);
    EXPECT_FLOAT_EQ(at(t, 12), 15);
}

TEST(Animation, CubicSplinesFollowTheirTangents) {
    AnimationTrack t;
    t.target.key = "at";
    t.interpolation = Interpolation::kCubicSpline;
    t.times = {1, 3};
    // p(s) = s^3 - 2 s^2 + s + 4 over s = time - 1, in the way of glTF: in-tangent, value, out.
    const auto p = [](double s) { return s * s * s - 2 * s * s + s + 4; };
    const auto slope = [](double s) { return 3 * s * s - 4 * s + 1; };
    const auto both = [](double v) { return glm::vec4(static_cast<float>(v)); };
    t.values = {both(99), both(p(0)), both(slope(0)), both(slope(2)), both(p(2)), both(99)};
    for (const double s : {0.0, 0.3, 1.0, 1.7, 2.0}) EXPECT_NEAR(at(t, 1 + s), p(s), 1e-5);
    EXPECT_NEAR(at(t, 7), p(2), 1e-5);
}

TEST(Animation, QuaternionsTurnEvenlyTheShorterWay) {
    AnimationTrack t;
    t.target.key = kOrientationKey;
    t.times = {0, 1};
    const auto about = [](float degrees) {
        const glm::quat q = glm::angleAxis(glm::radians(degrees), glm::vec3(0, 1, 0));
        return glm::vec4(q.x, q.y, q.z, q.w);
    };
    t.values = {about(10), -about(100)};  // the same turn as about(100)
    for (const float share : {0.0f, 0.25f, 0.5f, 0.9f, 1.0f}) {
        const glm::vec4 got = sampleTrack(t, share), want = about(10 + 90 * share);
        EXPECT_NEAR(std::abs(glm::dot(got, want)), 1, 1e-6f) << share;
        EXPECT_NEAR(glm::length(got), 1, 1e-6f);
    }
}

}  // namespace
}  // namespace vitrine
