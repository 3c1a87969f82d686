// SPDX-License-Identifier: MIT
#include "pack/sky_map.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/packing.hpp>

namespace vitrine {
namespace {

constexpr int kMostTreeLevels = 10;
constexpr float kLargestHalf = 60000;
/// Brighter than any source that a picture could tell from infinity.
constexpr float kLargestRadiance = 1e7f;

/// Plain rows of RGB and a fourth number, from the zenith down.
struct Plane {
    int width = 0, height = 0;
    std::vector<glm::vec4> texels;

    Plane(int w, int h) : width(w), height(h), texels(static_cast<size_t>(w) * h) {}
    glm::vec4& at(int x, int y) { return texels[static_cast<size_t>(y) * width + x]; }
    [[nodiscard]] const glm::vec4& at(int x, int y) const {
        return texels[static_cast<size_t>(y) * width + x];
    }
};

/// Height of the edge above a row on the unit sphere.
double edgeHeight(int row, int rows) {
    return std::cos(static_cast<double>(kPi) * row / rows);
}
/// Solid angle of a texel of this row.
double solidAngle(int row, int rows, int columns) {
    return (edgeHeight(row, rows) - edgeHeight(row + 1, rows)) * 2 * kPi / columns;
}

Plane mended(const ImageRgba32f& picture, size_t& count) {
    Plane out(picture.width, picture.height);
    for (size_t i = 0; i < out.texels.size(); ++i) {
        bool good = true;
        for (int c = 0; c < 3; ++c) {
            const float v = picture.pixels[4 * i + static_cast<size_t>(c)];
            good = good && v >= 0 && v <= kLargestRadiance;
            out.texels[i][c] = std::isnan(v) ? 0.0f : std::clamp(v, 0.0f, kLargestRadiance);
        }
        count += !good;
    }
    return out;
}

struct Share {
    int index;
    double part;
};
/// Which texels of a row of `from` a texel of a row of `to` covers, and how much of each.
std::vector<Share> covered(int i, int to, int from) {
    const double begin = static_cast<double>(i) * from / to;
    const double end = static_cast<double>(i + 1) * from / to;
    std::vector<Share> shares;
    for (int k = static_cast<int>(begin); k < from && k < end; ++k) {
        const double part = std::min(end, k + 1.0) - std::max(begin, static_cast<double>(k));
        if (part > 1e-9) shares.push_back({k, part});
    }
    return shares;
}

/// The mean over the area of each new texel on the sphere.
Plane resampled(const Plane& in, int width, int height) {
    if (width == in.width && height == in.height) return in;
    Plane narrow(width, in.height);
    for (int x = 0; x < width; ++x) {
        const auto columns = covered(x, width, in.width);
        double whole = 0;
        for (const Share& s : columns) whole += s.part;
        for (int y = 0; y < in.height; ++y) {
            glm::dvec4 sum(0);
            for (const Share& s : columns) sum += s.part * glm::dvec4(in.at(s.index, y));
            narrow.at(x, y) = glm::vec4(sum / whole);
        }
    }
    Plane out(width, height);
    for (int y = 0; y < height; ++y) {
        const auto rows = covered(y, height, in.height);
        double whole = 0;
        for (const Share& s : rows) whole += s.part * solidAngle(s.index, in.height, 1);
        for (int x = 0; x < width; ++x) {
            glm::dvec4 sum(0);
            for (const Share& s : rows)
                sum +=
                    s.part * solidAngle(s.index, in.height, 1) * glm::dvec4(narrow.at(x, s.index));
            out.at(x, y) = glm::vec4(sum / whole);
        }
    }
    return out;
}

/// Light that a bilinear filter spreads from a texel to its neighbours must be found there as well:
/// the mean of the filtered picture over each texel.
std::vector<double> spread(const std::vector<double>& in, int width, int height) {
    std::vector<double> rows(in.size()), out(in.size());
    const auto at = [&](int x, int y) {
        return static_cast<size_t>(std::clamp(y, 0, height - 1)) * width + (x + width) % width;
    };
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            rows[at(x, y)] = 0.75 * in[at(x, y)] + 0.125 * (in[at(x - 1, y)] + in[at(x + 1, y)]);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            out[at(x, y)] =
                0.75 * rows[at(x, y)] + 0.125 * (rows[at(x, y - 1)] + rows[at(x, y + 1)]);
    return out;
}

int treeLevels(int width) {
    int levels = 1;
    while (levels < kMostTreeLevels && 1 << levels < width) ++levels;
    return levels;
}

/// `radiance` of the cells of the finest level, row by row.
SkyTree makeTree(const std::vector<double>& radiance, int levels) {
    int width = 1 << levels, height = width / 2;
    std::vector<double> power(radiance.size());
    double total = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const size_t i = static_cast<size_t>(y) * width + x;
            power[i] = radiance[i] * solidAngle(y, height, width);
            total += power[i];
        }
    for (double& p : power) p = total > 0 ? p / total : 1.0 / static_cast<double>(radiance.size());
    SkyTree tree;
    tree.levels = levels;
    std::vector<std::vector<glm::vec4>> stack;
    for (int level = levels - 1; level >= 0; --level) {
        const int columns = std::max(1, width / 2), rows = std::max(1, height / 2);
        std::vector<glm::vec4> nodes(static_cast<size_t>(columns) * rows);
        std::vector<double> sums(nodes.size());
        for (int y = 0; y < rows; ++y)
            for (int x = 0; x < columns; ++x) {
                glm::dvec4 children(0);
                for (int child = 0; child < 4; ++child) {
                    const int cy = 2 * y + child / 2, cx = 2 * x + child % 2;
                    if (cy < height) children[child] = power[static_cast<size_t>(cy) * width + cx];
                }
                const size_t i = static_cast<size_t>(y) * columns + x;
                nodes[i] = glm::vec4(children);
                sums[i] = children.x + children.y + children.z + children.w;
            }
        stack.push_back(std::move(nodes));
        power = std::move(sums);
        width = columns;
        height = rows;
    }
    for (auto nodes = stack.rbegin(); nodes != stack.rend(); ++nodes)
        tree.nodes.insert(tree.nodes.end(), nodes->begin(), nodes->end());
    return tree;
}

SkyLevel packed(const Plane& plane, float scale) {
    SkyLevel level{plane.width, plane.height, {}};
    level.texels.reserve(plane.texels.size() * 4);
    for (const glm::vec4& t : plane.texels)
        for (int c = 0; c < 4; ++c) level.texels.push_back(glm::packHalf1x16(t[c] / scale));
    return level;
}

}  // namespace

