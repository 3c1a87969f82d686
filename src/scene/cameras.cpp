// SPDX-License-Identifier: MIT
#include "scene/cameras.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scene/values.hpp"

namespace vitrine {
namespace {

constexpr Range kPositions{-1e9, 1e9};
constexpr Range kTimes{0, 1e6};
constexpr size_t kMaxKeys = 10'000;
/// A cubic through 48 points of a circle and along its tangents stays within 1e-6 of the radius.
constexpr int kOrbitKeys = 48;
constexpr float kSteepest = 89;  // degrees; straight above, no direction is up

/// A point and its change per second.
struct Motion {
    glm::vec3 point, change;
};

AnimationTrack trackOf(const std::string& key, size_t camera, const SourceLocation& where) {
    AnimationTrack track;
    track.target = {AnimationTarget::Object::kCamera, camera, key};
    track.interpolation = Interpolation::kCubicSpline;
    track.where = where;
    return track;
}

void addKey(AnimationTrack& track, float time, const Motion& motion) {
    track.times.push_back(time);
    const glm::vec4 tangent(motion.change, 0);
    track.values.insert(track.values.end(), {tangent, glm::vec4(motion.point, 0), tangent});
}

/// Whether the key is there and not from the command line.
bool inFile(const toml::table& table, const char* key) {
    const toml::node* node = table.get(key);
    return node != nullptr && placeOf(*node).line > 0;
}

class CameraReader {
  public:
    CameraReader(const toml::table& table, size_t index, std::vector<AnimationTrack>& ways,
                 Diagnostics& diagnostics)
        : table_(table), index_(index), ways_(ways), diagnostics_(diagnostics) {}

    Camera read() {
        camera_.where = placeOf(table_);
        readTable(table_, "[[camera]]", cameraOptions(), {"orbit", "path"}, camera_, diagnostics_);
        if (camera_.fov > 0 && camera_.focalLength > 0)
            diagnostics_.error(placeOf(*table_.get("focal_length")),
                               "give fov or focal_length, not both");
        if (camera_.fov == 0 && camera_.focalLength == 0)
            camera_.focalLength = Camera::kDefaultFocalLength;
        const toml::node* orbit = table_.get("orbit");
        const toml::node* path = table_.get("path");
        if (orbit != nullptr && path != nullptr) error(*path, "give orbit or path, not both");
        if (path != nullptr)
            readPath(*path);
        else if (orbit != nullptr && stands(camera_.where))
            readOrbit(*orbit);
        else
            stands(camera_.where);
        return camera_;
    }

  private:
    void error(const toml::node& node, const std::string& message) {
        diagnostics_.error(placeOf(node), message);
    }

    bool stands(const SourceLocation& where) {
        const std::string problem = problemOf(camera_);
        if (problem.empty()) return true;
        const toml::node* up = glm::length(camera_.up) < 1e-6f ? table_.get("up") : nullptr;
        diagnostics_.error(up != nullptr ? placeOf(*up) : where, problem);
        return false;
    }

    /// Goes to where a way begins, unless the command line says where it stands.
    void begin(const char* key, glm::vec3 Camera::*place, AnimationTrack way) {
        if (inFile(table_, key) || !table_.contains(key)) camera_.*place = way.values[1];
        ways_.push_back(std::move(way));
    }

    void readOrbit(const toml::node& node) {
        const toml::table* table = node.as_table();
        if (table == nullptr) return error(node, "orbit must be a table, as in { period = 12 }");
        const glm::vec3 from = camera_.eye - camera_.target;
        CameraOrbit orbit;
        orbit.distance = glm::length(from);
        const float elevation = glm::degrees(std::asin(from.y / orbit.distance));
        orbit.elevation = std::clamp(elevation, -kSteepest, kSteepest);
        orbit.azimuth = glm::degrees(std::atan2(from.x, from.z));
        const size_t mistakes = diagnostics_.list().size();
        readTable(*table, "orbit", orbitOptions(), {}, orbit, diagnostics_);
        if (orbit.period == 0) error(*table->get("period"), "an orbit's period must not be 0");
        if (inFile(table_, "eye") && inFile(*table, "distance") && inFile(*table, "elevation") &&
            inFile(*table, "azimuth"))
            error(*table_.get("eye"), "eye has no effect: orbit says where the camera begins");
        if (diagnostics_.list().size() > mistakes) return;
        camera_.orbit = orbit;
        AnimationTrack way = trackOf("eye", index_, placeOf(node));
        way.loop = LoopMode::kRepeat;
        const float seconds = std::abs(orbit.period);
        for (int i = 0; i <= kOrbitKeys; ++i) {
            const float share = static_cast<float>(i) / kOrbitKeys;
            addKey(way, seconds * share, onOrbit(orbit, share));
        }
        way.loopEnd = seconds;
        begin("eye", &Camera::eye, std::move(way));
    }

