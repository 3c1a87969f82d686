// SPDX-License-Identifier: MIT
#include "models/tank/stowage.hpp"

#include <cmath>

#include "models/tank/polyhedron.hpp"
#include "models/tank/round.hpp"

namespace vitrine::tank {
namespace {

Lathe on(Axis axis, int segments, double bevel, Material material = Material::kPaint) {
    return {axis, segments, bevel, false, material};
}

}  // namespace

Solid makeBin(const Vec3& size) {
    const Vec3 h = 0.5 * size;
    const double seam = 0.80 * size.y;
    Solid bin = bevelled(box({-h.x, 0, -h.z}, {h.x, seam, h.z}), 0.008, Material::kPaint);
    bin.append(
        bevelled(box({-h.x - 0.008, seam - 0.02, -h.z - 0.008}, {h.x + 0.008, size.y, h.z + 0.008}),
                 0.014, Material::kPaint));
    const Solid latch = bevelled(box({-0.022, seam - 0.075, 0}, {0.022, seam + 0.012, 0.018}), 0.0,
                                 Material::kSteel);
    for (const double x : {-0.6, 0.6}) bin.append(latch, moved({x * h.x, 0, h.z}));
    for (const double side : {-1.0, 1.0})
        bin.append(handle(0.10, 0.035, 0.007, Material::kSteel),
                   standing({side * h.x, 0.55 * seam, 0}, {side, 0, 0}, {0, 0, 1}));
    return bin;
}

Solid makeJerryCan() {
    constexpr double kL = 0.172, kH = 0.44, kW = 0.082;
    const std::vector<Vec2> outline{{-kL, 0}, {kL, 0}, {kL, 0.36}, {0.10, kH}, {-kL, kH}};
    Solid can = bevelled(prism(outline, -kW, kW), 0.022, Material::kPaint);
    // The pressed cross on both sides.
    for (const double turn : {38.0, -38.0})
        can.append(bevelled(box({-0.19, -0.016, -kW - 0.006}, {0.19, 0.016, kW + 0.006}), 0.0,
                            Material::kPaint),
                   moved({0, 0.205, 0}) * turned({0, 0, turn}));
    for (const double z : {-0.04, 0.04})
        can.append(bentTube({{-0.13, kH - 0.01, z},
                             {-0.12, kH + 0.035, z},
                             {0.05, kH + 0.035, z},
                             {0.06, kH - 0.01, z}},
                            {0.009, 4}));
    can.append(turnedOnLathe({{0, 0.035}, {0.055, 0.030}, {0.06, 0}}, on(Axis::kY, 8, 0.0)),
               moved({0.128, 0.385, 0}) * turned({0, 0, -38}));
    return can;
}

Solid makeTarpaulin(double length, double radius) {
    Solid roll;
    // Bunched between its straps and not quite round.
    std::vector<std::vector<Vec3>> rings;
    constexpr int kRings = 11, kSides = 10;
    for (int i = 0; i < kRings; ++i) {
        const double t = double(i) / (kRings - 1);
        const double strap = std::exp(-std::pow((std::abs(t - 0.5) - 0.28) / 0.045, 2.0));
        const double bulge = (i == 0 || i == kRings - 1) ? 0.80 : 1.0 - 0.15 * strap;
        std::vector<Vec3> ring;
        for (int k = 0; k < kSides; ++k) {
            const double angle = kTau * k / kSides;
            const double wobble = 1.0 + 0.05 * std::sin(3.0 * angle + 5.0 * t) +
                                  0.04 * std::sin(17.0 * t + 2.0 * angle);
            const double r = radius * bulge * wobble;
            ring.emplace_back(length * (t - 0.5), radius + r * std::cos(angle),
                              r * std::sin(angle));
        }
        rings.push_back(ring);
    }
    roll.append(skinned(rings, Material::kCanvas));
    for (const double x : {-0.28, 0.28})
        roll.append(turnedOnLathe({{-0.02, 0.86 * radius},
                                   {-0.02, 0.93 * radius},
                                   {0.02, 0.93 * radius},
                                   {0.02, 0.86 * radius}},
                                  on(Axis::kX, 10, 0.0, Material::kRubber)),
                    moved({x * length, radius, 0}));
    return roll;
}

Solid makeShovel() {
    Solid tool =
        bentTube({{-0.52, 0.025, 0}, {0.28, 0.025, 0}}, {0.017, 6, false, Material::kWood});
    tool.append(bentTube({{-0.54, 0.025, -0.06}, {-0.54, 0.025, 0.06}},
                         {0.015, 6, false, Material::kWood}));
    tool.append(
        bentTube({{0.18, 0.025, 0}, {0.32, 0.025, 0}}, {0.022, 6, false, Material::kSteel}));
    const std::vector<Vec2> blade{
        {0.29, -0.10}, {0.50, -0.105}, {0.60, 0.0}, {0.50, 0.105}, {0.29, 0.10}};
    tool.append(bevelled(prism(blade, -0.012, -0.004), 0.004, Material::kSteel),
                turned({90, 0, 0}));
    return tool;
}

Solid makeAxe() {
    Solid tool = bentTube({{-0.42, 0.022, 0.012}, {-0.1, 0.022, -0.006}, {0.36, 0.022, 0}},
                          {0.016, 6, false, Material::kWood});
    const std::vector<Vec2> head{{0.28, -0.06}, {0.35, -0.06}, {0.355, 0.05},
                                 {0.385, 0.14}, {0.24, 0.14},  {0.275, 0.05}};
    tool.append(bevelled(prism(head, -0.038, -0.006), 0.008, Material::kSteel), turned({90, 0, 0}));
    return tool;
}

Solid makeCrowbar() {
    return bentTube({{-0.75, 0.045, 0}, {-0.70, 0.02, 0}, {0.66, 0.02, 0}, {0.74, 0.03, 0}},
                    {0.014, 6, false, Material::kSteel});
}

Solid makeHeadlamp() {
    Solid lamp = bentTube({{0, 0, 0}, {0, 0.08, 0}}, {0.022, 8});
    const Mat4 up = moved({0, 0.15, 0});
    lamp.append(turnedOnLathe({{-0.10, 0.0},
                               {-0.085, 0.05},
                               {-0.03, 0.085},
                               {0.05, 0.095},
                               {0.062, 0.095},
                               {0.062, 0.080},
                               {0.045, 0.078}},
                              on(Axis::kX, 12, 0.004)),
                up);
    lamp.append(turnedOnLathe({{0.045, 0.079}, {0.058, 0.04}, {0.062, 0.0}},
                              on(Axis::kX, 12, 0.0, Material::kLamp)),
                up);
    // The cage: two hoops over the lamp and a bar that joins them.
    for (const double z : {-0.075, 0.075})
        lamp.append(bentTube(
            rounded({{0.13, -0.10, z}, {0.13, 0.29, z}, {-0.13, 0.29, z}, {-0.15, 0.06, z}}, 0.07,
                    2),
            {0.009, 4}));
    lamp.append(bentTube(
        rounded(
            {{0.13, -0.10, -0.12}, {0.13, 0.20, -0.12}, {0.13, 0.20, 0.12}, {0.13, -0.10, 0.12}},
            0.07, 2),
        {0.009, 4}));
    return lamp;
}

Solid makeTowHook() {
    Solid hook = softBar({-0.09, -0.004, -0.075}, {0.09, 0.022, 0.075}, 0.007, Material::kPaint);
    hook.append(bentTube(rounded({{-0.03, 0.01, 0},
                                  {-0.04, 0.13, 0},
                                  {0.10, 0.16, 0},
                                  {0.12, 0.06, 0},
                                  {0.045, 0.05, 0}},
                                 0.06, 2),
                         {0.025, 6}));
    for (const Vec2& at : {Vec2(-0.06, -0.05), Vec2(-0.06, 0.05)})
        hook.append(rivet(0.013, Material::kSteel), moved({at.x, 0.022, at.y}));
    return hook;
}

Solid makePeriscope() {
    const std::vector<Vec2> outline{
        {-0.055, 0}, {0.06, 0}, {0.06, 0.03}, {0.04, 0.085}, {-0.04, 0.085}};
    Solid block = softBar(outline, -0.095, 0.095, 0.010, Material::kPaint);
    // The window lies two millimetres over the slanted front.
    const Vec3 out = glm::normalize(Vec3(0.055, 0.02, 0));
    block.append(bevelled(box({-0.075, 0, -0.022}, {0.075, 0.004, 0.022}), 0.0, Material::kGlass),
                 standing(Vec3(0.05, 0.0575, 0) - 0.002 * out, out, {0, 0, 1}));
    return block;
}

Solid makeHatch(double radius) {
    Solid hatch = turnedOnLathe({{-0.06, radius + 0.045},
                                 {0.014, radius + 0.035},
                                 {0.014, radius + 0.006},
                                 {0.004, radius + 0.004},
                                 {0.004, radius - 0.004},
                                 {0.042, radius - 0.004},
                                 {0.058, 0.55 * radius},
                                 {0.062, 0.0}},
                                on(Axis::kY, 22, 0.007));
    hatch.append(handle(0.15, 0.05, 0.010, Material::kSteel),
                 moved({0.45 * radius, 0.055, 0}) * turned({0, 90, 0}));
    for (const double z : {-0.075, 0.075})
        hatch.append(bevelled(prism({{-radius - 0.08, -0.01},
                                     {-radius + 0.14, 0.035},
                                     {-radius + 0.14, 0.072},
                                     {-radius - 0.04, 0.075},
                                     {-radius - 0.10, 0.04}},
                                    z - 0.018, z + 0.018),
                              0.0, Material::kPaint));
    hatch.append(bentTube({{-radius - 0.06, 0.038, -0.13}, {-radius - 0.06, 0.038, 0.13}},
                          {0.022, 7, false, Material::kSteel}));
    return hatch;
}

}  // namespace vitrine::tank
