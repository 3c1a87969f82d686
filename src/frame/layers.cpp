// SPDX-License-Identifier: MIT
#include "frame/layers.hpp"

#include <algorithm>

#include "base/math.hpp"

namespace vitrine {
namespace {

/// Texels of a texture, four values each, bottom row first, seen as blocks of the picture's pixels.
template <typename T>
class Blocks {
  public:
    Blocks(std::vector<T> values, int width, int height, int ssaa)
        : values_(std::move(values)), width_(width), height_(height), ssaa_(ssaa) {}

    /// Texel (i, j) of the block of pixel (x, y), which counts from the top left.
    [[nodiscard]] const T* at(int x, int y, int i, int j) const {
        const size_t row = static_cast<size_t>((height_ - 1 - y) * ssaa_ + j);
        return &values_[4 * (row * static_cast<size_t>(width_ * ssaa_) +
                             static_cast<size_t>(x * ssaa_ + i))];
    }
    [[nodiscard]] const T* middle(int x, int y) const { return at(x, y, ssaa_ / 2, ssaa_ / 2); }
    [[nodiscard]] glm::vec3 mean(int x, int y) const {
        glm::vec3 sum(0);
        for (int j = 0; j < ssaa_; ++j)
            for (int i = 0; i < ssaa_; ++i) {
                const T* value = at(x, y, i, j);
                sum += glm::vec3(value[0], value[1], value[2]);
            }
        return sum / static_cast<float>(ssaa_ * ssaa_);
    }

  private:
    std::vector<T> values_;
    int width_, height_, ssaa_;
};

void set(std::span<float> to, const glm::vec3& value) {
    for (int c = 0; c < 3; ++c) to[static_cast<size_t>(c)] = value[c];
}

}  // namespace

void LayerTextures::allocate(int width, int height) {
    ids = Texture(width, height, TexelFormat::kRgba32ui);
    albedo = Texture(width, height, TexelFormat::kRgba32f);
    normal = Texture(width, height, TexelFormat::kRgba32f);
}

LayerImages readLayers(const Texture& mean, const LayerTextures& textures, int ssaa) {
    const int width = mean.width() / ssaa, height = mean.height() / ssaa;
    LayerImages layers{
        {width, height}, {width, height}, {width, height}, {width, height}, {width, height}};
    const auto forPixels = [&](auto&& body) {
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) body(x, y);
    };
    // One texture at a time: each may be hundreds of megabytes.
    {
        const Blocks<float> light(mean.readFloats(), width, height, ssaa);
        forPixels([&](int x, int y) {
            set(layers.light.at(x, y), light.mean(x, y));
            layers.light.at(x, y)[3] = 1;
        });
    }
    {
        const Blocks<float> albedo(textures.albedo.readFloats(), width, height, ssaa);
        forPixels([&](int x, int y) { set(layers.albedo.at(x, y), albedo.mean(x, y)); });
    }
    {
        const Blocks<uint32_t> ids(textures.ids.readUints(), width, height, ssaa);
        forPixels(
            [&](int x, int y) { std::copy_n(ids.middle(x, y), 3, layers.ids.at(x, y).data()); });
    }
    const Blocks<float> normal(textures.normal.readFloats(), width, height, ssaa);
    forPixels([&](int x, int y) {
        const glm::vec3 n = normal.mean(x, y);
        const float length = glm::length(n);
        set(layers.normal.at(x, y), length > 0 ? n / length : n);
        const bool isSurface = layers.ids.at(x, y)[0] != kNoId;
        layers.depth.at(x, y)[0] = isSurface ? normal.middle(x, y)[3] : kNoDepth;
    });
    return layers;
}

}  // namespace vitrine
