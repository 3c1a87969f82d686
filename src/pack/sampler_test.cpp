// SPDX-License-Identifier: MIT
// The sampler's promises: nets in each pixel and over pixels, no relation between dimensions, and
// errors that the eye averages away.
#include "pack/sampler.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <functional>
#include <random>
#include <set>
#include <vector>

namespace vitrine {
namespace {

using glm::uvec2;
using glm::vec2;

vec2 unitPoint(const uvec2& bits) {
    return vec2(bits >> 8u) * (1.0f / 16777216.0f);
}

/// Sobol's second dimension as the textbook has it: an exclusive or of direction numbers.
uint32_t textbookSobol(uint32_t index) {
    uint32_t result = 0;
    for (uint32_t v = 1u << 31; index != 0; index >>= 1, v ^= v >> 1)
        if ((index & 1) != 0) result ^= v;
    return result;
}

/// Every box of 2^-a by 2^-(m-a) holds exactly one of the 2^m points.
void expectNet(const std::vector<uvec2>& points) {
    const int m = static_cast<int>(std::bit_width(points.size())) - 1;
    ASSERT_EQ(points.size(), size_t{1} << m);
    for (int a = 0; a <= m; ++a) {
        std::set<std::pair<uint32_t, uint32_t>> boxes;
        for (const uvec2& p : points)
            boxes.emplace(a == 0 ? 0 : p.x >> (32 - a), a == m ? 0 : p.y >> (32 - m + a));
        ASSERT_EQ(boxes.size(), points.size()) << "boxes of 2^-" << a << " by 2^-" << m - a;
    }
}

TEST(Sampler, MortonCodeInterleavesBits) {
    std::mt19937 random(1);
    for (int i = 0; i < 1000; ++i) {
        const uint32_t x = random() & 0xffff, y = random() & 0xffff;
        uint32_t expected = 0;
        for (int bit = 0; bit < 16; ++bit)
            expected |= ((x >> bit) & 1u) << (2 * bit) | ((y >> bit) & 1u) << (2 * bit + 1);
        ASSERT_EQ(sampler::mortonCode(x, y), expected) << x << ' ' << y;
    }
}

TEST(Sampler, SobolIsTheTextbooks) {
    std::mt19937 random(2);
    for (int i = 0; i < 1000; ++i) {
        const auto index = static_cast<uint32_t>(random());
        ASSERT_EQ(sampler::reverseBits(sampler::sobolReversed(index)), textbookSobol(index));
    }
}

TEST(Sampler, BitsBelowIsTheCeilingOfTheLogarithm) {
    for (uint32_t count = 1; count <= 70000; ++count)
        ASSERT_EQ(sampler::bitsBelow(count), static_cast<uint32_t>(std::bit_width(count - 1)));
}

TEST(Sampler, EachPixelHasNets) {
    std::mt19937 random(3);
    for (const uint32_t count : {1u, 2u, 8u, 16u, 64u, 1024u})
        for (int i = 0; i < 20; ++i) {
            const uvec2 pixel(random() % 3840, random() % 2400);
            const auto dimension = static_cast<uint32_t>(random() % 100);
            const auto seed = static_cast<uint32_t>(random());
            for (const uint32_t block : {0u, 1u, 5u}) {
                std::vector<uvec2> points;
                for (uint32_t s = 0; s < count; ++s)
                    points.push_back(
                        sampler::sampleBits(pixel, block * count + s, count, dimension, seed));
                expectNet(points);
            }
        }
}

TEST(Sampler, SquaresOfPixelsHaveNets) {
    std::mt19937 random(4);
    for (const uint32_t side : {2u, 4u, 16u})
        for (const uint32_t count : {1u, 4u, 16u}) {
            const uvec2 corner = uvec2(random() % 100, random() % 100) * side;
            const auto dimension = static_cast<uint32_t>(random() % 100);
            std::vector<uvec2> points;
            for (uint32_t y = 0; y < side; ++y)
                for (uint32_t x = 0; x < side; ++x)
                    for (uint32_t s = 0; s < count; ++s)
                        points.push_back(
                            sampler::sampleBits(corner + uvec2(x, y), s, count, dimension, 7));
            expectNet(points);
        }
}

/// Of 16 x 16 bins over (a, b), as standard deviations from what independent numbers give. Where
/// the numbers are more even than chance, which is welcome, it is negative.
double dependence(const std::vector<float>& a, const std::vector<float>& b) {
    constexpr int kBins = 16;
    std::vector<double> bins(kBins * kBins);
    for (size_t i = 0; i < a.size(); ++i)
        bins[static_cast<size_t>(a[i] * kBins) * kBins + static_cast<size_t>(b[i] * kBins)] += 1;
    const double expected = static_cast<double>(a.size()) / (kBins * kBins);
    double chiSquare = 0;
    for (const double n : bins) chiSquare += (n - expected) * (n - expected) / expected;
    constexpr double kFreedom = kBins * kBins - 1;
    return (chiSquare - kFreedom) / std::sqrt(2 * kFreedom);
}

TEST(Sampler, DimensionsAndSeedsAreUnrelated) {
    // The uses in the shaders: ambient from 16, bounces from 64; and seeds that follow each other.
    const std::vector<std::pair<uint32_t, uint32_t>> uses{{16, 0}, {17, 0}, {64, 0}, {65, 0},
                                                          {66, 0}, {64, 1}, {64, 2}};
    for (const uint32_t count : {1u, 4u}) {
        std::vector<std::vector<float>> numbers;
        for (const auto& [dimension, seed] : uses) {
            std::vector<float> x, y;
            for (uint32_t py = 0; py < 64; ++py)
                for (uint32_t px = 0; px < 64; ++px)
                    for (uint32_t s = 0; s < count; ++s) {
                        const vec2 p =
                            unitPoint(sampler::sampleBits({px, py}, s, count, dimension, seed));
                        x.push_back(p.x);
                        y.push_back(p.y);
                    }
            numbers.push_back(x);
            numbers.push_back(y);
        }
        for (size_t i = 0; i < numbers.size(); ++i)
            for (size_t j = 0; j < i; ++j)
                EXPECT_LT(dependence(numbers[i], numbers[j]), 10) << i << ' ' << j;
    }
    const std::vector<float> ramp = [] {
        std::vector<float> values;
        for (int i = 0; i < 4096; ++i) values.push_back(static_cast<float>(i) / 4096);
        return values;
    }();
    EXPECT_GT(dependence(ramp, ramp), 100) << "the measure sees a relation";
}

using Integrand = std::function<float(const vec2&)>;

/// Mean square of the error of a picture of estimates, after a box blur of `width` pixels.
double blurredError(int width, const std::function<float(uint32_t, uint32_t)>& error) {
    constexpr int kSide = 128;
    std::vector<double> picture(kSide * kSide);
    for (uint32_t y = 0; y < kSide; ++y)
        for (uint32_t x = 0; x < kSide; ++x) picture[y * kSide + x] = error(x, y);
    double sum = 0;
    // At all places, not only at those of the aligned squares.
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            double mean = 0;
            for (int j = 0; j < width; ++j)
                for (int i = 0; i < width; ++i)
                    mean +=
                        picture[static_cast<size_t>(((y + j) % kSide) * kSide + (x + i) % kSide)];
            mean /= width * width;
            sum += mean * mean;
        }
    return sum / (kSide * kSide);
}

TEST(Sampler, ErrorsAreOfHighFrequency) {
    const std::pair<Integrand, float> integrands[] = {
        {[](const vec2& p) { return p.x < 0.3f ? 1.0f : 0.0f; }, 0.3f},
        {[](const vec2& p) { return p.x + p.y < 1 ? 1.0f : 0.0f; }, 0.5f},
        {[](const vec2& p) { return p.x * p.y; }, 0.25f}};
    double sumOfFour = 0, sumOfEight = 0;
    for (const uint32_t count : {1u, 4u})
        for (const auto& [integrand, exact] : integrands) {
            const auto errorOf =
                [&](const std::function<vec2(uint32_t, uint32_t, uint32_t)>& point) {
                    return [&, point](uint32_t x, uint32_t y) {
                        float sum = 0;
                        for (uint32_t s = 0; s < count; ++s) sum += integrand(point(x, y, s));
                        return sum / static_cast<float>(count) - exact;
                    };
                };
            const auto ours = errorOf([&](uint32_t x, uint32_t y, uint32_t s) {
                return unitPoint(sampler::sampleBits({x, y}, s, count, 64, 0));
            });
            const auto white = errorOf([&](uint32_t x, uint32_t y, uint32_t s) {
                return unitPoint(uvec2(sampler::pcg4d(glm::uvec4(x, y, s, 5))));
            });
            EXPECT_LT(blurredError(1, ours), 1.1 * blurredError(1, white));
            const double four = blurredError(4, ours) / blurredError(4, white);
            const double eight = blurredError(8, ours) / blurredError(8, white);
            // An edge across the boxes of the nets is the hardest; white noise has 1.
            EXPECT_LT(four, 0.65);
            EXPECT_LT(eight, 0.5);
            sumOfFour += four / 6;
            sumOfEight += eight / 6;
        }
    EXPECT_LT(sumOfFour, 0.35);
    EXPECT_LT(sumOfEight, 0.22);
}

}  // namespace
}  // namespace vitrine
