// SPDX-License-Identifier: MIT
// Armour and fenders.
#include "models/tank/hull.hpp"

#include <cmath>

#include "models/tank/layout.hpp"
#include "models/tank/polyhedron.hpp"
#include "models/tank/round.hpp"

namespace vitrine::tank {
namespace {

const double kSlope = glm::radians(kGlacisDegrees);
constexpr double kSideLowZ = 1.37, kSideHighZ = 1.16;

double glacisTopX() {
    return kNoseX - (kRoofY - kNoseY) / std::tan(kSlope);
}

Polyhedron armour() {
    std::vector<Plane> planes{
        Plane::at({0, kRoofY, 0}, {0, 1, 0}), Plane::at({0, kFenderY - 0.015, 0}, {0, -1, 0}),
        Plane::at({kNoseX, kNoseY, 0}, glacisOut()), Plane::at({-1.35, kRoofY, 0}, {-0.050, 1, 0}),
        Plane::at({kRearX, 1.25, 0}, {-1, 0.30, 0})};
    for (const double side : {1.0, -1.0}) {
        planes.push_back(Plane::at({0, kFenderY, side * kSideLowZ},
                                   {0, kSideLowZ - kSideHighZ, side * (kRoofY - kFenderY)}));
        planes.push_back(Plane::at({2.30, 1.40, side * 1.22}, {0.80, 0.36, side * 0.90}));
        planes.push_back(Plane::at({-2.78, 1.40, side * 1.24}, {-0.75, 0.30, side * 0.85}));
    }
    return convex(planes);
}

/// Sheet metal along a path in x and y: `thickness` is added below.
Polyhedron sheet(const std::vector<Vec2>& path, double thickness, double low, double high) {
    std::vector<Vec2> outline = path;
    for (size_t i = path.size(); i-- > 0;) {
        const Vec2 d =
            glm::normalize(path[std::min(i + 1, path.size() - 1)] - path[i > 0 ? i - 1 : 0]);
        outline.push_back(path[i] + thickness * Vec2(d.y, -d.x));
    }
    return prism(outline, low, high);
}

void addFenders(Assembly& hull) {
    constexpr double kTop = kFenderY + 0.012, kInner = 0.985;
    Solid fenders;
    const auto add = [&fenders](const Polyhedron& body, double bevel, Material material) {
        fenders.append(bevelled(body, bevel, material));
    };
    add(box({-2.80, kTop - 0.012, kInner}, {2.78, kTop, kFenderZ}), 0.004, Material::kPaint);
    // Front and rear wings lap over the middle by their own thickness.
    const std::vector<Vec2> front{{2.70, kTop + 0.008},
                                  {3.16, kTop + 0.008},
                                  {3.31, kTop - 0.03},
                                  {3.405, kTop - 0.12},
                                  {3.435, kTop - 0.24}};
    const std::vector<Vec2> rear{{-3.425, kTop - 0.24},
                                 {-3.40, kTop - 0.12},
                                 {-3.31, kTop - 0.03},
                                 {-3.18, kTop + 0.008},
                                 {-2.72, kTop + 0.008}};
    add(sheet(front, 0.012, kInner, kFenderZ + 0.006), 0.004, Material::kPaint);
    add(sheet(rear, 0.012, kInner, kFenderZ + 0.006), 0.004, Material::kPaint);
    add(box({3.418, 0.60, 1.02}, {3.432, 0.985, 1.66}), 0.0, Material::kRubber);
    add(box({-3.424, 0.64, 1.02}, {-3.410, 0.985, 1.66}), 0.0, Material::kRubber);
    // Strips that hold the mud flaps, the rolled outer edge, and stiffening pressings.
    add(box({3.430, 0.955, 1.00}, {3.446, 0.995, 1.68}), 0.0, Material::kPaint);
    add(box({-3.438, 0.955, 1.00}, {-3.422, 0.995, 1.68}), 0.0, Material::kPaint);
    add(box({-2.70, kTop - 0.075, kFenderZ - 0.006}, {2.68, kTop + 0.006, kFenderZ + 0.008}), 0.004,
        Material::kPaint);
    for (const double z : {1.14, 1.34, 1.54})
        fenders.append(
            softBar({{2.84, kTop}, {2.90, kTop + 0.020}, {3.08, kTop + 0.020}, {3.14, kTop}},
                    z - 0.022, z + 0.022, 0.01, Material::kPaint));
    for (const double x : {-2.1, -0.7, 0.75, 2.15})
        add(prism({{x - 0.01, kTop - 0.004},
                   {x + 0.01, kTop - 0.004},
                   {x + 0.01, kTop + 0.05},
                   {x - 0.01, kTop + 0.05}},
                  1.30, 1.44),
            0.0, Material::kPaint);
    Solid both;
    both.appendBothSides(fenders);
    hull.add(both, {Mat4(1.0)}, 0.85);

    hull.marks.rivets({-2.65, kTop - 0.04, kFenderZ + 0.008}, {2.63, kTop - 0.04, kFenderZ + 0.008},
                      0.22, 0.014, true);
    for (const double x : {3.446, -3.438})
        hull.marks.rivets({x, 0.975, 1.05}, {x, 0.975, 1.63}, 0.10, 0.014, true);
}

void addArmour(Assembly& hull) {
    Solid body = bevelled(armour(), 0.018, Material::kPaint);
    // The collar protects the joint of the turret from splinters.
    const Solid collar =
        turnedOnLathe({{-0.01, 1.10}, {0.022, 1.075}, {0.030, 1.045}, {0.030, 0.90}},
                      {Axis::kY, 48, 0.006, false, Material::kPaint});
    hull.add(body);
    hull.add(collar, {moved(kTurretInHull)}, 0.6);

    const double top = glacisTopX();
    Marks& marks = hull.marks;
    marks.line(MarkKind::kWeld, {{top, kRoofY, -1.0}, {top, kRoofY, 1.0}}, 0.016);
    marks.line(MarkKind::kWeld, {{top - 0.35, kRoofY, 1.15}, {-1.3, kRoofY, 1.15}}, 0.016, true);
    marks.line(MarkKind::kWeld, {{2.86, kFenderY + 0.02, -0.97}, {2.86, kFenderY + 0.02, 0.97}},
               0.018);
    marks.line(MarkKind::kGroove, {{1.28, kRoofY, -1.2}, {1.28, kRoofY, 1.2}}, 0.007);
    marks.line(MarkKind::kGroove, {{-0.98, kRoofY, -1.2}, {-0.98, kRoofY, 1.2}}, 0.008);
    for (const double x : {1.45, 0.2, -1.2})
        marks.line(MarkKind::kGroove, {{x, kFenderY, kSideLowZ}, {x, kRoofY, kSideHighZ}}, 0.006,
                   true);
    marks.rivets({1.24, kRoofY, -1.05}, {1.24, kRoofY, 1.05}, 0.14, 0.014, false);
    marks.rivets({-0.94, kRoofY, -1.05}, {-0.94, kRoofY, 1.05}, 0.14, 0.014, false);
}

}  // namespace

Vec3 glacisOut() {
    return {std::sin(kSlope), std::cos(kSlope), 0};
}

Vec3 glacisDown() {
    return {std::cos(kSlope), -std::sin(kSlope), 0};
}

Vec3 onGlacis(double down, double z) {
    return Vec3(glacisTopX(), kRoofY, z) + down * glacisDown();
}

Assembly makeHull() {
    Assembly hull{"hull", Vec3(0.0), {}, {}};
    addArmour(hull);
    addFenders(hull);
    addEngineDeck(hull);
    addHullFittings(hull);
    addHullStowage(hull);
    return hull;
}

}  // namespace vitrine::tank
