// SPDX-License-Identifier: MIT
// Hatches, lamps, hooks and splash boards.
#include <cmath>

#include "models/tank/hull.hpp"
#include "models/tank/layout.hpp"
#include "models/tank/polyhedron.hpp"
#include "models/tank/round.hpp"
#include "models/tank/stowage.hpp"
#include "models/tank/track.hpp"

namespace vitrine::tank {
namespace {

void addHatches(Assembly& hull) {
    constexpr double kX = 1.66, kZ = 0.50;
    hull.add(makeHatch(0.26), {moved({kX, kRoofY, -kZ}) * turned({0, -90, 0}),
                               moved({kX, kRoofY, kZ}) * turned({0, 90, 0})});
    std::vector<Mat4> periscopes;
    for (const double side : {-1.0, 1.0})
        for (const double turn : {-32.0, 0.0, 32.0})
            periscopes.push_back(moved({kX - 0.03, kRoofY, side * kZ}) * turned({0, turn, 0}) *
                                 moved({0.385, 0, 0}));
    hull.add(makePeriscope(), periscopes, 0.9);
    // A ventilator between the two.
    hull.add(turnedOnLathe({{-0.01, 0.15},
                            {0.035, 0.145},
                            {0.045, 0.12},
                            {0.035, 0.11},
                            {0.06, 0.105},
                            {0.10, 0.07},
                            {0.112, 0.0}},
                           {Axis::kY, 16, 0.005}),
             {moved({1.72, kRoofY, 0})});
}

void addLampsAndHooks(Assembly& hull) {
    std::vector<Mat4> lamps, hooks, rearHooks;
    for (const double side : {1.0, -1.0}) {
        lamps.push_back(moved(onGlacis(0.48, side * 0.85)));
        hooks.push_back(standing(onGlacis(1.16, side * 0.72), glacisOut(), glacisDown()));
        rearHooks.push_back(
            standing({kRearX + 0.06, 0.72, side * 0.70}, {-1, -0.16, 0}, {0, 1, 0}));
    }
    hull.add(makeHeadlamp(), lamps, 0.9);
    for (const Mat4& m : rearHooks) hooks.push_back(m);
    hull.add(makeTowHook(), hooks, 0.9);

    Solid tail = bevelled(box({-0.03, -0.05, -0.09}, {0.05, 0.05, 0.09}), 0.012, Material::kPaint);
    for (const double z : {-0.045, 0.045})
        tail.append(turnedOnLathe({{0.045, 0.034}, {0.062, 0.030}, {0.068, 0.0}},
                                  {Axis::kX, 10, 0.004, false, Material::kLamp}),
                    moved({0, 0, z}));
    hull.add(tail,
             {moved({kRearX + 0.05, 1.30, 1.05}) * turned({0, 180, 0}),
              moved({kRearX + 0.05, 1.30, -1.05}) * turned({0, 180, 0})},
             0.9);
}

/// Keeps water from the driver's hatch: a flat V on the glacis.
void addSplashBoard(Assembly& hull) {
    Solid board;
    for (const double side : {1.0, -1.0}) {
        const Vec3 middle = onGlacis(0.62, side * -0.004), end = onGlacis(0.44, side * 0.68);
        const Vec3 along = glm::normalize(end - middle);
        const double length = glm::distance(middle, end);
        board.append(
            bevelled(prism({{0, -0.01}, {length, -0.01}, {length - 0.03, 0.075}, {0, 0.095}},
                           -0.008, 0.008),
                     0.004, Material::kPaint),
            standing(middle, glacisOut(), along));
    }
    hull.add(board, {Mat4(1.0)}, 0.8);
}

/// Four links of track on the lower glacis, clamped by a bar.
void addSpareTrack(Assembly& hull) {
    std::vector<Mat4> links;
    for (int i = 0; i < 4; ++i) {
        const double z = (i - 1.5) * kPitch;
        links.push_back(standing(onGlacis(0.97, z) + 0.034 * glacisOut(), glacisOut(), {0, 0, 1}));
    }
    hull.add(makeLink(), links, 1.4);
    std::vector<Mat4> bars;
    for (const double down : {0.80, 1.14})
        bars.push_back(standing(onGlacis(down, 0) + 0.058 * glacisOut(), glacisOut(), {0, 0, 1}));
    Solid bar =
        bevelled(box({-0.46, -0.012, -0.022}, {0.46, 0.010, 0.022}), 0.005, Material::kPaint);
    for (const double x : {-0.435, 0.435}) {
        bar.append(hexBolt(0.018, 0.016, Material::kSteel), moved({x, 0.010, 0}));
        bar.append(bentTube({{x, -0.07, 0}, {x, 0, 0}}, {0.014, 6, false, Material::kSteel}));
    }
    hull.add(bar, bars, 0.8);
}

void addRearPlate(Assembly& hull) {
    const Vec3 out = glm::normalize(Vec3(-1, -0.16, 0));
    Solid pintle =
        turnedOnLathe({{-0.01, 0.12}, {0.03, 0.115}, {0.04, 0.06}, {0.11, 0.055}, {0.115, 0.0}},
                      {Axis::kY, 12, 0.006});
    pintle.append(bentTube(
        rounded({{0.0, 0.08, -0.045}, {0.0, 0.23, -0.045}, {0.0, 0.23, 0.045}, {0.0, 0.08, 0.045}},
                0.05, 2),
        {0.022, 6, false, Material::kSteel}));
    hull.add(pintle, {standing({kRearX + 0.052, 0.78, 0}, out, {0, 1, 0})}, 0.8);
    // The box with the infantry's telephone.
    Solid box1 = bevelled(box({-0.06, -0.13, -0.09}, {0.10, 0.13, 0.09}), 0.012, Material::kPaint);
    box1.append(
        bevelled(box({0.09, -0.10, -0.065}, {0.108, 0.10, 0.065}), 0.006, Material::kPaint));
    hull.add(box1, {moved({kRearX - 0.01, 1.32, 0.28}) * turned({0, 180, 0})}, 0.8);
}

}  // namespace

void addHullFittings(Assembly& hull) {
    addHatches(hull);
    addLampsAndHooks(hull);
    addSplashBoard(hull);
    addSpareTrack(hull);
    addRearPlate(hull);
}

}  // namespace vitrine::tank
