// SPDX-License-Identifier: MIT
// Louvres, access doors, filler caps, exhausts, and the crutch for the gun on the march.
#include <cmath>

#include "models/tank/hull.hpp"
#include "models/tank/layout.hpp"
#include "models/tank/polyhedron.hpp"
#include "models/tank/round.hpp"

namespace vitrine::tank {
namespace {

/// The deck falls a little towards the rear.
Vec3 onDeck(double x, double z) {
    return {x, kRoofY + std::min(0.0, 0.050 * (x + 1.35)), z};
}

const Vec3 kDeckUp = glm::normalize(Vec3(-0.050, 1, 0));

Mat4 deckFrame(double x, double z) {
    return standing(onDeck(x, z), kDeckUp);
}

/// A rectangular frame on y = 0, `half` in x and z, its bars `bar` wide.
Solid frameOf(const Vec2& half, double bar, double height) {
    Solid frame;
    for (const double side : {1.0, -1.0}) {
        frame.append(bevelled(box({-half.x, -0.01, side * half.y - 0.5 * bar},
                                  {half.x, height, side * half.y + 0.5 * bar}),
                              0.008, Material::kPaint));
        frame.append(bevelled(box({side * half.x - 0.5 * bar, -0.01, -half.y - 0.5 * bar},
                                  {side * half.x + 0.5 * bar, height + 0.002, half.y + 0.5 * bar}),
                              0.008, Material::kPaint));
    }
    return frame;
}

void addLouvres(Assembly& hull) {
    constexpr Vec2 kHalf{0.37, 0.40};
    constexpr double kX = -2.33, kZ = 0.47;
    std::vector<Mat4> frames, slats;
    for (const double side : {1.0, -1.0}) {
        frames.push_back(deckFrame(kX, side * kZ));
        for (int i = 0; i < 8; ++i)
            slats.push_back(deckFrame(kX, side * kZ) * moved({-0.295 + 0.084 * i, 0, 0}));
    }
    hull.add(frameOf(kHalf, 0.06, 0.062), frames, 0.8);
    const std::vector<Vec2> slat{{-0.050, 0.006}, {-0.040, -0.002}, {0.036, 0.046}, {0.026, 0.054}};
    hull.add(softBar(slat, -kHalf.y, kHalf.y, 0.004, Material::kPaint), slats, 0.8);
}

void addDoors(Assembly& hull) {
    Solid doors;
    std::vector<Mat4> bolts, handles, hinges;
    for (const double side : {1.0, -1.0}) {
        const Mat4 at = deckFrame(-1.44, side * 0.47);
        doors.append(
            bevelled(box({-0.36, -0.01, -0.42}, {0.36, 0.016, 0.42}), 0.008, Material::kPaint), at);
        for (int i = 0; i < 4; ++i)
            for (const double end : {1.0, -1.0})
                bolts.push_back(at * moved({end * 0.325, 0.016, -0.37 + 0.2467 * i}));
        for (const double x : {-0.16, 0.16})
            handles.push_back(at * moved({x, 0.014, -side * 0.30}));
        for (const double x : {-0.22, 0.22}) hinges.push_back(at * moved({x, 0.010, side * 0.43}));
    }
    // The middle strip covers the shaft of the fan.
    doors.append(
        bevelled(box({-0.80, -0.01, -0.035}, {0.80, 0.026, 0.035}), 0.008, Material::kPaint),
        deckFrame(-1.9, 0));
    hull.add(doors);
    hull.add(rivet(0.017, Material::kSteel), bolts, 0.7);
    hull.add(handle(0.13, 0.045, 0.009, Material::kSteel), handles, 0.7);
    hull.add(bentTube({{-0.06, 0.012, 0}, {0.06, 0.012, 0}}, {0.020, 8, false, Material::kPaint}),
             hinges, 0.7);

    const Solid cap = turnedOnLathe({{-0.01, 0.105},
                                     {0.02, 0.10},
                                     {0.028, 0.075},
                                     {0.062, 0.070},
                                     {0.070, 0.045},
                                     {0.070, 0.0}},
                                    {Axis::kY, 12, 0.004, false, Material::kPaint});
    Solid fillers = cap;
    fillers.append(
        bevelled(box({-0.055, 0.06, -0.012}, {0.055, 0.090, 0.012}), 0.0, Material::kPaint));
    hull.add(fillers, {deckFrame(-1.30, 1.02), deckFrame(-1.30, -1.02), deckFrame(-1.90, -1.0)},
             0.8);
}

/// Along the rear plate, behind a shield with slots.
void addExhausts(Assembly& hull) {
    Solid pipe = turnedOnLathe(
        {{-0.10, 0.085}, {0.30, 0.085}, {0.315, 0.080}, {0.315, 0.066}, {0.20, 0.062}, {0.20, 0.0}},
        {Axis::kX, 14, 0.0, false, Material::kSteel});
    pipe.append(turnedOnLathe({{-0.02, 0.05}, {-0.02, 0.13}, {0.03, 0.13}, {0.045, 0.08}},
                              {Axis::kX, 14, 0.006}));
    std::vector<Mat4> places;
    for (const double side : {1.0, -1.0})
        places.push_back(moved({kRearX + 0.03, 1.33, side * 0.62}) *
                         turned({0, 180.0 + side * 8.0, -14}));
    hull.add(pipe, places, 0.9);
}

/// An A of tubes, folded back on the deck, with a ring for the barrel.
void addGunCrutch(Assembly& hull) {
    const Vec3 head = onDeck(-2.72, 0) + Vec3(0, 0.30, 0);
    Solid crutch;
    for (const double z : {0.26, -0.26}) {
        const Vec3 foot = onDeck(-2.86, z);
        crutch.append(bentTube({foot + Vec3(0, 0.03, 0), head + Vec3(0, 0, 0.35 * z)}, {0.022, 7}));
        crutch.append(
            bevelled(box(foot + Vec3(-0.05, -0.02, -0.035), foot + Vec3(0.05, 0.055, 0.035)), 0.008,
                     Material::kPaint));
    }
    const auto hoop = [&head](double from, double to) {
        std::vector<Vec3> path;
        for (int i = 0; i <= 8; ++i) {
            const double angle = from + (to - from) * i / 8.0;
            path.push_back(head +
                           Vec3(0, 0.115 + 0.125 * std::sin(angle), 0.125 * std::cos(angle)));
        }
        return path;
    };
    crutch.append(bentTube(hoop(-0.5 * kTau, 0.0), {0.020, 5}));
    crutch.append(bentTube({head + Vec3(0, 0.115, 0.125), head + Vec3(0, 0.20, 0.17)}, {0.018, 6}));
    crutch.append(bentTube({head + Vec3(0, 0.115, -0.125), head + Vec3(0, 0.15, -0.16)},
                           {0.028, 6, false, Material::kSteel}));
    hull.add(crutch, {Mat4(1.0)}, 0.7);
}

}  // namespace

void addEngineDeck(Assembly& hull) {
    addLouvres(hull);
    addDoors(hull);
    addExhausts(hull);
    addGunCrutch(hull);
}

}  // namespace vitrine::tank
