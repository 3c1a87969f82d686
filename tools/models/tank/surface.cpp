// SPDX-License-Identifier: MIT
// Layers, from the inside out: metal, primer, paint, numbers, rust, dust, mud. Each covers what is
// below by a mask between 0 and 1. Masks come from noise in space, so they run over the seams of
// the texture; the noise is warped by noise, which makes camouflage flow (Quilez, "Domain warping",
// 2002).
#include "models/tank/surface.hpp"

#include <algorithm>
#include <cmath>

#include "models/tank/layout.hpp"
#include "models/tank/lettering.hpp"
#include "models/tank/noise.hpp"

namespace vitrine::tank {
namespace {

/// From sRGB as one picks it, 0 to 255.
Vec3 rgb(double r, double g, double b) {
    const auto linear = [](double v) {
        return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    };
    return {linear(r / 255.0), linear(g / 255.0), linear(b / 255.0)};
}

const Vec3 kGreen = rgb(82, 88, 54), kBrown = rgb(84, 62, 43), kSand = rgb(138, 124, 90);
const Vec3 kWhite = rgb(206, 203, 190), kPrimer = rgb(98, 52, 38), kBareSteel = rgb(158, 154, 148);
const Vec3 kDust = rgb(152, 134, 106), kMud = rgb(78, 63, 47), kRust = rgb(104, 58, 32);
const Vec3 kSoot = rgb(22, 21, 20);

void cover(Look& look, double mask, const Vec3& colour, double roughness, double metal) {
    look.colour = glm::mix(look.colour, colour, mask);
    look.roughness = glm::mix(look.roughness, roughness, mask);
    look.metal = glm::mix(look.metal, metal, mask);
}

Vec3 camouflage(const Vec3& p) {
    const Vec3 warp =
        Vec3(fractal(p * 1.1, 3), fractal(p * 1.1 + 31.0, 3), fractal(p * 1.1 + 67.0, 3)) - 0.5;
    const Vec3 q = p * Vec3(0.62, 0.80, 0.80) + 1.5 * warp;
    // Sprayed by hand: the edges are soft by a few centimetres.
    const auto patch = [](double value, double level) {
        return glm::smoothstep(level - 0.010, level + 0.010, value);
    };
    Vec3 colour = kGreen;
    colour = glm::mix(colour, kBrown, patch(fractal(q + 5.0, 2), 0.555));
    return glm::mix(colour, kSand, patch(fractal(q * 1.15 + 47.0, 2), 0.60));
}

Look paint(const SurfacePoint& s) {
    const double fine = fractal(s.at * 42.0, 3), broad = fractal(s.at * 2.3, 3);
    Look look{s.camouflaged ? camouflage(s.at) : kGreen, 0.60 + 0.16 * (broad - 0.5), 0.0, 0.0};
    // Bleached by the sun above, and no two square metres alike.
    look.colour *= 0.80 + 0.40 * broad;
    look.colour = glm::mix(look.colour, rgb(150, 146, 118), 0.10 * std::max(0.0, s.normal.y));
    for (const Lettering& lettering : s.letterings) {
        const double worn = glm::smoothstep(0.28, 0.42, fractal(s.at * 30.0 + 9.0, 3));
        cover(look, 0.92 * worn * stencil(lettering, s.at, s.normal, 0.006), kWhite, 0.65, 0.0);
    }
    // Grooves and corners hold dark grease; so the lines read from afar.
    const double grease = std::clamp(
        0.9 * s.marked.groove + 0.35 * s.marked.weld + 0.45 * s.crevice * s.crevice, 0.0, 1.0);
    cover(look, 0.75 * grease, rgb(38, 34, 27), 0.80, 0.0);
    // Wear: a rim of primer around bare metal, as wide as feet and tools made it.
    const double use = 0.3 + 1.1 * fractal(s.at * 3.7 + 3.0, 2);
    const double width = 0.016 * use * std::max(0.0, 3.0 * fine - 1.15);
    const auto within = [&s](double w) { return 1.0 - glm::smoothstep(0.35 * w, w, s.edge); };
    const double scratch = 0.8 * glm::smoothstep(0.70, 0.78, fractal(s.at * 24.0 + 90.0, 4)) *
                           glm::smoothstep(0.48, 0.66, broad);
    const double chip = std::max(scratch, width > 0.001 ? within(width) : 0.0);
    cover(look, 0.8 * std::max(chip, width > 0.001 ? within(1.7 * width) : 0.0), kPrimer, 0.75,
          0.0);
    cover(look, chip, 0.40 * kBareSteel, 0.46, 0.80);
    cover(look, 0.22 * within(0.018) * use, 1.35 * look.colour + 0.01, 0.48, look.metal);
    return look;
}

Look bare(const SurfacePoint& s) {
    const double fine = fractal(s.at * 50.0 + 13.0, 3), broad = fractal(s.at * 7.0 + 5.0, 2);
    const double bright = 1.0 - glm::smoothstep(0.001, 0.010, s.edge);
    switch (s.material) {
        case Material::kSteel: {
            Look look{rgb(92, 90, 86) * (0.7 + 0.6 * fine), 0.46, 0.80, 0.0};
            const double weather = s.height < 1.3 || s.inTank.x < kRearX ? 0.75 : 0.25;
            cover(look, weather * glm::smoothstep(0.52, 0.68, broad * 0.6 + fine * 0.4), kRust,
                  0.90, 0.0);
            cover(look, 0.7 * bright * fine, kBareSteel, 0.32, 1.0);
            return look;
        }
        case Material::kTrack: {
            Look look{rgb(74, 68, 63) * (0.6 + 0.7 * fine), 0.58, 0.75, 0.0};
            cover(look, 0.55 * glm::smoothstep(0.42, 0.62, broad), rgb(80, 60, 46), 0.92, 0.05);
            cover(look, 0.85 * bright, kBareSteel, 0.30, 1.0);
            return look;
        }
        case Material::kRubber:
            return {rgb(38, 37, 36) * (0.7 + 0.6 * fine), 0.86, 0.0, 0.0};
        case Material::kGlass:
            return {rgb(18, 34, 38), 0.06, 0.0, 0.0};
        case Material::kLamp:
            return {s.inTank.x < 0.0 ? rgb(120, 14, 10) : rgb(205, 205, 196), 0.10, 0.0, 0.0};
        case Material::kWood: {
            const double ring = noise(s.at * Vec3(3.0, 90.0, 90.0));
            return {glm::mix(rgb(112, 78, 46), rgb(154, 116, 74), ring), 0.70, 0.0, 0.0};
        }
        default: {
            const double fold = fractal(s.at * Vec3(9.0, 16.0, 6.0), 3);
            return {rgb(122, 112, 82) * (0.45 + 1.1 * fold) * (0.9 + 0.2 * fine), 0.92, 0.0, 0.0};
        }
    }
}

/// Streaks that rain has drawn down steep sides.
void addRain(Look& look, const SurfacePoint& s) {
    const double steep = 1.0 - glm::smoothstep(0.25, 0.60, std::abs(s.normal.y));
    if (s.rolls || steep <= 0.0) return;
    const double streak = fractal(s.inTank * Vec3(16.0, 0.9, 16.0), 2);
    const double broken = fractal(s.inTank * Vec3(2.5, 1.6, 2.5) + 7.0, 2);
    const double mask = steep * glm::smoothstep(0.40, 0.62, broken);
    cover(look, 0.42 * mask * glm::smoothstep(0.56, 0.72, streak), 0.45 * rgb(78, 62, 44), 0.52,
          0.0);
    cover(look, 0.30 * mask * (1.0 - glm::smoothstep(0.28, 0.42, streak)), kDust, 0.85, 0.0);
}

void addSoot(Look& look, const SurfacePoint& s) {
    double soot = 0.0;
    for (const double side : {1.0, -1.0}) {
        const Vec3 pipe(kRearX - 0.22, 1.36, side * 0.62);
        soot = std::max(soot, 0.8 * std::exp(-std::pow(glm::distance(s.inTank, pipe) / 0.26, 2.0)));
    }
    const double muzzle = kTurretInHull.x + kGunInTurret.x + 4.72;
    soot = std::max(soot, glm::smoothstep(muzzle - 0.60, muzzle, s.inTank.x));
    cover(look, soot * (0.45 + 0.65 * fractal(s.at * 12.0, 2)), kSoot, 0.92, 0.0);
}

void addDirt(Look& look, const SurfacePoint& s) {
    const double cloud = fractal(s.inTank * 3.1 + 21.0, 4),
                 fine = fractal(s.inTank * 24.0 + 2.0, 3);
    const double up = s.rolls ? 0.3 : std::max(0.0, s.normal.y);
    // Wheels throw off what they pick up.
    const double low = (s.rolls ? 0.48 : 1.0) * (1.0 - glm::smoothstep(0.25, 1.35, s.height));
    const bool clean = s.material == Material::kGlass || s.material == Material::kLamp;
    const double hold = clean ? 0.35 : s.material == Material::kRubber ? 0.38 : 1.0;
    double dust = 0.36 * up * up * glm::smoothstep(0.30, 0.70, cloud) + 0.34 * s.crevice * up +
                  0.80 * low * (0.35 + 0.65 * cloud);
    // What is used stays clean: worn edges, the faces that rub.
    dust *= (0.55 + 0.9 * fine) * glm::smoothstep(0.0, 0.012, s.edge);
    cover(look, std::clamp(hold * dust, 0.0, 0.75), kDust, 0.95, 0.0);
    const double splash =
        glm::smoothstep(0.50, 0.60, 0.45 * cloud + 0.30 * fine + 0.30 * low + 0.10 * s.crevice);
    const double mud = low * splash * (clean ? 0.0 : hold);
    cover(look, 0.90 * mud, kMud * (0.75 + 0.5 * fine), 0.93, 0.0);
    look.lump = 0.010 * mud * fine;
}

}  // namespace

Look lookAt(const SurfacePoint& point) {
    Look look = point.material == Material::kPaint ? paint(point) : bare(point);
    if (point.material == Material::kPaint) addRain(look, point);
    addSoot(look, point);
    addDirt(look, point);
    // The shade of corners is a little in the dirt too, which no light ever washes out.
    look.colour *= 0.72 + 0.28 * point.open;
    look.colour = glm::clamp(look.colour, 0.0, 1.0);
    look.roughness = std::clamp(look.roughness, 0.04, 1.0);
    return look;
}

}  // namespace vitrine::tank
