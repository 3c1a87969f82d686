// SPDX-License-Identifier: MIT
#include "models/tank/track.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "models/tank/layout.hpp"

namespace vitrine::tank {
namespace {

TEST(Track, PinsAreEquallyFarApartWhereverTheTankIs) {
    for (const double drive : {0.0, 0.04, 0.1, 3.777, -2.2}) {
        const std::vector<Vec2> pins = trackPins(drive);
        ASSERT_GT(pins.size(), 70u);
        double least = 1e9, most = 0.0;
        for (size_t i = 0; i < pins.size(); ++i) {
            const double pitch = glm::distance(pins[i], pins[(i + 1) % pins.size()]);
            least = std::min(least, pitch);
            most = std::max(most, pitch);
        }
        EXPECT_LT(most / least, 1.001) << drive;
        EXPECT_NEAR(least, kPitch, 0.01 * kPitch) << drive;
    }
}

TEST(Track, LiesFlatOnTheGroundAndHangsBetweenTheRollers) {
    int onGround = 0;
    double lowest = 10.0, highest = 0.0;
    for (const Vec2& pin : trackPins(0.0)) {
        EXPECT_GE(pin.y, kLinkOutside - 1e-6);
        if (pin.x < kWheelX.front() && pin.x > kWheelX.back() && pin.y < 0.5) {
            EXPECT_NEAR(pin.y, kLinkOutside, 1e-6);
            ++onGround;
        }
        if (pin.y > 0.8 && pin.x > kRollerX[1] && pin.x < kRollerX[0]) {
            lowest = std::min(lowest, pin.y);
            highest = std::max(highest, pin.y);
        }
    }
    EXPECT_GT(onGround, 20);
    EXPECT_NEAR(highest - lowest, kSag, 0.02);
}

TEST(Track, LinksOnTheGroundStandStillWhileTheTankDrives) {
    const auto nearest = [](const std::vector<Vec2>& pins, const Vec2& p) {
        double least = 1e9;
        for (const Vec2& pin : pins) least = std::min(least, glm::distance(pin, p));
        return least;
    };
    constexpr double kDrive = 0.05;
    const std::vector<Vec2> before = trackPins(0.0), after = trackPins(kDrive);
    for (const Vec2& pin : before)
        if (std::abs(pin.x) < 1.5 && pin.y < 0.5) {
            EXPECT_LT(nearest(after, pin - Vec2(kDrive, 0)), 0.002);
        }
}

TEST(Track, NoPinCutsIntoAWheel) {
    for (const Vec2& pin : trackPins(0.02)) {
        for (const double x : kWheelX)
            EXPECT_GT(glm::distance(pin, Vec2(x, kWheelY)), kWheelRadius + kLinkInside - 0.002);
        for (const double x : kRollerX)
            EXPECT_GT(glm::distance(pin, Vec2(x, kRollerY)), kRollerRadius + kLinkInside - 0.002);
    }
}

TEST(Track, TeethStandBetweenPins) {
    const std::vector<Vec2> pins = trackPins(0.03);
    const double angle = sprocketAngle(pins), step = kTau / kSprocketTeeth;
    for (const Vec2& pin : pins) {
        const Vec2 d = pin - kSprocketAt;
        if (pin.x > kSprocketAt.x || glm::length(d) > kSprocketRadius + 0.002) continue;
        const double turns = (std::atan2(d.y, d.x) - angle) / step;
        EXPECT_NEAR(turns - std::floor(turns), 0.5, 0.06);
    }
}

}  // namespace
}  // namespace vitrine::tank
