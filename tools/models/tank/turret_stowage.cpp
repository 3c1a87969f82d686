// SPDX-License-Identifier: MIT
// The basket behind the turret with its load, and boxes on its flanks.
#include <cmath>

#include "models/tank/polyhedron.hpp"
#include "models/tank/round.hpp"
#include "models/tank/stowage.hpp"
#include "models/tank/turret.hpp"

namespace vitrine::tank {
namespace {

constexpr double kRearX = -2.14, kHalf = 0.80, kFloorY = 0.24;

void addBasket(Assembly& turret) {
    Solid basket;
    for (const double y : {kFloorY, 0.40, 0.56}) {
        const std::vector<Vec3> path{
            {-1.12, y, -0.78}, {kRearX, y, -kHalf}, {kRearX, y, kHalf}, {-1.12, y, 0.78}};
        basket.append(bentTube(rounded(path, 0.12, 2), {0.014, 5}));
    }
    for (int i = 0; i < 6; ++i) {
        const double z = -0.65 + 0.26 * i;
        basket.append(
            bentTube({{-1.60, kFloorY, z}, {kRearX, kFloorY, z}, {kRearX, 0.56, z}}, {0.010, 4}));
    }
    for (const double side : {1.0, -1.0})
        basket.append(
            bentTube({{-1.90, kFloorY, side * kHalf}, {-1.90, 0.56, side * kHalf}}, {0.010, 5}));
    for (const double x : {-1.78, -1.94, -2.06})
        basket.append(bentTube({{x, kFloorY, -kHalf}, {x, kFloorY, kHalf}}, {0.008, 4}));
    turret.add(basket, {Mat4(1.0)}, 0.7);
}

void addLoad(Assembly& turret) {
    turret.add(makeTarpaulin(1.05, 0.115),
               {moved({-1.99, kFloorY + 0.012, 0.18}) * turned({0, 86, 0}),
                moved({-1.90, 0.455, 0.10}) * turned({0, 93, 4})},
               0.8);
    turret.add(makeJerryCan(),
               {moved({-1.97, kFloorY + 0.012, -0.52}) * turned({0, 0, 0}),
                moved({-1.97, kFloorY + 0.012, -0.70}) * turned({0, 180, 0})},
               0.9);
    const Mat4 right = moved({-0.86, 0.25, 1.085}) * turned({0, -9, 0});
    turret.add(makeBin({0.62, 0.26, 0.20}),
               {right, moved({-0.86, 0.25, -1.085}) * turned({0, 189, 0})}, 0.9);
}

}  // namespace

void addTurretStowage(Assembly& turret) {
    addBasket(turret);
    addLoad(turret);
}

void addMachineGun(Assembly& turret, const Mat4& pintle) {
    Solid gun = bentTube({{0, 0, 0}, {0, 0.10, 0}}, {0.020, 8, false, Material::kSteel});
    const auto block = [&gun](const Vec3& low, const Vec3& high, double bevel, Material material) {
        gun.append(bevelled(box(low, high), bevel, material));
    };
    block({-0.09, 0.085, -0.045}, {0.09, 0.105, 0.045}, 0.0, Material::kSteel);
    block({-0.28, 0.105, -0.035}, {0.24, 0.205, 0.035}, 0.008, Material::kSteel);
    block({-0.20, 0.200, -0.030}, {0.10, 0.222, 0.030}, 0.0, Material::kSteel);
    block({-0.08, 0.06, -0.185}, {0.20, 0.20, -0.065}, 0.010, Material::kPaint);
    block({-0.02, 0.17, -0.075}, {0.12, 0.195, -0.03}, 0.0, Material::kSteel);
    gun.append(turnedOnLathe({{0.22, 0.0},
                              {0.22, 0.034},
                              {0.52, 0.031},
                              {0.53, 0.018},
                              {1.06, 0.015},
                              {1.07, 0.024},
                              {1.16, 0.020},
                              {1.16, 0.0}},
                             {Axis::kX, 8, 0.0, false, Material::kSteel}),
               moved({0, 0.158, 0}));
    for (const double z : {-0.035, 0.035})
        gun.append(bentTube(
            rounded({{-0.28, 0.185, z}, {-0.37, 0.18, z}, {-0.385, 0.10, z}, {-0.30, 0.12, z}},
                    0.03, 2),
            {0.010, 4, false, Material::kSteel}));
    block({0.40, 0.186, -0.006}, {0.425, 0.225, 0.006}, 0.0, Material::kSteel);
    turret.add(gun, {pintle * turned({0, 0, 5})}, 0.9);
}

}  // namespace vitrine::tank
