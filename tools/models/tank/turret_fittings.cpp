// SPDX-License-Identifier: MIT
// Cupola, hatches, sights, smoke launchers, eyes and aerials.
#include <cmath>

#include "models/tank/layout.hpp"
#include "models/tank/polyhedron.hpp"
#include "models/tank/round.hpp"
#include "models/tank/stowage.hpp"
#include "models/tank/turret.hpp"

namespace vitrine::tank {
namespace {

constexpr Vec3 kCupola{-0.18, 0.70, 0.42};

void addCupola(Assembly& turret) {
    Solid ring = turnedOnLathe({{-0.04, 0.40},
                                {0.035, 0.385},
                                {0.060, 0.355},
                                {0.075, 0.345},
                                {0.165, 0.285},
                                {0.185, 0.27},
                                {0.185, 0.20}},
                               {Axis::kY, 26, 0.007});
    // The rail for the machine gun.
    ring.append(turnedOnLathe({{0.195, 0.305}, {0.195, 0.325}, {0.222, 0.325}, {0.222, 0.305}},
                              {Axis::kY, 24, 0.0, true, Material::kSteel}));
    for (int i = 0; i < 7; ++i) {
        const double angle = kTau * (i + 0.5) / 7.0;
        const Vec3 out(std::cos(angle), 0, std::sin(angle));
        ring.append(bentTube({0.275 * out + Vec3(0, 0.15, 0), 0.312 * out + Vec3(0, 0.205, 0)},
                             {0.011, 4}));
    }
    turret.add(ring, {moved(kCupola)});
    std::vector<Mat4> blocks;
    for (int i = 0; i < 7; ++i)
        blocks.push_back(moved(kCupola) * turned({0, 360.0 * i / 7.0, 0}) *
                         moved({0.300, 0.068, 0}));
    turret.add(makePeriscope(), blocks, 0.9);
    turret.add(makeHatch(0.235), {moved(kCupola + Vec3(0, 0.176, 0))});
    addMachineGun(turret,
                  moved(kCupola + Vec3(0, 0.215, 0)) * turned({0, 18, 0}) * moved({0.315, 0, 0}));
}

void addRoof(Assembly& turret) {
    turret.add(makeHatch(0.27), {moved({-0.22, 0.722, -0.42})});
    Solid sight =
        bevelled(prism({{-0.12, -0.06}, {0.13, -0.06}, {0.13, 0.05}, {0.09, 0.135}, {-0.10, 0.135}},
                       -0.11, 0.11),
                 0.014, Material::kPaint);
    const Vec3 out = glm::normalize(Vec3(0.085, 0.04, 0));
    sight.append(bevelled(box({-0.08, 0, -0.03}, {0.08, 0.004, 0.03}), 0.0, Material::kGlass),
                 standing(Vec3(0.110, 0.0925, 0) - 0.002 * out, out, {0, 0, 1}));
    sight.append(
        bevelled(box({0.05, 0.128, -0.125}, {0.175, 0.140, 0.125}), 0.004, Material::kPaint));
    turret.add(sight,
               {moved({0.38, 0.715, 0.34}), moved({0.30, 0.715, -0.40}) * turned({0, 12, 0})});
    turret.add(turnedOnLathe({{-0.03, 0.17},
                              {0.03, 0.165},
                              {0.042, 0.14},
                              {0.030, 0.125},
                              {0.065, 0.12},
                              {0.11, 0.085},
                              {0.128, 0.0}},
                             {Axis::kY, 18, 0.005}),
               {moved({-0.86, 0.705, 0})});
    // Lifting eyes at the corners of the casting.
    std::vector<Mat4> eyes;
    for (const double side : {1.0, -1.0}) {
        eyes.push_back(moved({0.62, 0.60, side * 0.66}) * turned({0, side * 40, 0}));
        eyes.push_back(moved({-1.36, 0.60, side * 0.66}) * turned({0, side * -40, 0}));
    }
    turret.add(
        bentTube(rounded({{-0.07, -0.05, 0}, {-0.055, 0.10, 0}, {0.055, 0.10, 0}, {0.07, -0.05, 0}},
                         0.06, 2),
                 {0.020, 6}),
        eyes, 0.8);
    // Steps for the crew along both sides.
    std::vector<Mat4> rails;
    for (const double side : {1.0, -1.0})
        for (const double x : {0.30, -0.16})
            rails.push_back(standing({x, 0.515, side * (x > 0 ? 1.000 : 1.028)},
                                     {0.04, 0.55, side * 0.83}, {1, 0, -0.06 * side}));
    turret.add(handle(0.34, 0.085, 0.011, Material::kPaint), rails, 0.8);
}

/// Four throwers on a bracket; looks to +x.
Solid makeSmokeLauncher() {
    Solid bank =
        bevelled(box({-0.16, -0.015, -0.05}, {0.20, 0.012, 0.05}), 0.006, Material::kPaint);
    const Solid pot = [] {
        Solid s = turnedOnLathe({{0.0, 0.0},
                                 {0.0, 0.036},
                                 {0.03, 0.042},
                                 {0.19, 0.042},
                                 {0.19, 0.035},
                                 {0.15, 0.033},
                                 {0.15, 0.0}},
                                {Axis::kX, 8, 0.0});
        s.append(turnedOnLathe({{-0.05, 0.0}, {-0.05, 0.017}, {0.01, 0.017}},
                               {Axis::kX, 6, 0.0, false, Material::kSteel}));
        return s;
    }();
    for (int i = 0; i < 4; ++i)
        bank.append(pot, moved({-0.13 + 0.09 * i, 0.045, 0.0}) * turned({0, 52.0 - 9.0 * i, 24}));
    return bank;
}

void addSmokeLaunchers(Assembly& turret) {
    const Mat4 right = moved({0.66, 0.40, 1.02}) * turned({0, -30, 0});
    const Mat4 mirror = glm::scale(Mat4(1.0), Vec3(1, 1, -1));
    // The bank's pots look outwards; made for the left and mirrored for the right.
    turret.add(makeSmokeLauncher(), {mirror * right, right * mirror}, 0.9);
}

void addAerials(Assembly& turret) {
    Solid aerial = turnedOnLathe(
        {{-0.03, 0.065}, {0.02, 0.062}, {0.035, 0.040}, {0.10, 0.034}, {0.12, 0.020}, {0.16, 0.0}},
        {Axis::kY, 10, 0.004});
    // A spring, then the whip.
    aerial.append(turnedOnLathe({{0.15, 0.016},
                                 {0.162, 0.024},
                                 {0.170, 0.016},
                                 {0.182, 0.024},
                                 {0.190, 0.016},
                                 {0.202, 0.024},
                                 {0.212, 0.0}},
                                {Axis::kY, 7, 0.0, false, Material::kSteel}));
    aerial.append(bentTube({{0, 0.15, 0},
                            {-0.02, 0.6, 0},
                            {-0.07, 1.1, 0.005},
                            {-0.16, 1.6, 0.01},
                            {-0.30, 2.1, 0.02}},
                           {0.0055, 4, false, Material::kSteel}));
    turret.add(aerial,
               {moved({-1.18, 0.66, 0.52}), moved({-1.18, 0.66, -0.52}) * turned({4, 0, 6})}, 0.7);
}

}  // namespace

void addTurretFittings(Assembly& turret) {
    addCupola(turret);
    addRoof(turret);
    addSmokeLaunchers(turret);
    addAerials(turret);
}

}  // namespace vitrine::tank
