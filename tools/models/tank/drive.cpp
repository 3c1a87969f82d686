// SPDX-License-Identifier: MIT
#include "models/tank/drive.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "models/tank/chassis.hpp"
#include "models/tank/layout.hpp"
#include "models/tank/tank.hpp"
#include "models/tank/track.hpp"

namespace vitrine::tank {
namespace {

constexpr double kDegrees = 360.0 / kTau;

/// Where something is and how it is turned about z, in degrees.
struct Pose {
    Vec2 at;
    double angle;
};

struct Key {
    double time;
    Pose pose;
};

Pose poseOf(const std::vector<Vec2>& pins, size_t i) {
    const Vec2 &a = pins[i % pins.size()], &b = pins[(i + 1) % pins.size()];
    return {0.5 * (a + b), kDegrees * std::atan2(b.y - a.y, b.x - a.x)};
}

/// How far the pose at `b` is from the straight way between `a` and `c`: metres, at the link's end.
double detour(const Key& a, const Key& b, const Key& c) {
    const double t = (b.time - a.time) / (c.time - a.time);
    const double turn = std::abs(glm::mix(a.pose.angle, c.pose.angle, t) - b.pose.angle);
    return glm::distance(glm::mix(a.pose.at, c.pose.at, t), b.pose.at) +
           turn / kDegrees * 0.5 * kPitch;
}

/// Leaves out what lies on the way within a fifth of a millimetre (Douglas and Peucker 1973).
std::vector<Key> simplified(const std::vector<Key>& keys) {
    constexpr double kClose = 0.0002;
    size_t farthest = 0;
    double distance = kClose;
    for (size_t i = 1; i + 1 < keys.size(); ++i) {
        const double d = detour(keys.front(), keys[i], keys.back());
        if (d > distance) {
            distance = d;
            farthest = i;
        }
    }
    if (farthest == 0) return {keys.front(), keys.back()};
    const auto middle = keys.begin() + static_cast<std::ptrdiff_t>(farthest);
    std::vector<Key> left = simplified({keys.begin(), middle + 1});
    const std::vector<Key> right = simplified({middle, keys.end()});
    left.insert(left.end(), right.begin() + 1, right.end());
    return left;
}

/// The way of every link over one pitch, and its time.
std::vector<std::vector<Key>> linkKeys() {
    constexpr int kSteps = 16;
    const std::vector<Vec2> start = trackPins(0.0);
    std::vector<std::vector<Key>> ways(start.size());
    const double pitch = trackPitch();
    for (int step = 0; step <= kSteps; ++step) {
        const double share = double(step) / kSteps;
        const std::vector<Vec2> pins = step < kSteps ? trackPins(share * pitch) : start;
        for (size_t i = 0; i < ways.size(); ++i) {
            Pose pose = poseOf(pins, step < kSteps ? i : i + 1);
            if (step > 0)  // on from the angle before, not around
                pose.angle += 360.0 * std::round((ways[i].back().pose.angle - pose.angle) / 360.0);
            ways[i].push_back({share * pitch / kDriveSpeed, pose});
        }
    }
    for (std::vector<Key>& way : ways) way = simplified(way);
    return ways;
}

class SceneText {
  public:
    std::string text;

    void shape(const std::string& name, const std::string& mesh) {
        print("[shape.{}]\nmesh = \"{}.obj\"\n\n", name, mesh);
    }
    void node(const std::string& name, const std::string& parent, const std::string& shape,
              const Vec3& at, const Vec3& rotate) {
        print("[[node]]\nname = \"{}\"\n", name);
        if (!parent.empty()) print("parent = \"{}\"\n", parent);
        if (!shape.empty()) print("shape = \"{}\"\nmaterial = \"chassis\"\n", shape);
        print("at = {}\nrotate = {}\n\n", vector(at), vector(rotate));
    }
    void animation(const std::string& node, const std::string& param,
                   const std::vector<std::pair<double, Vec3>>& keys, const std::string& more) {
        print("[[animation]]\nnode = \"{}\"\nparam = \"{}\"\nkeys = [", node, param);
        for (size_t i = 0; i < keys.size(); ++i)
            print("{}[{:.6f}, {}]",
                  i == 0       ? ""
                  : i % 3 == 0 ? ",\n  "
                               : ", ",
                  keys[i].first, vector(keys[i].second));
        print("]\n{}\n\n", more);
    }

