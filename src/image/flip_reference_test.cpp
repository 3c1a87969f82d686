// SPDX-License-Identifier: MIT
// FLIP once more, slowly: the paper's two-dimensional kernels applied as they stand, in double,
// with the colour constants in the form of other sources. The fast version must agree pixel by
// pixel.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <random>

#include "image/flip.hpp"

namespace vitrine {
namespace {

using Plane = std::vector<double>;
using Vec3 = std::array<double, 3>;

struct Reference {
    int width, height;
    double pixelsPerDegree;

    [[nodiscard]] Plane filter(const Plane& in, int radius,
                               const std::function<double(int, int)>& kernel) const {
        Plane out(in.size());
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                for (int dy = -radius; dy <= radius; ++dy)
                    for (int dx = -radius; dx <= radius; ++dx)
                        out[static_cast<size_t>(y * width + x)] +=
                            kernel(dx, dy) *
                            in[static_cast<size_t>(std::clamp(y + dy, 0, height - 1) * width +
                                                   std::clamp(x + dx, 0, width - 1))];
        return out;
    }

    /// Positive and negative values are scaled to sums of 1 and -1.
    [[nodiscard]] Plane filterNormalized(const Plane& in, int radius,
                                         const std::function<double(int, int)>& kernel) const {
        double positive = 0.0, negative = 0.0;
        for (int y = -radius; y <= radius; ++y)
            for (int x = -radius; x <= radius; ++x) {
                positive += std::max(0.0, kernel(x, y));
                negative -= std::min(0.0, kernel(x, y));
            }
        return filter(in, radius, [&](int x, int y) {
            const double value = kernel(x, y);
            return value > 0.0 ? value / positive : value < 0.0 ? value / negative : 0.0;
        });
    }

    [[nodiscard]] Plane blur(const Plane& in, double a1, double b1, double a2, double b2) const {
        const double pi = std::acos(-1.0);
        const int radius =
            static_cast<int>(std::ceil(3.0 * std::sqrt(0.04 / (2.0 * pi * pi)) * pixelsPerDegree));
        return filterNormalized(in, radius, [&](int x, int y) {
            const double d2 = (x * x + y * y) / (pixelsPerDegree * pixelsPerDegree);
            return a1 * std::sqrt(pi / b1) * std::exp(-pi * pi * d2 / b1) +
                   a2 * std::sqrt(pi / b2) * std::exp(-pi * pi * d2 / b2);
        });
    }

