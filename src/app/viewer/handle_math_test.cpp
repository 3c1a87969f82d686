// SPDX-License-Identifier: MIT
#include "app/viewer/handle_math.hpp"

#include <gtest/gtest.h>

#include <random>

namespace vitrine {
namespace {

using Kind = Handle::Kind;

/// A parent of each kind that could mislead a hand.
std::vector<glm::mat4> parents() {
    const glm::mat4 one(1);
    const glm::mat4 turned = glm::rotate(glm::translate(one, {1, 2, -1}), 0.7f, {1, 2, 3});
    glm::mat4 sheared = turned;
    sheared[1] += 0.5f * sheared[0];
    return {one,
            turned,
            glm::scale(turned, {-1, 1, 1}),
            glm::scale(turned, {0.3f, 2, 5}),
            glm::scale(turned, glm::vec3(-0.01f)),
            sheared};
}

glm::mat4 parentFromNode(const Place& p) {
    return glm::scale(glm::translate(glm::mat4(1), p.at) * glm::mat4(rotationOf(p.rotate)),
                      p.scale);
}

glm::vec3 apply(const glm::mat4& m, glm::vec3 p) {
    return glm::vec3(m * glm::vec4(p, 1));
}

Sight through(glm::vec3 eye, glm::vec3 point) {
    return {eye, glm::normalize(point - eye)};
}

float distanceTo(const Sight& sight, glm::vec3 point) {
    return glm::length(glm::cross(point - sight.origin, sight.direction));
}

constexpr glm::vec3 kEye(4, 5, 7);
const Place kPlace{{0.4f, -0.3f, 0.2f}, {20, -35, 50}, {1.5f, 0.5f, -2}};

HandleDrag::Setting setting(HandleMode mode, Handle handle, const glm::mat4& worldFromParent) {
    Camera camera;
    camera.eye = kEye;
    camera.target = {0, 0, 0};
    return {mode, handle, kPlace, worldFromParent, 1, 1e-6f, frameOf(camera)};
}

TEST(HandleMath, AnglesGiveTheirRotationBack) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> angle(-400, 400);
    for (int i = 0; i < 2000; ++i) {
        glm::vec3 degrees(angle(random), angle(random), angle(random));
        if (i % 5 == 0) degrees.y = i % 10 == 0 ? 90.0f : -90.0f;  // x and z are one axis
        const glm::vec3 near(angle(random), angle(random), angle(random));
        const glm::vec3 found = anglesOf(rotationOf(degrees), near);
        const glm::mat3 again = rotationOf(found), wanted = rotationOf(degrees);
        for (int c = 0; c < 3; ++c) ASSERT_LT(glm::distance(again[c], wanted[c]), 1e-3f) << i;
        ASSERT_LE(std::abs(found.x - near.x), 181);
        ASSERT_LE(std::abs(found.z - near.z), 181);
    }
    // A little more of the same does not jump to other angles that mean it.
    const glm::vec3 near(170, 80, -30);
    EXPECT_LT(glm::distance(anglesOf(rotationOf(near + 1.0f), near), near + 1.0f), 1e-2f);
}

TEST(HandleMath, AnAxisFollowsTheHandAndChangesOneNumber) {
    for (const glm::mat4& parent : parents()) {
        for (int i = 0; i < 3; ++i) {
            glm::vec3 one(0), two(0);
            one[i] = 0.8f;
            two[i] = 1.7f;
            const glm::vec3 from = apply(parent, kPlace.at + one);
            const glm::vec3 to = apply(parent, kPlace.at + two);
            HandleDrag drag(setting(HandleMode::kMove, {Kind::kAxis, i}, parent),
                            through(kEye, from));
            const Place place = drag.to(through(kEye, to), false);
            EXPECT_NEAR(place.at[i], kPlace.at[i] + 0.9f, 2e-3f) << i;
            EXPECT_EQ(place.at[(i + 1) % 3], kPlace.at[(i + 1) % 3]);
            EXPECT_EQ(place.at[(i + 2) % 3], kPlace.at[(i + 2) % 3]);
            EXPECT_EQ(place.rotate, kPlace.rotate);
            EXPECT_EQ(place.scale, kPlace.scale);
            const Place snap = drag.to(through(kEye, to), true);
            EXPECT_EQ(snap.at[i], tidy(std::round(snap.at[i] * 10) / 10, 0.1f));
            EXPECT_NEAR(snap.at[i], place.at[i], 0.0501f);
        }
    }
}

TEST(HandleMath, PlanesAndTheMiddleStayUnderTheHand) {
    for (const glm::mat4& parent : parents()) {
        for (int i = 0; i < 4; ++i) {
            const Handle handle{i < 3 ? Kind::kPlane : Kind::kMiddle, i % 3};
            const glm::vec3 centre = apply(parent, kPlace.at);
            HandleDrag drag(setting(HandleMode::kMove, handle, parent), through(kEye, centre));
            const Sight to = through(kEye, centre + glm::vec3(0.3f, -0.4f, 0.1f));
            const Place place = drag.to(to, false);
            const float size = glm::distance(kEye, centre);
            EXPECT_LT(distanceTo(to, apply(parent, place.at)), 2e-3f * size) << i;
            if (i < 3) {
                EXPECT_EQ(place.at[i], kPlace.at[i]);
            }
        }
    }
}

TEST(HandleMath, ARingTakesThePointThatWasGrabbedAlong) {
    for (const glm::mat4& parent : parents()) {
        for (int i = 0; i < 3; ++i) {
            const auto onRing = [&](float degrees) {
                glm::vec3 p(0);
                p[(i + 1) % 3] = std::cos(glm::radians(degrees));
                p[(i + 2) % 3] = std::sin(glm::radians(degrees));
                return apply(parent, kPlace.at + p);
            };
            const glm::vec3 grabbed = onRing(10);
            const glm::vec3 inNode = apply(glm::inverse(parent * parentFromNode(kPlace)), grabbed);
            HandleDrag drag(setting(HandleMode::kTurn, {Kind::kAxis, i}, parent),
                            through(kEye, grabbed));
            const glm::vec3 axis = parent[i],
                            normal = glm::normalize(glm::cross(glm::vec3(parent[(i + 1) % 3]),
                                                               glm::vec3(parent[(i + 2) % 3])));
            if (std::abs(glm::dot(normal, glm::normalize(grabbed - kEye))) < 0.2f) continue;
            for (float degrees = 20; degrees <= 800; degrees += 60) {
                const Place place = drag.to(through(kEye, onRing(degrees)), false);
                EXPECT_NEAR(drag.turned(), degrees - 10, 0.2f) << "round and round";
                const glm::vec3 now = apply(parent * parentFromNode(place), inNode);
                EXPECT_LT(glm::distance(now, onRing(degrees)), 5e-3f * glm::length(axis) + 4e-3f)
                    << i << ' ' << degrees;
                EXPECT_EQ(place.at, kPlace.at);
                EXPECT_EQ(place.scale, kPlace.scale);
            }
            drag.to(through(kEye, onRing(57)), true);
            EXPECT_NEAR(std::remainder(drag.turned() - 47, 360.0f), 0, 0.2f);
        }
    }
}

TEST(HandleMath, ARingSeenFromItsEdgeIsPulledAlong) {
    HandleDrag::Setting s = setting(HandleMode::kTurn, {Kind::kAxis, 1}, glm::mat4(1));
    s.place = {};
    const glm::vec3 eye(0, 0, 5);  // in the plane of the ring around y
    HandleDrag drag(s, through(eye, {0, 0, 1}));
    // Its near side goes to the right: counterclockwise seen from above, by a radian a radius.
    EXPECT_NEAR(drag.to(through(eye, {0.5f, 0, 0}), false).rotate.y, glm::degrees(0.5f), 0.1f);
    EXPECT_NEAR(drag.to(through(eye, {-0.5f, 0, 0}), true).rotate.y, -30, 1e-4f);
}

TEST(HandleMath, ScalesKeepTheirSignAndNeverVanish) {
    for (const glm::mat4& parent : parents()) {
        for (int i = 0; i < 3; ++i) {
            const auto onAxis = [&](float t) {
                glm::vec3 p(0);
                p[i] = t;
                return apply(parent, kPlace.at + rotationOf(kPlace.rotate) * p);
            };
            HandleDrag drag(setting(HandleMode::kScale, {Kind::kAxis, i}, parent),
                            through(kEye, onAxis(1)));
            const Place place = drag.to(through(kEye, onAxis(1.5f)), false);
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(place.scale[c] / kPlace.scale[c], c == i ? 1.5f : 1, 0.01f) << i;
            EXPECT_EQ(place.at, kPlace.at);
            const Place through0 = drag.to(through(kEye, onAxis(-1)), false);
            EXPECT_NEAR(through0.scale[i] / kPlace.scale[i], 0.01f, 0.006f);
            const Place snap = drag.to(through(kEye, onAxis(1.33f)), true);
            EXPECT_EQ(snap.scale[i], tidy(snap.scale[i], 0.1f));
        }
        HandleDrag all(setting(HandleMode::kScale, {Kind::kMiddle, 0}, parent),
                       through(kEye, apply(parent, kPlace.at)));
        const glm::vec3 right = setting({}, {}, parent).view.right;
        const Place place = all.to(through(kEye, apply(parent, kPlace.at) + right), false);
        EXPECT_NEAR(place.scale.x / kPlace.scale.x, 2, 0.02f);
        EXPECT_NEAR(place.scale.y / kPlace.scale.y, 2, 0.02f);
        EXPECT_NEAR(place.scale.z / kPlace.scale.z, 2, 0.02f);
    }
}

TEST(HandleMath, NumbersAreAsFineAsAPixel) {
    EXPECT_EQ(tidy(0.123456f, 0.004f), 0.123f);
    EXPECT_EQ(tidy(0.123456f, 0.01f), 0.12f);
    EXPECT_EQ(tidy(-0.00001f, 0.01f), 0.0f);
    EXPECT_EQ(tidy(1234.5f, 20), 1230.0f);
    EXPECT_EQ(tidy(0.3f, 0), 0.3f);
}

TEST(HandleMath, WhoLooksAlongAnAxisCannotPullIt) {
    const Sight along{{0, 0, 5}, {0, 0, -1}};
    EXPECT_FALSE(nearestOnLine(along, {0, 0, 0}, {0, 0, 1}));
    EXPECT_TRUE(nearestOnLine(along, {0, 0, 0}, {1, 0, 0}));
    EXPECT_FALSE(meetingPlane(along, {1, 0, 0}, {0, 1, 0}, {0, 0, 1})) << "seen from its edge";
    EXPECT_FALSE(meetingPlane(along, {0, 0, 6}, {1, 0, 0}, {0, 1, 0})) << "behind the eye";
    const auto at = meetingPlane(along, {-1, -2, 0}, {2, 0, 0}, {1, 1, 0});
    ASSERT_TRUE(at);
    EXPECT_NEAR(at->x, -0.5f, 1e-6f);
    EXPECT_NEAR(at->y, 2, 1e-6f);
}

}  // namespace
}  // namespace vitrine
