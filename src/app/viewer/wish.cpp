// SPDX-License-Identifier: MIT
#include "app/viewer/wish.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace vitrine {
namespace {

constexpr int64_t kMostPixels = 16 << 20;

bool isPowerOfTwo(int size) {
    return std::has_single_bit(static_cast<unsigned>(size));
}

/// Resolution changes all the time while a picture moves: no size of it needs programs of its own.
int scaled(int size, float scale) {
    const int side = std::max(1, static_cast<int>(std::lround(static_cast<float>(size) * scale)));
    return isPowerOfTwo(side) ? std::max(3, side + 1) : side;
}

/// The smallest size from 33 on that is a power of two, and whose parts in frame/lens_filter.cpp
/// are, where those of `size` are.
int standIn(int size) {
    const auto same = [size](int other) {
        const auto part = [](int whole, int side) { return (whole + side - 1) / side; };
        return isPowerOfTwo(other) == isPowerOfTwo(size) &&
               isPowerOfTwo(part(other, 16)) == isPowerOfTwo(part(size, 16)) &&
               isPowerOfTwo(other + part(other, 2)) == isPowerOfTwo(size + part(size, 2));
    };
    int other = 33;
    while (other < size && !same(other)) ++other;
    return std::min(other, size);
}

}  // namespace

void takeSettings(const RenderSettings& settings, Wish& wish) {
    wish.samples = settings.samples;
    wish.bounces = settings.bounces;
    wish.ssaa = settings.ssaa;
    wish.seed = settings.seed;
}

FrameRequest requestFor(const Wish& wish, float scale) {
    FrameRequest request;
    request.width = wish.moving ? scaled(wish.width, scale) : wish.width;
    request.height = wish.moving ? scaled(wish.height, scale) : wish.height;
    request.camera = wish.camera;
    request.time = wish.time;
    request.samples = wish.moving ? 1 : wish.samples;
    request.bounces = wish.bounces;
    request.ssaa = wish.moving ? 1 : wish.ssaa;
    // A slider must not take all of the GPU's memory.
    const auto pixels = static_cast<int64_t>(request.width) * request.height;
    while (request.ssaa > 1 && pixels * request.ssaa * request.ssaa > kMostPixels) --request.ssaa;
    request.seed = wish.seed;
    request.view = wish.view;
    request.quick = wish.moving;
    return request;
}

FrameRequest smallRequestFor(const Wish& wish) {
    FrameRequest request = requestFor(wish, 1);
    request.width = standIn(request.width);
    request.height = standIn(request.height);
    return request;
}

}  // namespace vitrine
