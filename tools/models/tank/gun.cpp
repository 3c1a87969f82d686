// SPDX-License-Identifier: MIT
#include "models/tank/gun.hpp"

#include <cmath>

#include "models/tank/layout.hpp"
#include "models/tank/polyhedron.hpp"
#include "models/tank/round.hpp"

namespace vitrine::tank {
namespace {

constexpr double kBore = 0.050;  // radius; the gun is a 100 mm
constexpr double kBrakeStart = 4.26, kMuzzle = 4.80;

/// A drum between the turret's cheeks, and a snout that turns from a rounded box into a tube.
Solid makeMantlet() {
    Solid mantlet = turnedOnLathe({{-0.425, 0.0},
                                   {-0.425, 0.290},
                                   {-0.405, 0.305},
                                   {0.405, 0.305},
                                   {0.425, 0.290},
                                   {0.425, 0.0}},
                                  {Axis::kZ, 28, 0.0});
    struct Section {
        double x, half, high, square;
    };
    constexpr std::array kSections = {
        Section{0.16, 0.360, 0.235, 4.5}, Section{0.33, 0.352, 0.228, 4.2},
        Section{0.42, 0.325, 0.215, 3.8}, Section{0.52, 0.270, 0.200, 3.2},
        Section{0.64, 0.215, 0.186, 2.6}, Section{0.78, 0.176, 0.168, 2.2},
        Section{0.92, 0.155, 0.155, 2.0}};
    std::vector<std::vector<Vec3>> rings;
    for (const Section& s : kSections) {
        std::vector<Vec3> ring;
        constexpr int kSides = 28;
        for (int i = 0; i < kSides; ++i) {
            const double angle = kTau * (i + 0.5) / kSides;
            const auto bent = [&s](double v) {
                return std::copysign(std::pow(std::abs(v), 2.0 / s.square), v);
            };
            ring.emplace_back(s.x, s.high * bent(std::sin(angle)), s.half * bent(std::cos(angle)));
        }
        rings.push_back(ring);
    }
    mantlet.append(skinned(rings, Material::kPaint));
    // Coaxial machine gun on the right, the gunner's sight on the left, both hooded.
    mantlet.append(
        turnedOnLathe({{0.20, 0.050}, {0.365, 0.046}, {0.375, 0.030}, {0.33, 0.028}, {0.33, 0.0}},
                      {Axis::kX, 12, 0.005}),
        moved({0, 0.02, 0.285}));
    mantlet.append(
        turnedOnLathe({{0.30, 0.0}, {0.30, 0.014}, {0.43, 0.014}, {0.43, 0.008}, {0.36, 0.0}},
                      {Axis::kX, 8, 0.002, false, Material::kSteel}),
        moved({0, 0.02, 0.285}));
    mantlet.append(
        bevelled(prism({{0.20, 0.035}, {0.385, 0.035}, {0.385, 0.11}, {0.36, 0.128}, {0.20, 0.128}},
                       -0.335, -0.235),
                 0.008, Material::kPaint));
    mantlet.append(
        bevelled(box({0.375, 0.050, -0.318}, {0.388, 0.100, -0.252}), 0.002, Material::kGlass));
    return mantlet;
}

Solid makeBarrel() {
    constexpr double kEnd = kBrakeStart + 0.10;
    Solid barrel = turnedOnLathe({{0.86, 0.150},
                                  {0.90, 0.170},
                                  {0.975, 0.170},
                                  {0.985, 0.124},
                                  {1.60, 0.115},
                                  {1.605, 0.123},
                                  {1.66, 0.123},
                                  {1.665, 0.108},
                                  {2.68, 0.096},
                                  {2.76, 0.126},
                                  {3.30, 0.126},
                                  {3.38, 0.092},
                                  {kEnd, 0.078},
                                  {kEnd, kBore},
                                  {kBrakeStart - 0.5, kBore},
                                  {kBrakeStart - 0.5, 0.0}},
                                 {Axis::kX, 22, 0.005});
    return barrel;
}

/// Two chambers that are open to the sides: rings, joined above and below.
Solid makeMuzzleBrake() {
    Solid brake;
    const auto ring = [&brake](double from, double to, double a, double b, double hole) {
        brake.append(turnedOnLathe({{from, a}, {to, b}, {to, hole}, {from, hole}},
                                   {Axis::kX, 18, 0.007, true, Material::kPaint}));
    };
    ring(kBrakeStart, kBrakeStart + 0.13, 0.098, 0.118, 0.070);
    ring(kBrakeStart + 0.255, kBrakeStart + 0.315, 0.122, 0.122, kBore + 0.004);
    ring(kMuzzle - 0.09, kMuzzle, 0.122, 0.106, kBore + 0.004);
    constexpr double kReach = 0.85;  // radians to both sides of the top
    std::vector<Vec2> web;
    for (int i = -4; i <= 4; ++i)
        web.emplace_back(0.114 * std::sin(kReach * i / 4), 0.114 * std::cos(kReach * i / 4));
    for (int i = 4; i >= -4; i -= 2)
        web.emplace_back(0.066 * std::sin(kReach * i / 4), 0.066 * std::cos(kReach * i / 4));
    const Solid bar =
        bevelled(prism(web, kBrakeStart + 0.05, kMuzzle - 0.03), 0.006, Material::kPaint);
    for (const double turn : {0.0, 180.0})
        brake.append(bar, turned({turn, 0, 0}) * turned({0, 90, 0}));
    return brake;
}

}  // namespace

Assembly makeGun() {
    Assembly gun{"gun", kTurretInHull + kGunInTurret, {}, {}};
    gun.add(makeMantlet(), {Mat4(1.0)}, 1.0, Finish::kCast);
    Solid barrel = makeBarrel();
    barrel.append(makeMuzzleBrake());
    gun.add(barrel);
    std::vector<Mat4> bolts;
    for (int i = 0; i < 10; ++i) {
        const double angle = kTau * (i + 0.5) / 10.0;
        bolts.push_back(standing({0.94, 0.168 * std::cos(angle), 0.168 * std::sin(angle)},
                                 {0, std::cos(angle), std::sin(angle)}));
    }
    gun.add(hexBolt(0.016, 0.016, Material::kSteel), bolts, 0.8);
    std::vector<Mat4> eyes;
    for (const double z : {0.20, -0.20}) eyes.push_back(standing({0.36, 0.222, z}, {0.05, 1, 0}));
    gun.add(handle(0.08, 0.05, 0.012, Material::kPaint), eyes, 0.8);

    Marks& marks = gun.marks;
    std::vector<Vec3> seam;
    for (int i = 0; i <= 32; ++i) {
        const double angle = kTau * i / 32;
        const auto bent = [](double v) {
            return std::copysign(std::pow(std::abs(v), 2.0 / 3.8), v);
        };
        seam.emplace_back(0.42, 0.215 * bent(std::sin(angle)), 0.325 * bent(std::cos(angle)));
    }
    marks.line(MarkKind::kWeld, seam, 0.012);
    return gun;
}

}  // namespace vitrine::tank
