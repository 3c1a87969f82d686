// SPDX-License-Identifier: MIT
#include "import/model_animation.hpp"

#include <algorithm>

#include "gltf/pose.hpp"
#include "import/model_mesh.hpp"

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