  private:
    template <class... T>
    void print(fmt::format_string<T...> format, T&&... values) {
        fmt::format_to(std::back_inserter(text), format, std::forward<T>(values)...);
    }
    static std::string vector(const Vec3& v) {
        return fmt::format("[{:.6g}, {:.6g}, {:.6g}]", v.x, v.y, v.z);
    }
};

/// Both wheels of a pair roll ahead; those on the left look to the other side.
void addWheels(SceneText& scene, const std::string& name, const std::string& shape, const Vec2& at,
               double radius, const std::array<double, 2>& start) {
    const double round = kTau * radius / kDriveSpeed;
    for (const bool left : {false, true}) {
        const std::string node = name + (left ? "_left" : "_right");
        const double facing = left ? 180.0 : 0.0;
        const double first = kDegrees * start[left ? 1 : 0];
        scene.node(node, "tank", shape, {at.x, at.y, left ? -kTrackZ : kTrackZ},
                   {0, facing, first});
        scene.animation(node, "rotate",
                        {{0.0, {0, facing, first}}, {round, {0, facing, first - 360.0}}},
                        "loop = \"repeat\"");
    }
}

void addTrack(SceneText& scene) {
    const std::vector<std::vector<Key>> ways = linkKeys();
    for (const bool left : {false, true})
        for (size_t i = 0; i < ways.size(); ++i) {
            const std::string node = fmt::format("link_{}_{}", left ? "left" : "right", i);
            const double z = left ? -kTrackZ : kTrackZ;
            std::vector<std::pair<double, Vec3>> places, angles;
            for (const Key& key : ways[i]) {
                places.emplace_back(key.time, Vec3(key.pose.at, z));
                angles.emplace_back(key.time, Vec3(0, 0, key.pose.angle));
            }
            scene.node(node, "tank", "link", places[0].second, angles[0].second);
            scene.animation(node, "at", places, "loop = \"repeat\"");
            scene.animation(node, "rotate", angles, "loop = \"repeat\"");
        }
}

}  // namespace

std::vector<Mesh> makeDriveMeshes(const Assembly& chassis, const Atlas& atlas) {
    // What turns comes last (chassis.hpp).
    constexpr std::array kNames{"road_wheel", "return_roller", "idler", "sprocket", "link"};
    const size_t fixed = chassis.parts.size() - kNames.size();
    const auto meshOf = [&](const std::string& name, size_t first, size_t end, bool once) {
        Assembly part{name, chassis.origin, {}, {}};
        Atlas corners{atlas.side, {}, {}};
        for (size_t p = first; p < end; ++p) {
            part.parts.push_back(chassis.parts[p]);
            if (once) part.parts.back().places = {Mat4(1.0)};
            corners.corners.push_back(atlas.corners[p]);
        }
        return toMesh(part, corners);
    };
    std::vector<Mesh> meshes{meshOf("body", 0, fixed, false)};
    for (size_t i = 0; i < kNames.size(); ++i)
        meshes.push_back(meshOf(kNames[i], fixed + i, fixed + i + 1, true));
    return meshes;
}

std::string driveScene() {
    SceneText scene;
    scene.text = fmt::format(
        "# Generated by Vitrine's tools/models/tank; do not edit. The running gear at {} m/s:\n"
        "# a track repeats after {:.6g} m.\n\n",
        kDriveSpeed, trackPitch());
    for (const char* name : {"body", "road_wheel", "return_roller", "idler", "sprocket", "link"})
        scene.shape(name, name);
    scene.node("tank", "", "", {0, 0, 0}, {0, 0, 0});
    scene.node("body", "tank", "", {0, 0, 0}, {0, 0, 0});
    scene.node("tub", "body", "body", {0, 0, 0}, {0, 0, 0});
    // The springs: a few millimetres and a fifth of a degree.
    scene.animation("body", "at", {{0.0, {0, -0.004, 0}}, {0.55, {0, 0.005, 0}}},
                    "ease = \"smooth\"\nloop = \"mirror\"");
    scene.animation("body", "rotate", {{0.0, {0, 0, -0.16}}, {0.83, {0, 0, 0.20}}},
                    "ease = \"smooth\"\nloop = \"mirror\"");
    double parked = 0.0;  // as in chassis.cpp
    for (size_t i = 0; i < kWheelX.size(); ++i) {
        parked += 1.3;
        addWheels(scene, fmt::format("wheel_{}", i), "road_wheel", {kWheelX[i], kWheelY},
                  kWheelRadius, {parked, parked});
    }
    for (size_t i = 0; i < kRollerX.size(); ++i) {
        parked += 0.7;
        addWheels(scene, fmt::format("roller_{}", i), "return_roller", {kRollerX[i], kRollerY},
                  kRollerRadius, {parked, parked});
    }
    addWheels(scene, "idler", "idler", kIdlerAt, kIdlerRadius, {0, 0});
    // A turn of the sprocket is as many links as it has teeth.
    const double angle = sprocketAngle(trackPins(0.0));
    addWheels(scene, "sprocket", "sprocket", kSprocketAt, kSprocketTeeth * trackPitch() / kTau,
              {angle, kTau / 2.0 + angle});
    addTrack(scene);
    return scene.text;
}

}  // namespace vitrine::tank
