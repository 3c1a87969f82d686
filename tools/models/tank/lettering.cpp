// SPDX-License-Identifier: MIT
#include "models/tank/lettering.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace vitrine::tank {
namespace {

/// Digits as strokes in a box of width 0.6 and height 1; -1 ends a digit's list.
struct Stroke {
    Vec2 a, b;
};

constexpr Vec2 kTopLeft{0, 1}, kTopRight{0.6, 1}, kMiddleLeft{0, 0.5}, kMiddleRight{0.6, 0.5},
    kBottomLeft{0, 0}, kBottomRight{0.6, 0};

std::vector<Stroke> strokesOf(char digit) {
    // The seven segments: top, upper left, upper right, middle, lower left, lower right, bottom.
    constexpr std::array<uint8_t, 10> kLit = {0b1110111, 0b0010010, 0b1011101, 0b1011011,
                                              0b0111010, 0b1101011, 0b1101111, 0b1010010,
                                              0b1111111, 0b1111011};
    const std::array<Stroke, 7> segments = {
        Stroke{kTopLeft, kTopRight},      Stroke{kMiddleLeft, kTopLeft},
        Stroke{kMiddleRight, kTopRight},  Stroke{kMiddleLeft, kMiddleRight},
        Stroke{kBottomLeft, kMiddleLeft}, Stroke{kBottomRight, kMiddleRight},
        Stroke{kBottomLeft, kBottomRight}};
    if (digit == '1') return {{{0.3, 0}, {0.3, 1}}, {{0.12, 0.82}, {0.3, 1}}};
    if (digit == '7') return {{kTopLeft, kTopRight}, {{0.22, 0}, kTopRight}};
    std::vector<Stroke> strokes;
    for (size_t i = 0; i < segments.size(); ++i)
        if (kLit[static_cast<size_t>(digit - '0')] >> (6 - i) & 1) strokes.push_back(segments[i]);
    return strokes;
}

double distanceTo(const Stroke& stroke, const Vec2& p) {
    const Vec2 d = stroke.b - stroke.a;
    const double t = glm::clamp(glm::dot(p - stroke.a, d) / glm::dot(d, d), 0.0, 1.0);
    return glm::distance(p, stroke.a + t * d);
}

}  // namespace

double stencil(const Lettering& lettering, const Vec3& p, const Vec3& normal, double softness) {
    constexpr double kDepth = 0.35, kHalfStroke = 0.085, kAdvance = 0.92;
    const Vec3 out = glm::normalize(lettering.facing);
    const Vec3 offset = p - lettering.middle;
    if (glm::dot(normal, out) < 0.35 || std::abs(glm::dot(offset, out)) > kDepth) return 0.0;
    const Vec3 right = glm::normalize(glm::cross(Vec3(0, 1, 0), out)), up = glm::cross(out, right);
    const double count = double(lettering.digits.size());
    const Vec2 at(glm::dot(offset, right) / lettering.height + 0.5 * (kAdvance * (count - 1) + 0.6),
                  glm::dot(offset, up) / lettering.height + 0.5);
    double nearest = 1.0;
    for (size_t i = 0; i < lettering.digits.size(); ++i)
        for (const Stroke& stroke : strokesOf(lettering.digits[i]))
            nearest = std::min(nearest, distanceTo(stroke, at - Vec2(kAdvance * double(i), 0)));
    const double soft = softness / lettering.height;
    double paint = 1.0 - glm::smoothstep(kHalfStroke - soft, kHalfStroke + soft, nearest);
    // The bridges that hold a stencil together: a gap at half a quarter of the height.
    const double bridge = std::min(std::abs(at.y - 0.27), std::abs(at.y - 0.73));
    paint *= glm::smoothstep(0.012, 0.012 + 2.0 * soft, bridge);
    return paint;
}

}  // namespace vitrine::tank
