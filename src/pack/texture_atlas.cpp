// SPDX-License-Identifier: MIT
#include "pack/texture_atlas.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numeric>

namespace vitrine {
namespace {

/// A level of a picture while it is filtered: four floats a texel, linear.
struct Level {
    int width = 0, height = 0;
    std::vector<float> texels;
    [[nodiscard]] const float* at(int x, int y) const {
        return &texels[4 * (static_cast<size_t>(y) * width + x)];
    }
};

const std::array<float, 256>& linearTable() {
    static const std::array<float, 256> table = [] {
        std::array<float, 256> t{};
        for (size_t i = 0; i < t.size(); ++i) {
            const float c = static_cast<float>(i) / 255.0f;
            t[i] = c <= 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f);
        }
        return t;
    }();
    return table;
}

uint8_t toByte(float c) {
    return static_cast<uint8_t>(std::clamp(c, 0.0f, 1.0f) * 255.0f + 0.5f);
}

uint8_t toSrgbByte(float c) {
    c = std::clamp(c, 0.0f, 1.0f);
    return toByte(c <= 0.0031308f ? 12.92f * c : 1.055f * std::pow(c, 1 / 2.4f) - 0.055f);
}

int powerOfTwoSide(int side) {
    return std::min(static_cast<int>(std::bit_ceil(static_cast<unsigned>(side))), kLargestTexture);
}

/// Averages the source texels under each target texel, or blends between them where there are
/// fewer: a box filter of at least one source texel.
Level resample(const Level& source, int width, int height) {
    Level target{width, height, std::vector<float>(static_cast<size_t>(width) * height * 4)};
    const float scaleX = static_cast<float>(source.width) / static_cast<float>(width);
    const float scaleY = static_cast<float>(source.height) / static_cast<float>(height);
    tbb::parallel_for(0, height, [&](int y) {
        for (int x = 0; x < width; ++x) {
            const auto window = [](int i, float scale, int limit) {
                const float centre = (static_cast<float>(i) + 0.5f) * scale;
                const float half = 0.5f * std::max(scale, 1.0f);
                const float low = std::max(centre - half, 0.0f);
                return std::pair(low, std::min(centre + half, static_cast<float>(limit)));
            };
            const auto [x0, x1] = window(x, scaleX, source.width);
            const auto [y0, y1] = window(y, scaleY, source.height);
            float sum[4] = {}, weights = 0;
            for (int sy = static_cast<int>(y0); sy < source.height && static_cast<float>(sy) < y1;
                 ++sy)
                for (int sx = static_cast<int>(x0);
                     sx < source.width && static_cast<float>(sx) < x1; ++sx) {
                    const auto overlap = [](int i, float low, float high) {
                        return std::min(high, static_cast<float>(i + 1)) -
                               std::max(low, static_cast<float>(i));
                    };
                    const float weight = overlap(sx, x0, x1) * overlap(sy, y0, y1);
                    for (int c = 0; c < 4; ++c) sum[c] += weight * source.at(sx, sy)[c];
                    weights += weight;
                }
            float* out = &target.texels[4 * (static_cast<size_t>(y) * width + x)];
            for (int c = 0; c < 4; ++c) out[c] = sum[c] / weights;
        }
    });
    return target;
}

Level decode(const ImageRgba8& image, TextureUse use) {
    Level level{image.width, image.height, std::vector<float>(image.pixels.size())};
    for (size_t i = 0; i < image.pixels.size(); ++i) {
        const uint8_t byte = image.pixels[i];
        const bool color = use == TextureUse::kColor && i % 4 != 3;
        level.texels[i] = color ? linearTable()[byte] : static_cast<float>(byte) / 255.0f;
    }
    return level;
}

/// The texel that lies at i, which may be outside by one.
int wrapped(int i, int size, TextureWrap wrap) {
    if (wrap == TextureWrap::kRepeat) return (i + size) % size;
    return std::clamp(i, 0, size - 1);
}

void store(const Level& level, const TexturePlace& place, const LevelPlace& at, TextureUse use,
           TexturePage& page) {
    tbb::parallel_for(-1, level.height + 1, [&](int y) {
        for (int x = -1; x <= level.width; ++x) {
            const float* from = level.at(wrapped(x, level.width, place.wrapU),
                                         wrapped(y, level.height, place.wrapV));
            uint8_t* to =
                &page.texels[4 * (static_cast<size_t>(at.y + y) * page.size + (at.x + x))];
            for (int c = 0; c < 3; ++c)
                to[c] = use == TextureUse::kColor ? toSrgbByte(from[c]) : toByte(from[c]);
            to[3] = toByte(from[3]);
        }
    });
}

/// Shelves from the top: pictures sorted by height stand side by side.
class ShelfPacker {
  public:
    explicit ShelfPacker(int size) : size_(size) {}
    /// Page, x, y of a free rectangle.
    std::array<int, 3> place(int width, int height) {
        if (x_ + width > size_) {
            x_ = 0;
            y_ += shelf_;
            shelf_ = 0;
        }
        if (y_ + height > size_) {
            ++page_;
            x_ = y_ = shelf_ = 0;
        }
        const std::array<int, 3> result{page_, x_, y_};
        x_ += width;
        shelf_ = std::max(shelf_, height);
        return result;
    }
    [[nodiscard]] int pages() const { return page_ + 1; }

