// SPDX-License-Identifier: MIT
#include "base/text.hpp"

#include <gtest/gtest.h>

namespace vitrine {

TEST(Text, EditDistanceCountsSlips) {
    EXPECT_EQ(editDistance("", ""), 0);
    EXPECT_EQ(editDistance("abc", ""), 3);
    EXPECT_EQ(editDistance("exposure", "expsure"), 1);
    EXPECT_EQ(editDistance("exposure", "expsoure"), 1) << "a swap of neighbours is one slip";
    EXPECT_EQ(editDistance("kitten", "sitting"), 3);
}

TEST(Text, DidYouMeanOnlyWhenNear) {
    const std::vector<std::string> keys{"exposure", "gamma", "bounces"};
    EXPECT_EQ(closestMatch("expsure", keys), "exposure");
    EXPECT_EQ(closestMatch("gama", keys), "gamma");
    EXPECT_EQ(closestMatch("zebra", keys), "");
    EXPECT_EQ(didYouMean("bounce", keys), " (did you mean 'bounces'?)");
    EXPECT_EQ(didYouMean("zebra", keys), "");
}

TEST(Text, SplitLinesKeepsEmptyOnesAndDropsCarriageReturns) {
    const auto lines = splitLines("a\r\n\nb");
    ASSERT_EQ(lines.size(), 3u);
    EXPECT_EQ(lines[0], "a");
    EXPECT_EQ(lines[1], "");
    EXPECT_EQ(lines[2], "b");
    EXPECT_TRUE(splitLines("").empty());
}

}  // namespace vitrine
