// SPDX-License-Identifier: MIT
#include "app/viewer/pace.hpp"

#include <gtest/gtest.h>

namespace vitrine {
namespace {

/// Seconds of a frame of a scene that costs `fixed` and, at full resolution, `full` more.
double cost(const Pace& pace, double fixed, double full) {
    return fixed + full * pace.scale() * pace.scale();
}

TEST(Pace, SettlesWithinTheBudget) {
    for (const double full : {0.01, 0.1, 1.0, 5.0}) {
        Pace pace;
        for (int i = 0; i < 40; ++i) pace.took(cost(pace, 0.005, full), 0.08);
        const double seconds = cost(pace, 0.005, full);
        EXPECT_LT(seconds, 0.093);
        EXPECT_TRUE(pace.scale() == 1 || seconds > 0.05);
        const float settled = pace.scale();
        for (int i = 0; i < 5; ++i) pace.took(cost(pace, 0.005, full), 0.08);
        EXPECT_EQ(pace.scale(), settled) << "it breathes";
    }
}

TEST(Pace, OneSlowFrameIsAnsweredAtOnce) {
    Pace pace;
    for (int i = 0; i < 40; ++i) pace.took(cost(pace, 0, 0.05), 0.08);
    EXPECT_EQ(pace.scale(), 1.0f);
    pace.took(cost(pace, 0, 2.0), 0.08);
    EXPECT_LT(cost(pace, 0, 2.0), 0.12);
}

TEST(Pace, NeverLeavesItsRange) {
    Pace pace;
    for (int i = 0; i < 100; ++i) pace.took(1e9, 0.08);
    EXPECT_EQ(pace.scale(), Pace::kCoarsest);
    for (int i = 0; i < 100; ++i) pace.took(0, 0.08);
    EXPECT_EQ(pace.scale(), 1.0f);
}

}  // namespace
}  // namespace vitrine