  private:
    int size_, page_ = 0, x_ = 0, y_ = 0, shelf_ = 0;
};

struct Rectangle {
    size_t texture = 0;
    int level = 0, width = 0, height = 0;  // with the border
};

/// All levels of all textures, the highest first, which is how shelves waste least.
std::vector<Rectangle> rectangles(const std::vector<TexturePlace>& places) {
    std::vector<Rectangle> list;
    for (size_t i = 0; i < places.size(); ++i)
        for (size_t k = 0; k < places[i].levels.size(); ++k)
            list.push_back({i, static_cast<int>(k), (1 << places[i].log2Width >> k) + 2,
                            (1 << places[i].log2Height >> k) + 2});
    std::stable_sort(list.begin(), list.end(),
                     [](const Rectangle& a, const Rectangle& b) { return a.height > b.height; });
    return list;
}

/// One and a half times the largest picture if all fits there, else twice: four of the largest.
int pageSize(const std::vector<Rectangle>& list) {
    int largest = 0;
    double area = 0;
    for (const Rectangle& r : list) {
        largest = std::max(largest, std::max(r.width, r.height));
        area += static_cast<double>(r.width) * r.height;
    }
    return area < 1.5 * largest * largest ? largest + largest / 2 + 2 : 2 * largest;
}

}  // namespace

TextureAtlas packTextures(std::span<const TextureRequest> requests, TextureUse use) {
    TextureAtlas atlas;
    atlas.places.resize(requests.size());
    if (requests.empty()) return atlas;
    for (size_t i = 0; i < requests.size(); ++i) {
        const ImageRgba8& image = *requests[i].image;
        TexturePlace& place = atlas.places[i];
        if (std::max(image.width, image.height) > kLargestTexture) ++atlas.reduced;
        place.log2Width = std::countr_zero(static_cast<unsigned>(powerOfTwoSide(image.width)));
        place.log2Height = std::countr_zero(static_cast<unsigned>(powerOfTwoSide(image.height)));
        place.levels.resize(static_cast<size_t>(1 + std::min(place.log2Width, place.log2Height)));
        place.wrapU = requests[i].wrapU;
        place.nearest = requests[i].nearest;
        place.wrapV = requests[i].wrapV;
    }
    const std::vector<Rectangle> list = rectangles(atlas.places);
    const int size = pageSize(list);
    ShelfPacker packer(size);
    for (const Rectangle& r : list) {
        const auto [page, x, y] = packer.place(r.width, r.height);
        atlas.places[r.texture].levels[static_cast<size_t>(r.level)] = {page, x + 1, y + 1};
    }
    atlas.pages.resize(static_cast<size_t>(packer.pages()));
    for (TexturePage& page : atlas.pages) {
        page.size = size;
        page.texels.resize(static_cast<size_t>(size) * size * 4);
    }
    for (size_t i = 0; i < requests.size(); ++i) {
        const TexturePlace& place = atlas.places[i];
        Level level = decode(*requests[i].image, use);
        for (size_t k = 0; k < place.levels.size(); ++k) {
            const int width = 1 << place.log2Width >> k, height = 1 << place.log2Height >> k;
            if (level.width != width || level.height != height)
                level = resample(level, width, height);
            store(level, place, place.levels[k], use,
                  atlas.pages[static_cast<size_t>(place.levels[k].page)]);
        }
    }
    return atlas;
}

}  // namespace vitrine
