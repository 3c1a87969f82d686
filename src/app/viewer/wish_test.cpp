// SPDX-License-Identifier: MIT
#include "app/viewer/wish.hpp"

#include <gtest/gtest.h>

#include <bit>

namespace vitrine {
namespace {

bool isPowerOfTwo(int size) {
    return std::has_single_bit(static_cast<unsigned>(size));
}

TEST(Wish, SmallPicturesNeedTheSameProgramsAsLargeOnes) {
    for (const int size : {1,   2,   31,  32,  33,   97,   100,  128,  380,  450,  505,  511,
                           512, 513, 800, 940, 1023, 1024, 1080, 1580, 2048, 3840, 16384}) {
        Wish wish;
        wish.width = size;
        wish.height = 450;
        wish.samples = 16;
        const int small = smallRequestFor(wish).width;
        EXPECT_LE(small, std::max(33, size));
        if (size > 600) {
            EXPECT_LT(small, 600) << size;
        }
        EXPECT_EQ(isPowerOfTwo(small), isPowerOfTwo(size)) << size;
        EXPECT_EQ(isPowerOfTwo((small + 15) / 16), isPowerOfTwo((size + 15) / 16)) << size;
        EXPECT_EQ(smallRequestFor(wish).samples, 16);
    }
}

TEST(Wish, NoSizeOfAMovingPictureIsAPowerOfTwo) {
    Wish wish;
    wish.width = wish.height = 1024;
    wish.moving = true;
    for (const float scale : {1.0f, 0.5f, 0.25f, 1.0f / 12, 1e-6f}) {
        const FrameRequest request = requestFor(wish, scale);
        EXPECT_FALSE(isPowerOfTwo(request.width)) << scale;
        EXPECT_FALSE(isPowerOfTwo(request.height)) << scale;
    }
    wish.moving = false;
    EXPECT_EQ(requestFor(wish, 0.5f).width, 1024) << "at rest it is drawn in full";
}

TEST(Wish, AStillPictureStaysWithinMemory) {
    Wish wish;
    wish.width = 4000;
    wish.height = 3000;
    wish.ssaa = 8;
    EXPECT_EQ(requestFor(wish, 1).ssaa, 1);
}

}  // namespace
}  // namespace vitrine
