// SPDX-License-Identifier: MIT
#include "app/viewer/timeline.hpp"

#include <gtest/gtest.h>

namespace vitrine {
namespace {

Timeline playing(const TimeSpan& span) {
    Timeline timeline;
    timeline.fit(span);
    timeline.playing = true;
    return timeline;
}

TEST(Timeline, StandsAtItsEndOrComesAgain) {
    Timeline once = playing({3, true, false});
    once.loop = false;
    EXPECT_TRUE(once.advance(2));
    EXPECT_FLOAT_EQ(once.time, 2);
    EXPECT_TRUE(once.advance(2));
    EXPECT_FLOAT_EQ(once.time, 3);
    EXPECT_FALSE(once.playing);
    EXPECT_FALSE(once.advance(2));

    Timeline again = playing({3, true, false});
    again.advance(2);
    again.advance(2);
    EXPECT_FLOAT_EQ(again.time, 1);
    EXPECT_TRUE(again.playing);
}

TEST(Timeline, GrowsWhereTimeHasNoEnd) {
    Timeline timeline = playing({10, false, true});
    timeline.loop = false;
    for (int i = 0; i < 25; ++i) EXPECT_TRUE(timeline.advance(1));
    EXPECT_FLOAT_EQ(timeline.time, 25);
    EXPECT_FLOAT_EQ(timeline.duration, 30);
    EXPECT_TRUE(timeline.playing);
    timeline.fit({10, false, true});  // the next moment of the same scene
    EXPECT_FLOAT_EQ(timeline.duration, 30);
    timeline.loop = true;
    for (int i = 0; i < 6; ++i) timeline.advance(1);
    EXPECT_FLOAT_EQ(timeline.time, 1);
}

TEST(Timeline, FollowsAnEditedSpan) {
    Timeline timeline = playing({12, true, true});
    timeline.fit({7, true, true});
    EXPECT_FLOAT_EQ(timeline.duration, 7);
    timeline.fit({});
    EXPECT_FALSE(timeline.playing);
    EXPECT_FALSE(timeline.advance(1));
}

}  // namespace
}  // namespace vitrine
