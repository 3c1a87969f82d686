// SPDX-License-Identifier: MIT
// Two pipelines, joined at the end (names as in the paper):
//   colour: sRGB -> YCxCz -> blur as the eye does -> L*a*b*, Hunt effect -> HyAB -> 0..1
//   feature: luminance -> edges and points -> difference of their strength -> 0..1
//   join: colour ^ (1 - feature): where edges appear or vanish, colour errors weigh more.
// Every filter of the paper is a Gaussian, one of its derivatives, or a sum of two Gaussians, so
// all of them split into a pass along x and one along y. Pixels outside repeat the border.
#include "image/flip.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>
#include <numeric>
#include <span>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/math.hpp"

namespace vitrine {
namespace {

using Kernel = std::vector<float>;  // odd length, centre in the middle

constexpr double kPi2 = std::numbers::pi * std::numbers::pi;

/// a * sqrt(pi / b) * exp(-pi^2 x^2 / b), x in degrees: a term of a contrast sensitivity function,
/// as a filter in space.
struct CsfTerm {
    double a, b;
};
constexpr std::array<CsfTerm, 1> kCsfAchromatic{{{1.0, 0.0047}}};
constexpr std::array<CsfTerm, 1> kCsfRedGreen{{{1.0, 0.0053}}};
constexpr std::array<CsfTerm, 2> kCsfBlueYellow{{{34.1, 0.04}, {13.5, 0.025}}};
constexpr double kCsfWidest = 0.04;

constexpr float kColorExponent = 0.7f;     // q_c: evens out large colour differences
constexpr float kRedistributeFrom = 0.4f;  // p_c: this share of the largest difference ...
constexpr float kRedistributeTo = 0.95f;   // p_t: ... becomes this error
constexpr float kFeatureExponent = 0.5f;   // q_f
constexpr double kFeatureDegrees = 0.082;  // w: width of the eye's edge detector

template <typename Function>
void forEachRow(int height, const Function& function) {
    tbb::parallel_for(tbb::blocked_range<int>(0, height), [&](const tbb::blocked_range<int>& rows) {
        for (int y = rows.begin(); y < rows.end(); ++y) function(y);
    });
}

ImageMap convolveX(const ImageMap& in, const Kernel& kernel) {
    const int radius = static_cast<int>(kernel.size() / 2);
    ImageMap out(in.width, in.height);
    forEachRow(in.height, [&](int y) {
        const std::span<const float> from = in.row(y);
        std::vector<float> padded(static_cast<size_t>(radius), from.front());
        padded.insert(padded.end(), from.begin(), from.end());
        padded.insert(padded.end(), static_cast<size_t>(radius), from.back());
        const std::span<float> to = out.row(y);
        for (size_t k = 0; k < kernel.size(); ++k)
            for (size_t x = 0; x < to.size(); ++x) to[x] += kernel[k] * padded[x + k];
    });
    return out;
}

ImageMap convolveY(const ImageMap& in, const Kernel& kernel) {
    const int radius = static_cast<int>(kernel.size() / 2);
    ImageMap out(in.width, in.height);
    forEachRow(in.height, [&](int y) {
        const std::span<float> to = out.row(y);
        for (int k = -radius; k <= radius; ++k) {
            const std::span<const float> from = in.row(glm::clamp(y + k, 0, in.height - 1));
            const float weight = kernel[static_cast<size_t>(k + radius)];
            for (size_t x = 0; x < to.size(); ++x) to[x] += weight * from[x];
        }
    });
    return out;
}

/// Values of `function` at -radius..radius, divided by the sum of the values of their own sign.
template <typename Function>
Kernel normalizedKernel(int radius, const Function& function) {
    double positive = 0.0, negative = 0.0;
    for (int x = -radius; x <= radius; ++x) {
        const double value = function(x);
        (value > 0.0 ? positive : negative) += std::abs(value);
    }
    Kernel kernel;
    for (int x = -radius; x <= radius; ++x) {
        const double value = function(x);
        kernel.push_back(static_cast<float>(value > 0.0   ? value / positive
                                            : value < 0.0 ? value / negative
                                                          : 0.0));
    }
    return kernel;
}

ImageMap filterByCsf(const ImageMap& in, std::span<const CsfTerm> terms, double pixelsPerDegree) {
    const int radius =
        static_cast<int>(std::ceil(3.0 * std::sqrt(kCsfWidest / (2.0 * kPi2)) * pixelsPerDegree));
    std::vector<double> weights;
    std::vector<Kernel> kernels;
    for (const CsfTerm& term : terms) {
        const auto gaussian = [&](int x) {
            const double degrees = x / pixelsPerDegree;
            return std::exp(-kPi2 * degrees * degrees / term.b);
        };
        double sum = 0.0;
        for (int x = -radius; x <= radius; ++x) sum += gaussian(x);
        // The kernel sums to 1; what it took is given back to the weight, once per direction.
        weights.push_back(term.a * std::sqrt(std::numbers::pi / term.b) * sum * sum);
        kernels.push_back(normalizedKernel(radius, gaussian));
    }
    const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
    ImageMap out(in.width, in.height);
    for (size_t i = 0; i < terms.size(); ++i) {
        const ImageMap filtered = convolveY(convolveX(in, kernels[i]), kernels[i]);
        const float weight = static_cast<float>(weights[i] / total);
        for (size_t p = 0; p < out.pixels.size(); ++p) out.pixels[p] += weight * filtered.pixels[p];
    }
    return out;
}

// The matrix of sRGB primaries and the D65 white point in whole numbers; columns are R, G and B.
const glm::mat3 kXyzFromRgb(glm::dmat3(10135552.0 / 24577794.0, 2613072.0 / 12288897.0,
                                       1425312.0 / 73733382.0,  //
                                       8788810.0 / 24577794.0, 8788810.0 / 12288897.0,
                                       8788810.0 / 73733382.0,  //
                                       4435075.0 / 24577794.0, 887015.0 / 12288897.0,
                                       70074185.0 / 73733382.0));
const glm::mat3 kRgbFromXyz(glm::inverse(glm::dmat3(kXyzFromRgb)));
const glm::vec3 kWhite = kXyzFromRgb * glm::vec3(1.0f);

float linearFromSrgb(float value) {
    return value <= 0.04045f ? value / 12.92f : std::pow((value + 0.055f) / 1.055f, 2.4f);
}

/// A linear form of L*a*b*, fit for filtering: lightness, red to green, blue to yellow.
glm::vec3 ycxczFromRgb(const glm::vec3& rgb) {
    const glm::vec3 xyz = kXyzFromRgb * rgb / kWhite;
    return {116.0f * xyz.y - 16.0f, 500.0f * (xyz.x - xyz.y), 200.0f * (xyz.y - xyz.z)};
}

glm::vec3 rgbFromYcxcz(const glm::vec3& c) {
    const float y = (c.x + 16.0f) / 116.0f;
    return kRgbFromXyz * (glm::vec3(y + c.y / 500.0f, y, y - c.z / 200.0f) * kWhite);
}

/// CIE 1976 L*a*b* of a linear colour, with the Hunt effect: the darker, the less colourful.
glm::vec3 huntLabFromRgb(const glm::vec3& rgb) {
    const glm::vec3 xyz = kXyzFromRgb * rgb / kWhite;
    const auto compress = [](float v) {
        constexpr float kDelta = 6.0f / 29.0f;
        return v > kDelta * kDelta * kDelta ? std::cbrt(v)
                                            : v / (3.0f * kDelta * kDelta) + 4.0f / 29.0f;
    };
    const glm::vec3 f(compress(xyz.x), compress(xyz.y), compress(xyz.z));
    const float lightness = 116.0f * f.y - 16.0f;
    return {lightness, 0.01f * lightness * 500.0f * (f.x - f.y),
            0.01f * lightness * 200.0f * (f.y - f.z)};
}

/// A distance that also holds for large differences (Abasi, Tehran and Fairchild 2020).
float hyab(const glm::vec3& a, const glm::vec3& b) {
    return std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z);
}

/// q_c-th power of the distance, stretched so that errors fill 0..1. Green to blue is the largest.
float colorError(const glm::vec3& a, const glm::vec3& b) {
    static const float kLargest =
        std::pow(hyab(huntLabFromRgb({0, 1, 0}), huntLabFromRgb({0, 0, 1})), kColorExponent);
    const float knee = kRedistributeFrom * kLargest;
    const float error = std::pow(hyab(a, b), kColorExponent);
    if (error < knee) return error * kRedistributeTo / knee;
    const float beyond = (error - knee) / (kLargest - knee);
    return std::min(1.0f, kRedistributeTo + beyond * (1.0f - kRedistributeTo));
}

/// What the eye makes of one picture.
struct Percept {
    ImageMap y, cx, cz;      // after the eye's blur
    ImageMap edges, points;  // strength of each

