// SPDX-License-Identifier: MIT
// Boxes, tools, cable and cans along the fenders.
#include "models/tank/hull.hpp"
#include "models/tank/layout.hpp"
#include "models/tank/polyhedron.hpp"
#include "models/tank/round.hpp"
#include "models/tank/stowage.hpp"

namespace vitrine::tank {
namespace {

constexpr double kLedgeY = kFenderY + 0.012, kLedgeZ = 1.525;

/// Lies on the sloping side of the hull; `along` the tank, `up` the slope from the fender.
Mat4 onSide(double x, double up, double side) {
    const Vec3 slope = glm::normalize(Vec3(0, 0.455, -0.21 * side));
    const Vec3 out = glm::normalize(Vec3(0, 0.21, 0.455 * side));
    return standing(Vec3(x, kFenderY, side * 1.37) + up * slope, out, {1, 0, 0});
}

void addBins(Assembly& hull) {
    const Mat4 left = turned({0, 180, 0});
    hull.add(makeBin({0.95, 0.27, 0.27}),
             {moved({1.50, kLedgeY, kLedgeZ}), moved({-1.62, kLedgeY, kLedgeZ}),
              moved({-0.02, kLedgeY, -kLedgeZ}) * left},
             1.35);
    hull.add(makeBin({0.62, 0.23, 0.27}),
             {moved({-2.50, kLedgeY, kLedgeZ}), moved({-2.40, kLedgeY, -kLedgeZ}) * left,
              moved({1.72, kLedgeY, -kLedgeZ}) * left},
             1.3);
    std::vector<Mat4> cans;
    for (int i = 0; i < 3; ++i)
        cans.push_back(moved({-0.92 - 0.19 * i, kLedgeY, -1.53}) * turned({0, 90, 0}));
    for (int i = 0; i < 2; ++i)
        cans.push_back(moved({-0.38 + 0.19 * i, kLedgeY, 1.53}) * turned({0, -90, 0}));
    hull.add(makeJerryCan(), cans, 1.0);
    // Straps around the cans.
    Solid strap;
    strap.append(bentTube(rounded({{-1.42, kLedgeY + 0.2, -1.35},
                                   {-1.42, kLedgeY + 0.2, -1.715},
                                   {-0.80, kLedgeY + 0.2, -1.715},
                                   {-0.80, kLedgeY + 0.2, -1.35}},
                                  0.03, 2),
                          {0.008, 4, false, Material::kRubber}));
    strap.append(bentTube(rounded({{-0.50, kLedgeY + 0.2, 1.35},
                                   {-0.50, kLedgeY + 0.2, 1.715},
                                   {-0.07, kLedgeY + 0.2, 1.715},
                                   {-0.07, kLedgeY + 0.2, 1.35}},
                                  0.03, 2),
                          {0.008, 4, false, Material::kRubber}));
    hull.add(strap, {Mat4(1.0)}, 0.6);
}

void addTools(Assembly& hull) {
    hull.add(makeShovel(), {moved({0.45, kLedgeY + 0.012, 1.58}), onSide(-2.05, 0.30, -1.0)});
    hull.add(makeAxe(), {moved({0.42, kLedgeY + 0.010, 1.44}) * turned({0, 180, 0})});
    hull.add(makeCrowbar(), {onSide(-0.45, 0.34, 1.0)});
    std::vector<Mat4> clamps;
    for (const double x : {0.12, 0.68}) clamps.push_back(moved({x, kLedgeY, 1.58}));
    for (const double x : {0.2, 0.62}) clamps.push_back(moved({x, kLedgeY, 1.44}));
    for (const double x : {-1.0, 0.08}) clamps.push_back(onSide(x, 0.34, 1.0));
    for (const double x : {-2.4, -1.85}) clamps.push_back(onSide(x, 0.30, -1.0));
    hull.add(softBar({-0.018, -0.005, -0.03}, {0.018, 0.058, 0.03}, 0.006, Material::kPaint),
             clamps, 0.7);
}

/// The tow cable lies along the left side, looped back, both eyes in front.
void addCable(Assembly& hull) {
    const auto at = [](double x, double up) {
        return Vec3(onSide(x, up, -1.0) * glm::dvec4(0, 0.024, 0, 1));
    };
    const std::vector<Vec3> path{at(2.02, 0.36),   at(1.2, 0.39),   at(0.4, 0.37),
                                 at(-0.5, 0.395),  at(-1.25, 0.38), at(-1.62, 0.31),
                                 at(-1.25, 0.235), at(-0.4, 0.26),  at(0.5, 0.235),
                                 at(1.35, 0.255),  at(2.10, 0.22)};
    Solid cable = bentTube(rounded(path, 0.16, 2), {0.017, 5, false, Material::kSteel});
    for (const Vec3& end : {path.front(), path.back()}) {
        const Mat4 frame = onSide(0, 0, -1.0);
        const Vec3 out(frame[1]);
        std::vector<Vec3> eye;
        for (int i = 0; i < 8; ++i) {
            const double angle = kTau * i / 8.0;
            eye.push_back(end + Vec3(0.05 + 0.05 * std::cos(angle), 0, 0) +
                          0.05 * std::sin(angle) * glm::cross(out, Vec3(1, 0, 0)));
        }
        cable.append(bentTube(eye, {0.015, 5, true, Material::kSteel}));
        cable.append(bentTube({end - Vec3(0.10, 0, 0), end + Vec3(0.01, 0, 0)},
                              {0.024, 7, false, Material::kSteel}));
    }
    hull.add(cable, {Mat4(1.0)}, 0.7);
    std::vector<Mat4> clips;
    for (const double x : {1.6, 0.75, -0.1, -0.95}) {
        clips.push_back(onSide(x, 0.38, -1.0));
        clips.push_back(onSide(x, 0.246, -1.0));
    }
    hull.add(bevelled(box({-0.015, -0.005, -0.036}, {0.015, 0.046, 0.036}), 0.0, Material::kPaint),
             clips, 0.6);
}

}  // namespace

void addHullStowage(Assembly& hull) {
    addBins(hull);
    addTools(hull);
    addCable(hull);
}

}  // namespace vitrine::tank
