// SPDX-License-Identifier: MIT
#include "app/cli/frames.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"

namespace vitrine {

TEST(Frames, Ranges) {
    const FrameRange range = parseFrames("3-20:4");
    EXPECT_EQ(range.first, 3);
    EXPECT_EQ(range.last, 20);
    EXPECT_EQ(range.step, 4);
    EXPECT_EQ(parseFrames("7").last, 7);
    EXPECT_EQ(parseFrames("0-23").step, 1);
    for (const char* bad : {"", "-", "a", "5-4", "1-2:0", "1-2:", "1-2x", "1--2", "99999999999",
                            "0-2147483647:2147483647"})
        EXPECT_THROW(parseFrames(bad), UsageError) << bad;
}

TEST(Frames, Resolutions) {
    EXPECT_EQ(parseResolution("1920x1200"), std::make_pair(1920, 1200));
    for (const char* bad :
         {"", "x", "1920", "1920x", "0x10", "10x0", "1920X1200", "20000x10", "1x1x1"})
        EXPECT_THROW(parseResolution(bad), UsageError) << bad;
}

TEST(Frames, FileNames) {
    EXPECT_EQ(frameFileName("ball_####.png", 7), "ball_0007.png");
    EXPECT_EQ(frameFileName("##/x.png", 12345), "12345/x.png");
    EXPECT_THROW(frameFileName("ball.png", 1), UsageError);
}

}  // namespace vitrine