    [[nodiscard]] Plane strength(const Plane& luminance, bool points) const {
        const double sd = 0.5 * 0.082 * pixelsPerDegree;
        const int radius = static_cast<int>(std::ceil(3.0 * sd));
        const auto kernel = [&](int x, int y) {
            const double g = std::exp(-(x * x + y * y) / (2.0 * sd * sd));
            return points ? (x * x / (sd * sd) - 1.0) * g : -x * g;
        };
        const Plane inX = filterNormalized(luminance, radius, kernel);
        const Plane inY =
            filterNormalized(luminance, radius, [&](int x, int y) { return kernel(y, x); });
        Plane out(inX.size());
        for (size_t i = 0; i < out.size(); ++i)
            out[i] = std::sqrt(inX[i] * inX[i] + inY[i] * inY[i]);
        return out;
    }
};

/// sRGB primaries, D65: rows are X, Y and Z over those of white, from the rounded standard matrix,
/// so that agreement is to about 0.001.
constexpr std::array<Vec3, 3> kXyz{
    {{0.4124564 / 0.950470, 0.3575761 / 0.950470, 0.1804375 / 0.950470},
     {0.2126729, 0.7151522, 0.0721750},
     {0.0193339 / 1.088830, 0.1191920 / 1.088830, 0.9503041 / 1.088830}}};

Vec3 huntLab(const Vec3& xyz) {
    const auto f = [](double v) {
        return v > 216.0 / 24389.0 ? std::cbrt(v) : (24389.0 / 27.0 * v + 16.0) / 116.0;
    };
    const double lightness = 116.0 * f(xyz[1]) - 16.0;
    return {lightness, lightness * 5.0 * (f(xyz[0]) - f(xyz[1])),
            lightness * 2.0 * (f(xyz[1]) - f(xyz[2]))};
}

Vec3 multiply(const std::array<Vec3, 3>& m, const Vec3& v) {
    Vec3 out{};
    for (size_t i = 0; i < 3; ++i) out[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
    return out;
}

/// Solves kXyz * rgb = xyz by Cramer's rule.
Vec3 rgbFromXyz(const Vec3& xyz) {
    const auto determinant = [](const std::array<Vec3, 3>& m) {
        return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
               m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
               m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
    };
    Vec3 rgb{};
    for (size_t column = 0; column < 3; ++column) {
        std::array<Vec3, 3> m = kXyz;
        for (size_t i = 0; i < 3; ++i) m[i][column] = xyz[i];
        rgb[column] = determinant(m) / determinant(kXyz);
    }
    return rgb;
}

struct ReferencePercept {
    std::vector<Vec3> lab;
    Plane edges, points;
};

ReferencePercept perceive(const ImageRgba8& image, double pixelsPerDegree) {
    const size_t count = image.pixelCount();
    std::array<Plane, 3> c{Plane(count), Plane(count), Plane(count)};
    Plane luminance(count);
    for (size_t i = 0; i < count; ++i) {
        Vec3 rgb{};
        for (size_t k = 0; k < 3; ++k) {
            const double v = image.pixels[4 * i + k] / 255.0;
            rgb[k] = v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
        }
        const Vec3 xyz = multiply(kXyz, rgb);
        luminance[i] = xyz[1];
        c[0][i] = 116.0 * xyz[1] - 16.0;
        c[1][i] = 500.0 * (xyz[0] - xyz[1]);
        c[2][i] = 200.0 * (xyz[1] - xyz[2]);
    }
    const Reference reference{image.width, image.height, pixelsPerDegree};
    c[0] = reference.blur(c[0], 1.0, 0.0047, 0.0, 1e-5);
    c[1] = reference.blur(c[1], 1.0, 0.0053, 0.0, 1e-5);
    c[2] = reference.blur(c[2], 34.1, 0.04, 13.5, 0.025);
    ReferencePercept result;
    for (size_t i = 0; i < count; ++i) {
        const double y = (c[0][i] + 16.0) / 116.0;
        Vec3 rgb = rgbFromXyz({y + c[1][i] / 500.0, y, y - c[2][i] / 200.0});
        for (double& v : rgb) v = std::clamp(v, 0.0, 1.0);
        result.lab.push_back(huntLab(multiply(kXyz, rgb)));
    }
    result.edges = reference.strength(luminance, false);
    result.points = reference.strength(luminance, true);
    return result;
}

double hyab(const Vec3& a, const Vec3& b) {
    return std::abs(a[0] - b[0]) + std::hypot(a[1] - b[1], a[2] - b[2]);
}

Plane referenceFlip(const ImageRgba8& imageA, const ImageRgba8& imageB, double pixelsPerDegree) {
    const ReferencePercept a = perceive(imageA, pixelsPerDegree);
    const ReferencePercept b = perceive(imageB, pixelsPerDegree);
    const double largest =
        std::pow(hyab(huntLab(multiply(kXyz, {0, 1, 0})), huntLab(multiply(kXyz, {0, 0, 1}))), 0.7);
    Plane result;
    for (size_t i = 0; i < a.lab.size(); ++i) {
        const double error = std::pow(hyab(a.lab[i], b.lab[i]), 0.7) / largest;
        const double color = error < 0.4 ? error / 0.4 * 0.95 : 0.95 + (error - 0.4) / 0.6 * 0.05;
        const double feature = std::sqrt(
            std::max(std::abs(a.edges[i] - b.edges[i]), std::abs(a.points[i] - b.points[i])) /
            std::sqrt(2.0));
        result.push_back(std::pow(color, 1.0 - feature));
    }
    return result;
}

void expectAgreement(const ImageRgba8& a, const ImageRgba8& b, float pixelsPerDegree) {
    const FlipResult fast = flip(a, b, pixelsPerDegree);
    const Plane slow = referenceFlip(a, b, pixelsPerDegree);
    for (size_t i = 0; i < slow.size(); ++i)
        ASSERT_NEAR(fast.map.pixels[i], slow[i], 0.002)
            << "pixel " << i << " at " << pixelsPerDegree << " pixels per degree";
}

using Rgb = std::array<uint8_t, 3>;

ImageRgba8 paint(int width, int height, const std::function<Rgb(int, int)>& color) {
    ImageRgba8 image(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const Rgb c = color(x, y);
            std::copy(c.begin(), c.end(), image.at(x, y).begin());
        }
    return image;
}

ImageRgba8 noise(int width, int height, unsigned seed) {
    std::mt19937 random(seed);
    ImageRgba8 image(width, height);
    for (uint8_t& value : image.pixels) value = static_cast<uint8_t>(random());
    return image;
}

TEST(FlipReference, Agrees) {
    for (const float pixelsPerDegree : {20.0f, kPixelsPerDegree}) {
        expectAgreement(noise(23, 14, 1), noise(23, 14, 2), pixelsPerDegree);
        // Smooth and coloured, with an edge and a dot that only one of them has.
        const auto shade = [](int x, int y) {
            return Rgb{static_cast<uint8_t>(10 * x), static_cast<uint8_t>(200 - 9 * y),
                       static_cast<uint8_t>(5 * x + 5 * y)};
        };
        const ImageRgba8 smooth = paint(24, 18, shade);
        const ImageRgba8 marked = paint(24, 18, [&](int x, int y) {
            return x > 17 || (x == 5 && y == 6) ? Rgb{250, 240, 90} : shade(x, y);
        });
        expectAgreement(smooth, marked, pixelsPerDegree);
    }
}

}  // namespace
}  // namespace vitrine