    [[nodiscard]] Motion onOrbit(const CameraOrbit& orbit, float share) const {
        const float sense = orbit.period < 0 ? -1.0f : 1.0f;
        const float angle = glm::radians(orbit.azimuth + sense * 360 * share);
        const float elevation = glm::radians(orbit.elevation);
        const float radius = orbit.distance * std::cos(elevation);
        const float turn = 2 * glm::pi<float>() / orbit.period;  // radians a second
        return {camera_.target + glm::vec3(radius * std::sin(angle),
                                           orbit.distance * std::sin(elevation),
                                           radius * std::cos(angle)),
                radius * turn * glm::vec3(std::cos(angle), 0, -std::sin(angle))};
    }

    void readPath(const toml::node& node) {
        for (const char* key : {"eye", "target"})
            if (inFile(table_, key) && inFile(table_, "path"))
                return error(*table_.get(key), "give eye and target, or path, not both");
        if (!readKeys(node)) return;
        for (const bool isEye : {true, false}) {
            const auto& points = isEye ? eyes_ : targets_;
            AnimationTrack way = trackOf(isEye ? "eye" : "target", index_, placeOf(node));
            way.loop = camera_.loop;
            way.loopStart = times_.front();
            way.loopEnd = times_.back();
            for (size_t i = 0; i < times_.size(); ++i)
                addKey(way, times_[i], {points[i], changeAt(points, i)});
            begin(isEye ? "eye" : "target", isEye ? &Camera::eye : &Camera::target, std::move(way));
        }
    }

    bool readKeys(const toml::node& node) {
        const toml::array* keys = node.as_array();
        const auto wrong = [&](const toml::node& at) {
            error(at,
                  "path must be two keys or more, as in [[0, [3, 2, 4], [0, 0.5, 0]], "
                  "[5, EYE, TARGET]]");
            return false;
        };
        if (keys == nullptr || keys->size() < 2) return wrong(node);
        if (keys->size() > kMaxKeys) {
            error(node,
                  fmt::format("there are {} keys, at most {} are read", keys->size(), kMaxKeys));
            return false;
        }
        for (const toml::node& entry : *keys) {
            const toml::array* key = entry.as_array();
            if (key == nullptr || key->size() != 3) return wrong(entry);
            double time = 0;
            Camera there = camera_;
            const size_t mistakes = diagnostics_.list().size();
            readNumber(*key->get(0), "the time", kTimes, time, diagnostics_);
            readVector(*key->get(1), "the eye", kPositions, there.eye, diagnostics_);
            readVector(*key->get(2), "the target", kPositions, there.target, diagnostics_);
            if (diagnostics_.list().size() > mistakes) return false;
            if (!times_.empty() && static_cast<float>(time) <= times_.back()) {
                error(*key->get(0), "times must grow from key to key; this one does not");
                return false;
            }
            std::swap(camera_, there);
            const bool good = stands(placeOf(entry));
            std::swap(camera_, there);
            if (!good) return false;
            times_.push_back(static_cast<float>(time));
            eyes_.push_back(there.eye);
            targets_.push_back(there.target);
        }
        return true;
    }

    /// The change per second at key `i`: that of the parabola through it and its neighbours, whose
    /// times need not be even (Bessel tangents: Farin, Curves and Surfaces for CAGD). At the ends
    /// of the way, and where the camera waits, it stands still.
    [[nodiscard]] glm::vec3 changeAt(const std::vector<glm::vec3>& points, size_t i) const {
        const size_t last = points.size() - 1;
        size_t before = i - 1, after = i + 1;
        float lead = i > 0 ? times_[i] - times_[before] : 0;
        float follow = i < last ? times_[after] - times_[i] : 0;
        if (i == 0 || i == last) {
            // A round that ends where it began goes on as if there were no end.
            if (camera_.loop != LoopMode::kRepeat || points[0] != points[last] || last < 3)
                return glm::vec3(0);
            before = last - 1;
            after = 1;
            lead = times_[last] - times_[before];
            follow = times_[1] - times_[0];
        }
        const glm::vec3 coming = (points[i] - points[before]) / lead;
        const glm::vec3 going = (points[after] - points[i]) / follow;
        if (coming == glm::vec3(0) || going == glm::vec3(0)) return glm::vec3(0);
        return (follow * coming + lead * going) / (lead + follow);
    }

    const toml::table& table_;
    size_t index_;
    std::vector<AnimationTrack>& ways_;
    Diagnostics& diagnostics_;
    Camera camera_;
    std::vector<float> times_;
    std::vector<glm::vec3> eyes_, targets_;
};

}  // namespace

Camera readCamera(const toml::table& table, size_t index, std::vector<AnimationTrack>& ways,
                  Diagnostics& diagnostics) {
    return CameraReader(table, index, ways, diagnostics).read();
}

}  // namespace vitrine
