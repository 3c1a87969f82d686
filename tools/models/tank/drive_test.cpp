// SPDX-License-Identifier: MIT
// The scene of the driving tank against makeTank at the same distance.
#include "models/tank/drive.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "models/tank/layout.hpp"
#include "models/tank/tank.hpp"
#include "models/tank/track.hpp"
#include "scene/parse.hpp"
#include "scene/pose.hpp"

namespace vitrine::tank {
namespace {

const Scene& drivenScene() {
    static const Scene scene = [] {
        Diagnostics diagnostics;
        Scene s = parseScene("[material.chassis]\n" + driveScene(), "drive.toml", {}, diagnostics);
        diagnostics.throwIfErrors();
        return s;
    }();
    return scene;
}

/// Every node of a kind, with its place, after a time.
std::vector<glm::mat4> places(const std::string& shape, double time) {
    const Scene posed = poseScene(drivenScene(), time);
    const std::vector<glm::mat4> world = worldFromNodes(posed);
    std::vector<glm::mat4> list;
    for (size_t i = 0; i < world.size(); ++i)
        if (posed.nodes[i].shape.name == shape) list.push_back(world[i]);
    return list;
}

/// How far the farthest of `places` is from the nearest of `others`, at points of a link's size
/// away from its middle.
float apart(const std::vector<glm::mat4>& places, const std::vector<glm::mat4>& others) {
    const auto distance = [](const glm::mat4& a, const glm::mat4& b) {
        float most = 0;
        for (const glm::vec4 p :
             {glm::vec4(0.1f, 0, 0, 1), glm::vec4(0, 0.1f, 0, 1), glm::vec4(0, 0, 0.1f, 1)})
            most = std::max(most, glm::distance(glm::vec3(a * p), glm::vec3(b * p)));
        return most;
    };
    float farthest = 0;
    for (const glm::mat4& place : places) {
        float nearest = 1e9f;
        for (const glm::mat4& other : others) nearest = std::min(nearest, distance(place, other));
        farthest = std::max(farthest, nearest);
    }
    return farthest;
}

std::vector<glm::mat4> partPlaces(size_t fromEnd, double drive) {
    const Assembly chassis = makeTank(drive)[0];
    const Part& part = chassis.parts[chassis.parts.size() - fromEnd];
    return {part.places.begin(), part.places.end()};
}

TEST(Drive, LinksAndWheelsAreWhereTheChassisHasThem) {
    for (const double time : {0.0, 0.013, 0.05, 0.121, 0.16, 1.234, 7.77}) {
        const double drive = time * kDriveSpeed;
        EXPECT_LT(apart(places("link", time), partPlaces(1, drive)), 0.0006f) << time;
        EXPECT_LT(apart(partPlaces(1, drive), places("link", time)), 0.0006f) << time;
        EXPECT_LT(apart(places("idler", time), partPlaces(3, drive)), 1e-4f) << time;
        EXPECT_LT(apart(places("return_roller", time), partPlaces(4, drive)), 1e-4f) << time;
        EXPECT_LT(apart(places("road_wheel", time), partPlaces(5, drive)), 1e-4f) << time;
    }
}

TEST(Drive, TheSprocketsTeethStayBetweenThePins) {
    for (const double time : {0.0, 0.03, 0.08, 0.14, 2.5, 9.1}) {
        const double angle = sprocketAngle(trackPins(time * kDriveSpeed));
        for (const glm::mat4& place : places("sprocket", time)) {
            const double step = kTau / kSprocketTeeth;
            const double teeth = (std::atan2(place[0].y, place[0].x) - angle) / step;
            EXPECT_NEAR(teeth - std::round(teeth), 0, 0.03) << time;  // of a tooth: one degree
        }
    }
}

TEST(Drive, NothingJumpsWhereALoopBeginsAgain) {
    const double period = trackPitch() / kDriveSpeed, moment = 1e-4;
    for (const int round : {1, 2, 17})
        EXPECT_LT(
            apart(places("link", round * period - moment), places("link", round * period + moment)),
            0.0005f);
    for (const double radius : {kWheelRadius, kIdlerRadius, kRollerRadius}) {
        const double turn = kTau * radius / kDriveSpeed;
        for (const char* shape : {"road_wheel", "idler", "return_roller", "sprocket"})
            EXPECT_LT(apart(places(shape, turn - moment), places(shape, turn + moment)), 0.0005f)
                << shape;
    }
    // The measure sees a jump: within half a period links are off by half a pitch.
    EXPECT_GT(apart(places("link", 0.0), places("link", 0.5 * period)), 0.05f);
}

TEST(Drive, LinksOnTheGroundStandStill) {
    // In the world, where the tank has come as far as it has driven.
    for (const double time : {0.02, 0.09}) {
        const auto before = places("link", 0.0);
        const auto after = places("link", time);
        for (const glm::mat4& place : before) {
            if (std::abs(place[3].x) > 1.5f || place[3].y > 0.1f) continue;
            float nearest = 1e9f;
            for (const glm::mat4& other : after)
                nearest = std::min(nearest, glm::distance(glm::vec3(place[3]),
                                                          glm::vec3(other[3]) +
                                                              glm::vec3(time * kDriveSpeed, 0, 0)));
            EXPECT_LT(nearest, 0.001f);
        }
    }
}

TEST(Drive, HasTheTrianglesOfTheWholeChassis) {
    const Assembly chassis = makeTank()[0];
    const Atlas atlas = unwrap(chassis, 512);
    size_t driven = 0;
    for (const Mesh& mesh : makeDriveMeshes(chassis, atlas)) {
        size_t copies = 0;
        for (const Node& node : drivenScene().nodes) copies += node.shape.name == mesh.name ? 1 : 0;
        EXPECT_GT(copies, 0u) << mesh.name;
        driven += copies * mesh.triangles.size();
    }
    EXPECT_EQ(driven, toMesh(chassis, atlas).triangles.size());
}

}  // namespace
}  // namespace vitrine::tank
