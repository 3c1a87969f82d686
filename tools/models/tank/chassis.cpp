// SPDX-License-Identifier: MIT
#include "models/tank/chassis.hpp"

#include <cmath>

#include "models/tank/layout.hpp"
#include "models/tank/polyhedron.hpp"
#include "models/tank/round.hpp"
#include "models/tank/track.hpp"
#include "models/tank/wheels.hpp"

namespace vitrine::tank {
namespace {

/// Rolls to +x on the right side and on the left; a wheel looks outwards on both.
std::vector<Mat4> wheelPlaces(const Vec2& at, double rolled, double sideZ = kTrackZ) {
    const auto spin = [rolled](double sign) {
        return glm::rotate(Mat4(1.0), sign * rolled, Vec3(0, 0, 1));
    };
    return {moved({at.x, at.y, sideZ}) * spin(1.0),
            moved({at.x, at.y, -sideZ}) * turned({0, 180, 0}) * spin(-1.0)};
}

void addWheels(Assembly& chassis, double drive) {
    std::vector<Mat4> road, rollers;
    // Not all valves and bolts of a real tank point the same way.
    double parked = 0.0;
    for (const double x : kWheelX)
        for (const Mat4& m : wheelPlaces({x, kWheelY}, (parked += 1.3) - drive / kWheelRadius))
            road.push_back(m);
    for (const double x : kRollerX)
        for (const Mat4& m : wheelPlaces({x, kRollerY}, (parked += 0.7) - drive / kRollerRadius))
            rollers.push_back(m);
    chassis.add(makeRoadWheel(), road, 2.0, Finish::kRolls);
    chassis.add(makeReturnRoller(), rollers, 1.2, Finish::kRolls);
    chassis.add(makeIdler(), wheelPlaces(kIdlerAt, -drive / kIdlerRadius), 1.5, Finish::kRolls);
    // Sprocket and pins keep step; on the left the tooth is mirrored.
    const double angle = sprocketAngle(trackPins(drive));
    const std::vector<Mat4> right = wheelPlaces(kSprocketAt, angle);
    const std::vector<Mat4> left = wheelPlaces(kSprocketAt, kTau / 2.0 + angle);
    chassis.add(makeSprocket(), {right[0], left[1]}, 1.5, Finish::kRolls);
}

/// The swing arm of a road wheel: from its bearing at the origin back to the axle.
Solid makeArm() {
    constexpr double kReach = 0.34, kDrop = -0.155;
    Solid arm;
    const Vec2 axle{-kReach, kDrop}, along = glm::normalize(axle), across(-along.y, along.x);
    arm.append(
        bevelled(prism({0.085 * across - 0.05 * along, axle + 0.060 * across + 0.03 * along,
                        axle - 0.060 * across + 0.03 * along, -0.085 * across - 0.05 * along},
                       0.06, 0.125),
                 0.010, Material::kPaint));
    const auto hub = [&](const Vec2& at, double radius, double low, double high) {
        arm.append(turnedOnLathe({{low, radius}, {high, radius}, {high + 0.012, 0.0}},
                                 {Axis::kZ, 10, 0.0, false, Material::kPaint}),
                   moved({at.x, at.y, 0}));
    };
    hub({0, 0}, 0.105, -0.05, 0.13);
    hub(axle, 0.070, 0.05, 0.20);
    return arm;
}

void addSuspension(Assembly& chassis) {
    constexpr Vec2 kBearing{0.34, 0.155};
    std::vector<Mat4> arms, stops, dampers, brackets;
    for (const double side : {1.0, -1.0}) {
        const Mat4 mirror = glm::scale(Mat4(1.0), Vec3(1, 1, side));
        for (size_t i = 0; i < kWheelX.size(); ++i) {
            const Vec2 at = Vec2(kWheelX[i], kWheelY) + kBearing;
            arms.push_back(mirror * moved({at.x, at.y, kTubHalfWidth}));
            if (i == 0 || i == 1 || i == 5)
                dampers.push_back(mirror * moved({kWheelX[i] + 0.04, kWheelY, 0}));
            stops.push_back(mirror * moved({kWheelX[i] + 0.02, 0.83, kTubHalfWidth}));
        }
        for (const double x : kRollerX)
            brackets.push_back(mirror * moved({x, kRollerY, kTubHalfWidth}));
    }
    chassis.add(makeArm(), arms, 0.8);
    Solid damper = bentTube({{0.02, 0.04, 1.02}, {0.13, 0.30, 1.02}}, {0.040, 7});
    damper.append(
        bentTube({{0.10, 0.23, 1.02}, {0.17, 0.40, 1.02}}, {0.024, 6, false, Material::kSteel}));
    chassis.add(damper, dampers, 0.6);
    chassis.add(softBar({{-0.07, 0.05}, {0.07, 0.05}, {0.035, -0.06}, {-0.035, -0.06}}, -0.02, 0.09,
                        0.01, Material::kPaint),
                stops, 0.6);
    chassis.add(turnedOnLathe({{-0.02, 0.10}, {0.02, 0.095}, {0.05, 0.06}, {0.20, 0.055}},
                              {Axis::kZ, 10, 0.0, false, Material::kPaint}),
                brackets, 0.6);
}

/// The armoured box between the tracks.
void addTub(Assembly& chassis) {
    constexpr double kW = kTubHalfWidth;
    const double slope = glm::radians(kGlacisDegrees);
    // The glacis of the hull lies over this one; six millimetres keep them apart.
    const Vec3 nose{kNoseX - 0.006, kNoseY, 0};
    const Polyhedron tub =
        convex({Plane::at({0, kBelly, 0}, {0, -1, 0}), Plane::at({0, 1.30, 0}, {0, 1, 0}),
                Plane::at(nose, {std::sin(slope), std::cos(slope), 0}),
                Plane::at(nose, {std::cos(0.72), -std::sin(0.72), 0}),
                Plane::at({kRearX + 0.10, 0.9, 0}, {-1, -0.16, 0}),
                Plane::at({-2.72, kBelly, 0}, {-0.66, -0.75, 0}),
                Plane::at({0, 0.8, kW}, {0, 0, 1}), Plane::at({0, 0.8, -kW}, {0, 0, -1})});
    Solid body = bevelled(tub, 0.016, Material::kPaint);
    // Final drives carry the sprockets, adjusters the idlers.
    body.appendBothSides(
        turnedOnLathe({{0.90, 0.0}, {0.90, 0.24}, {1.04, 0.235}, {1.075, 0.17}, {1.12, 0.16}},
                      {Axis::kZ, 18, 0.010}),
        moved({kSprocketAt.x, kSprocketAt.y, 0}));
    body.appendBothSides(
        turnedOnLathe({{0.90, 0.0}, {0.90, 0.15}, {1.02, 0.14}, {1.05, 0.09}, {1.28, 0.085}},
                      {Axis::kZ, 12, 0.0}),
        moved({kIdlerAt.x, kIdlerAt.y, 0}));
    // Bump-stop rail along the side, and hatches in the lower front for the looks of a workshop.
    body.appendBothSides(softBar({-2.55, 1.06, 0.95}, {2.55, 1.10, 1.02}, 0.008, Material::kPaint));
    chassis.add(body, {Mat4(1.0)}, 0.62);

    const double front = 0.72;  // radians of the lower plate
    const Vec3 down(-std::sin(front), -std::cos(front), 0),
        out(std::cos(front), -std::sin(front), 0);
    const auto onLowerFront = [&](double along, double z) {
        return nose + along * down + Vec3(0, 0, z);
    };
    std::vector<Mat4> bolts;
    for (int i = 0; i < 7; ++i)
        bolts.push_back(standing(onLowerFront(0.10, -0.78 + 0.26 * i), out, down));
    for (const double side : {1.0, -1.0})
        for (int i = 0; i < 6; ++i) {
            const double angle = kTau * i / 6.0;
            bolts.push_back(standing({kSprocketAt.x + 0.205 * std::cos(angle),
                                      kSprocketAt.y + 0.205 * std::sin(angle), side * 1.052},
                                     {0, 0, side}));
        }
    chassis.add(rivet(0.020, Material::kSteel), bolts, 0.8);

    Marks& marks = chassis.marks;
    marks.line(MarkKind::kWeld, {onLowerFront(0.02, -kW), onLowerFront(0.02, kW)}, 0.014);
    marks.line(MarkKind::kGroove, {onLowerFront(0.27, -kW), onLowerFront(0.27, kW)}, 0.008);
    for (const double x : {-1.8, -0.9, 0.0, 0.9, 1.8})
        marks.line(MarkKind::kGroove, {{x, kBelly, kW}, {x, 1.05, kW}}, 0.006, true);
    marks.rivets({-2.4, 0.50, kW}, {2.2, 0.50, kW}, 0.16, 0.013, true);
}

}  // namespace

Assembly makeChassis(double drive) {
    Assembly chassis{"chassis", Vec3(0.0), {}, {}};
    addTub(chassis);
    addSuspension(chassis);
    addWheels(chassis, drive);
    const std::vector<Vec2> pins = trackPins(drive);
    std::vector<Mat4> links = linkPlaces(pins, 1.0);
    for (const Mat4& m : linkPlaces(pins, -1.0)) links.push_back(m);
    chassis.add(makeLink(), links, 2.6, Finish::kRolls);
    return chassis;
}

}  // namespace vitrine::tank