    [[nodiscard]] glm::vec3 huntLab(size_t i) const {
        const glm::vec3 rgb = rgbFromYcxcz({y.pixels[i], cx.pixels[i], cz.pixels[i]});
        return huntLabFromRgb(glm::clamp(rgb, 0.0f, 1.0f));
    }
};

/// Length of the vector of what `alongX` finds in x and in y; `smooth` acts across.
ImageMap featureStrength(const ImageMap& luminance, const Kernel& alongX, const Kernel& smooth) {
    ImageMap inX = convolveY(convolveX(luminance, alongX), smooth);
    const ImageMap inY = convolveY(convolveX(luminance, smooth), alongX);
    for (size_t i = 0; i < inX.pixels.size(); ++i)
        inX.pixels[i] = std::hypot(inX.pixels[i], inY.pixels[i]);
    return inX;
}

Percept perceive(const ImageRgba8& image, double pixelsPerDegree) {
    std::array<float, 256> linear{};
    for (size_t i = 0; i < linear.size(); ++i)
        linear[i] = linearFromSrgb(static_cast<float>(i) / 255.0f);
    const int width = image.width, height = image.height;
    ImageMap y(width, height), cx(width, height), cz(width, height), luminance(width, height);
    for (size_t i = 0; i < image.pixelCount(); ++i) {
        const uint8_t* p = &image.pixels[4 * i];
        const glm::vec3 c = ycxczFromRgb({linear[p[0]], linear[p[1]], linear[p[2]]});
        y.pixels[i] = c.x;
        cx.pixels[i] = c.y;
        cz.pixels[i] = c.z;
        luminance.pixels[i] = (c.x + 16.0f) / 116.0f;
    }

    const double sd = 0.5 * kFeatureDegrees * pixelsPerDegree;
    const int radius = static_cast<int>(std::ceil(3.0 * sd));
    const auto gaussian = [&](int x) { return std::exp(-x * x / (2.0 * sd * sd)); };
    const Kernel smooth = normalizedKernel(radius, gaussian);
    const Kernel first = normalizedKernel(radius, [&](int x) { return -x * gaussian(x); });
    const Kernel second =
        normalizedKernel(radius, [&](int x) { return (x * x / (sd * sd) - 1.0) * gaussian(x); });
    return {filterByCsf(y, kCsfAchromatic, pixelsPerDegree),
            filterByCsf(cx, kCsfRedGreen, pixelsPerDegree),
            filterByCsf(cz, kCsfBlueYellow, pixelsPerDegree),
            featureStrength(luminance, first, smooth), featureStrength(luminance, second, smooth)};
}

float featureError(const Percept& a, const Percept& b, size_t i) {
    const float edge = std::abs(a.edges.pixels[i] - b.edges.pixels[i]);
    const float point = std::abs(a.points.pixels[i] - b.points.pixels[i]);
    const float strongest = std::max(edge, point) / std::numbers::sqrt2_v<float>;
    return std::min(1.0f, std::pow(strongest, kFeatureExponent));
}

std::string sizeText(const ImageRgba8& image) {
    return std::to_string(image.width) + " x " + std::to_string(image.height);
}

}  // namespace

FlipResult flip(const ImageRgba8& reference, const ImageRgba8& test, float pixelsPerDegree) {
    assert(pixelsPerDegree > 0.0f);
    if (reference.width != test.width || reference.height != test.height)
        throw InputError({}, "the pictures differ in size: " + sizeText(reference) + " and " +
                                 sizeText(test) + " pixels");
    FlipResult result{ImageMap(test.width, test.height)};
    if (test.pixelCount() == 0) return result;

    const Percept a = perceive(reference, pixelsPerDegree);
    const Percept b = perceive(test, pixelsPerDegree);
    forEachRow(test.height, [&](int y) {
        const size_t begin = static_cast<size_t>(y) * test.width;
        for (size_t i = begin; i < begin + test.width; ++i)
            result.map.pixels[i] =
                std::pow(colorError(a.huntLab(i), b.huntLab(i)), 1.0f - featureError(a, b, i));
    });
    // In one thread and one order, so that the sum is always the same.
    const std::vector<float>& errors = result.map.pixels;
    result.mean =
        std::accumulate(errors.begin(), errors.end(), 0.0) / static_cast<double>(errors.size());
    return result;
}

}  // namespace vitrine
