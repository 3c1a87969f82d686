// SPDX-License-Identifier: MIT
#include "import/model_animation.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/text.hpp"
#include "gltf/pose.hpp"
#include "import/model_mesh.hpp"
#include "scene/document.hpp"

namespace vitrine {
namespace {

const char* keyOf(GltfPath path) {
    switch (path) {
        case GltfPath::kRotation:
            return kOrientationKey;
        case GltfPath::kScale:
            return "scale";
        case GltfPath::kTranslation:
            break;
    }
    return "at";
}

Interpolation interpolationOf(GltfInterpolation interpolation) {
    switch (interpolation) {
        case GltfInterpolation::kStep:
            return Interpolation::kStep;
        case GltfInterpolation::kCubicSpline:
            return Interpolation::kCubicSpline;
        case GltfInterpolation::kLinear:
            break;
    }
    return Interpolation::kLinear;
}

}  // namespace

int firstAnimation(const GltfModel& model) {
    for (size_t i = 0; i < model.animations.size(); ++i)
        if (!model.animations[i].channels.empty()) return static_cast<int>(i);
    return kNoIndex;
}

int chosenAnimation(const GltfModel& model, const Node& root, Diagnostics& diagnostics) {
    std::vector<std::string> names;
    for (const GltfAnimation& animation : model.animations) names.push_back(animation.name);
    const std::string& wanted = root.animation.name;
    const auto found = std::find(names.begin(), names.end(), wanted);
    if (found != names.end()) return static_cast<int>(found - names.begin());
    if (!wanted.empty()) {
        if (wanted != "none")
            diagnostics.error(root.animation.where,
                              fmt::format("'{}' has no animation '{}'{}", root.include.name, wanted,
                                          didYouMean(wanted, names)));
        return kNoIndex;
    }
    const int first = firstAnimation(model);
    if (first == kNoIndex || names.size() == 1) return first;
    constexpr size_t kMostNames = 12;
    const std::string playing = names[static_cast<size_t>(first)];
    names.erase(names.begin() + first);
    const size_t unnamed = names.size() - std::min(names.size(), kMostNames);
    names.resize(names.size() - unnamed);
    diagnostics.warning(
        root.include.where,
        printable(
            fmt::format("'{}' has more than one animation: '{}' plays, and not '{}'{}; choose with "
                        "animation = \"NAME\"",
                        root.include.name, playing, fmt::join(names, "', '"),
                        unnamed == 0 ? "" : fmt::format(" and {} more", unnamed))));
    return first;
}

size_t sizeOf(const GltfAnimation& animation) {
    size_t size = 0;
    for (const GltfChannel& c : animation.channels) size += c.times.size() + 4 * c.values.size();
    return size;
}

std::vector<AnimationTrack> tracksOf(const GltfAnimation& animation,
                                     const std::vector<std::optional<size_t>>& sceneNode,
                                     const SourceLocation& where) {
    std::vector<AnimationTrack> tracks;
    for (const GltfChannel& channel : animation.channels) {
        const std::optional<size_t> node = sceneNode[static_cast<size_t>(channel.node)];
        if (!node) continue;
        AnimationTrack track;
        track.target = {AnimationTarget::Object::kNode, *node, keyOf(channel.path)};
        track.times = channel.times;
        track.values = channel.values;
        track.components = channel.path == GltfPath::kRotation ? 4 : 3;
        track.interpolation = interpolationOf(channel.interpolation);
        track.loop = LoopMode::kRepeat;
        track.loopEnd = animation.duration;
        track.where = where;
        tracks.push_back(std::move(track));
    }
    return tracks;
}

Aabb boundsOverTime(const GltfModel& model) {
    const int animation = firstAnimation(model);
    if (animation == kNoIndex) return boundsOfScene(model, restPose(model));
    // Enough to see where a wheel goes round, if that does not take seconds.
    constexpr uint64_t kMostVertices = 50'000'000;
    const uint64_t vertices = std::max<uint64_t>(1, sizeOfScene(model).vertices);
    const int steps = static_cast<int>(std::clamp<uint64_t>(kMostVertices / vertices, 1, 32));
    const float duration = model.animations[static_cast<size_t>(animation)].duration;
    Aabb box;
    for (int i = 0; i < steps; ++i) {
        const float time = duration * static_cast<float>(i) / static_cast<float>(steps);
        box.grow(boundsOfScene(model, sampleAnimation(model, animation, time)));
    }
    return box;
}

}  // namespace vitrine
