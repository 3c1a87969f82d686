// SPDX-License-Identifier: MIT
#include "models/tank/wheels.hpp"

#include <cmath>

#include "models/tank/layout.hpp"
#include "models/tank/polyhedron.hpp"
#include "models/tank/round.hpp"

namespace vitrine::tank {
namespace {

constexpr double kInner = 0.055, kOuter = 0.205;  // faces of a tyre, from the middle of the track

Mat4 aroundAxle(double turn) {
    return glm::rotate(Mat4(1.0), kTau * turn, Vec3(0, 0, 1));
}

/// `count` copies on a circle; `each` stands on its y axis, which becomes +z.
void addCircle(Solid& wheel, const Solid& each, int count, double radius, double z,
               double phase = 0.0) {
    for (int i = 0; i < count; ++i)
        wheel.append(
            each, aroundAxle((i + phase) / count) * standing({radius, 0, z}, {0, 0, 1}, {1, 0, 0}));
}

Solid lathe(const std::vector<Vec2>& profile, int segments, double bevel,
            Material material = Material::kPaint) {
    return turnedOnLathe(profile, {Axis::kZ, segments, bevel, false, material});
}

/// A toothed ring as an outline: four corners a tooth, valleys hold the pins.
std::vector<Vec2> toothOutline() {
    constexpr double kTip = kSprocketRadius + 0.030, kValley = kSprocketRadius - 0.020;
    std::vector<Vec2> outline;
    for (int i = 0; i < kSprocketTeeth; ++i) {
        const auto add = [&](double turn, double radius) {
            const double angle = kTau * (i + turn) / kSprocketTeeth;
            outline.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
        };
        add(-0.31, kValley);
        add(-0.10, kTip);
        add(0.10, kTip);
        add(0.31, kValley);
    }
    return outline;
}

}  // namespace

Solid makeRoadWheel() {
    constexpr int kSides = 22, kTyreSides = 26, kInnerSides = 16;
    constexpr double kR = kWheelRadius, kRim = 0.328;
    Solid wheel;
    // Tyres reach in behind the rims, whose flats are longer.
    constexpr double kFoot = kRim - 0.010;
    wheel.append(lathe({{kInner, kFoot}, {kInner, kR}, {kOuter, kR}, {kOuter, kFoot}}, kTyreSides,
                       0.022, Material::kRubber));
    wheel.append(lathe({{-kOuter, kFoot}, {-kOuter, kR}, {-kInner, kR}, {-kInner, kFoot}},
                       kInnerSides, 0.0, Material::kRubber));
    // The outer disc, from the rim to the hub's cap; the inner one; and the hub between them. The
    // disc reaches under the tyre as deep as its face lies back: nothing of that shows, but with a
    // flat lid there it would be a solid, so it hides its backs from all eyes before it.
    wheel.append(lathe({{0.114, kRim + 0.003},
                        {0.214, kRim},
                        {0.214, 0.310},
                        {0.132, 0.264},
                        {0.120, 0.165},
                        {0.188, 0.142},
                        {0.250, 0.094},
                        {0.264, 0.0}},
                       kSides, 0.007));
    wheel.append(lathe({{-0.15, 0.0}, {-0.15, 0.29}, {-kOuter, kRim + 0.003}}, kInnerSides, 0.0));
    wheel.append(lathe({{-kInner, 0.342}, {-0.07, 0.10}, {0.07, 0.10}, {kInner, 0.342}}, 12, 0.0));
    const Solid rib = bevelled(
        prism({{0.155, 0.112}, {0.300, 0.130}, {0.290, 0.190}, {0.155, 0.166}}, -0.011, 0.011), 0.0,
        Material::kPaint);
    constexpr int kRibs = 8;
    for (int i = 0; i < kRibs; ++i)
        wheel.append(rib, aroundAxle(double(i) / kRibs) * turned({90, 0, 0}));
    addCircle(wheel, rivet(0.016, Material::kSteel), 6, 0.118, 0.216, 0.5);
    return wheel;
}

Solid makeSprocket() {
    Solid wheel;
    const std::vector<Vec2> teeth = toothOutline();
    wheel.append(softBar(teeth, 0.222, 0.250, 0.006, Material::kSteel));
    wheel.append(bevelled(prism(teeth, -0.250, -0.222), 0.0, Material::kSteel));
    wheel.append(lathe({{-0.26, 0.10},
                        {-0.26, 0.22},
                        {-0.05, 0.225},
                        {0.05, 0.225},
                        {0.18, 0.24},
                        {0.262, 0.24},
                        {0.268, 0.205},
                        {0.225, 0.185},
                        {0.255, 0.12},
                        {0.325, 0.105},
                        {0.338, 0.0}},
                       20, 0.006));
    addCircle(wheel, rivet(0.020, Material::kSteel), kSprocketTeeth, 0.222, 0.263, 0.5);
    addCircle(wheel, rivet(0.013, Material::kSteel), 6, 0.070, 0.328);
    return wheel;
}

Solid makeIdler() {
    constexpr double kR = kIdlerRadius;
    Solid wheel;
    // Two steel-rimmed discs, open between spokes as far as one can tell from outside.
    wheel.append(lathe({{kInner, 0.10},
                        {kInner, kR},
                        {kOuter - 0.01, kR},
                        {kOuter - 0.01, kR - 0.045},
                        {0.120, kR - 0.065},
                        {0.100, 0.135},
                        {0.170, 0.120},
                        {0.235, 0.085},
                        {0.250, 0.0}},
                       22, 0.006));
    wheel.append(lathe({{-0.14, 0.0},
                        {-0.14, 0.24},
                        {-kOuter, kR - 0.02},
                        {-kOuter, kR},
                        {-kInner, kR},
                        {-kInner, 0.10},
                        {kInner, 0.10}},
                       22, 0.0));
    const Solid spoke = softBar({{0.120, 0.095}, {0.262, 0.112}, {0.262, 0.150}, {0.120, 0.168}},
                                -0.016, 0.016, 0.006, Material::kPaint);
    for (int i = 0; i < 6; ++i) wheel.append(spoke, aroundAxle(i / 6.0) * turned({90, 0, 0}));
    addCircle(wheel, rivet(0.013, Material::kSteel), 6, 0.092, 0.224);
    return wheel;
}

Solid makeReturnRoller() {
    constexpr double kR = kRollerRadius;
    Solid wheel;
    for (const double z : {0.13, -0.13})
        wheel.append(lathe({{z - 0.055, 0.08}, {z - 0.055, kR}, {z + 0.055, kR}, {z + 0.055, 0.08}},
                           13, z > 0.0 ? 0.010 : 0.0, Material::kRubber));
    wheel.append(lathe(
        {{-0.18, 0.085}, {0.192, 0.085}, {0.175, 0.055}, {0.215, 0.045}, {0.222, 0.0}}, 12, 0.004));
    return wheel;
}

}  // namespace vitrine::tank