float luminance(const glm::vec3& radiance) {
    return glm::dot(radiance, glm::vec3(0.2126f, 0.7152f, 0.0722f));
}

glm::vec3 skyDirection(float u, float v) {
    const float around = 2 * kPi * (u - 0.5f), up = kPi * (0.5f - v);
    return {std::cos(up) * std::cos(around), std::sin(up), std::cos(up) * std::sin(around)};
}

SkyMap makeSkyMap(const ImageRgba32f& picture) {
    SkyMap map;
    Plane plane = mended(picture, map.mendedTexels);
    if (plane.width > kMostSkyWidth)
        plane = resampled(plane, kMostSkyWidth,
                          std::max(1, static_cast<int>(static_cast<int64_t>(plane.height) *
                                                       kMostSkyWidth / plane.width)));
    const auto power = [&](auto&& value) {
        glm::dvec3 sum(0);
        for (int y = 0; y < plane.height; ++y) {
            glm::dvec3 row(0);
            for (int x = 0; x < plane.width; ++x) row += glm::dvec3(value(plane.at(x, y)));
            sum += row * solidAngle(y, plane.height, plane.width);
        }
        return sum / (4.0 * kPi);
    };
    map.mean = glm::vec3(power([](const glm::vec4& t) { return glm::vec3(t.x, t.y, t.z); }));
    const float limit = kBrightMultiple * luminance(map.mean);
    const double dim = power([&](const glm::vec4& t) {
                           return glm::vec3(std::min(luminance(glm::vec3(t.x, t.y, t.z)), limit));
                       }).x;
    const float share = limit > 0 ? 1 - static_cast<float>(dim) / luminance(map.mean) : 0.0f;
    map.brightShare = share < kLeastBrightShare ? 0.0f : share;

    // From here on, xyz is what is below the limit and w the luminance of the rest.
    float brightest = 0;
    for (glm::vec4& t : plane.texels) {
        brightest = std::max({brightest, t.x, t.y, t.z});
        const float whole = luminance(glm::vec3(t.x, t.y, t.z));
        if (map.brightShare == 0 || whole <= limit) continue;
        t *= limit / whole;
        t.w = whole - limit;
    }
    map.scale = std::max(1.0f, brightest / kLargestHalf);

    const int levels = treeLevels(plane.width);
    const Plane cells = resampled(plane, 1 << levels, std::max(1, (1 << levels) / 2));
    std::vector<double> whole, bright;
    for (const glm::vec4& t : cells.texels) {
        whole.push_back(luminance(glm::vec3(t.x, t.y, t.z)) + t.w);
        bright.push_back(t.w);
    }
    map.whole = makeTree(spread(whole, cells.width, cells.height), levels);
    if (map.brightShare > 0)
        map.bright = makeTree(spread(bright, cells.width, cells.height), levels);

    while (true) {
        map.levels.push_back(packed(plane, map.scale));
        if (plane.width == 1 && plane.height == 1) return map;
        plane = resampled(plane, std::max(1, plane.width / 2), std::max(1, plane.height / 2));
    }
}

}  // namespace vitrine
