// SPDX-License-Identifier: MIT
// Source: glTF 2.0 Specification, appendix C, "Animation Sampler Interpolation Modes".
#include "gltf/pose.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace vitrine {
namespace {

glm::mat4 compose(const glm::vec3& translation, const glm::quat& rotation, const glm::vec3& scale) {
    // A rotation may be rounded in the file; only its direction counts.
    glm::mat4 m(glm::mat3_cast(glm::normalize(rotation)));
    for (int axis = 0; axis < 3; ++axis) m[axis] *= scale[axis];
    m[3] = glm::vec4(translation, 1.0f);
    return m;
}

glm::mat4 localMatrix(const GltfNode& node) {
    return node.matrix ? *node.matrix : compose(node.translation, node.rotation, node.scale);
}

glm::quat toQuat(const glm::vec4& v) {
    return {v.w, v.x, v.y, v.z};
}
glm::vec4 toVector(const glm::quat& q) {
    return {q.x, q.y, q.z, q.w};
}

/// The cubic Hermite spline between key `i` and the next, `t` in [0, 1]; `span` in seconds.
glm::vec4 cubic(const GltfChannel& channel, size_t i, float t, float span) {
    const glm::vec4& from = channel.values[3 * i + 1];
    const glm::vec4& leaving = channel.values[3 * i + 2];
    const glm::vec4& arriving = channel.values[3 * i + 3];
    const glm::vec4& to = channel.values[3 * i + 4];
    const float t2 = t * t, t3 = t2 * t;
    return (2 * t3 - 3 * t2 + 1) * from + span * (t3 - 2 * t2 + t) * leaving +
           (3 * t2 - 2 * t3) * to + span * (t3 - t2) * arriving;
}

glm::vec4 keyValue(const GltfChannel& channel, size_t i) {
    return channel.values[channel.interpolation == GltfInterpolation::kCubicSpline ? 3 * i + 1 : i];
}

glm::vec4 valueAt(const GltfChannel& channel, float time) {
    const auto next = std::upper_bound(channel.times.begin(), channel.times.end(), time);
    if (next == channel.times.begin()) return keyValue(channel, 0);
    const size_t i = next - channel.times.begin() - 1;
    if (next == channel.times.end() || channel.interpolation == GltfInterpolation::kStep)
        return keyValue(channel, i);
    const float span = channel.times[i + 1] - channel.times[i];
    const float t = (time - channel.times[i]) / span;
    if (channel.interpolation == GltfInterpolation::kCubicSpline) return cubic(channel, i, t, span);
    const glm::vec4 &from = channel.values[i], &to = channel.values[i + 1];
    if (channel.path == GltfPath::kRotation)  // slerp takes the shorter way round
        return toVector(glm::slerp(glm::normalize(toQuat(from)), glm::normalize(toQuat(to)), t));
    return glm::mix(from, to, t);
}

bool isUsable(GltfPath path, const glm::vec4& value) {
    for (int i = 0; i < 4; ++i)
        if (!std::isfinite(value[i])) return false;
    return path != GltfPath::kRotation || glm::dot(value, value) > 0;
}

}  // namespace

std::vector<glm::mat4> restPose(const GltfModel& model) {
    std::vector<glm::mat4> result;
    result.reserve(model.nodes.size());
    for (const GltfNode& node : model.nodes) result.push_back(localMatrix(node));
    return result;
}

std::vector<glm::mat4> sampleAnimation(const GltfModel& model, int animation, float time) {
    assert(animation >= 0 && static_cast<size_t>(animation) < model.animations.size());
    std::vector<glm::mat4> result = restPose(model);
    struct Moved {
        int node;
        glm::vec3 translation;
        glm::quat rotation;
        glm::vec3 scale;
    };
    // Sorted by node, the channels of one node follow each other.
    std::vector<const GltfChannel*> channels;
    for (const GltfChannel& channel : model.animations[animation].channels)
        channels.push_back(&channel);
    std::stable_sort(channels.begin(), channels.end(),
                     [](const auto* a, const auto* b) { return a->node < b->node; });
    for (size_t i = 0; i < channels.size();) {
        const GltfNode& node = model.nodes[channels[i]->node];
        Moved moved{channels[i]->node, node.translation, node.rotation, node.scale};
        for (; i < channels.size() && channels[i]->node == moved.node; ++i) {
            const glm::vec4 value = valueAt(*channels[i], time);
            if (!isUsable(channels[i]->path, value)) continue;
            switch (channels[i]->path) {
                case GltfPath::kTranslation:
                    moved.translation = value;
                    break;
                case GltfPath::kRotation:
                    moved.rotation = toQuat(value);
                    break;
                case GltfPath::kScale:
                    moved.scale = value;
                    break;
            }
        }
        result[moved.node] = compose(moved.translation, moved.rotation, moved.scale);
    }
    return result;
}

std::vector<glm::mat4> worldFromNodes(const GltfModel& model,
                                      const std::vector<glm::mat4>& parentFromNodes) {
    std::vector<glm::mat4> result = parentFromNodes;
    for (const int i : model.nodeOrder)
        if (const int parent = model.nodes[i].parent; parent != kNoIndex)
            result[i] = result[parent] * parentFromNodes[i];
    return result;
}

std::vector<int> nodesOfScene(const GltfModel& model, int scene) {
    std::vector<int> result;
    for (const int root : model.scenes[scene].nodes)
        if (!model.nodes[root].isSkipped) result.push_back(root);
    for (size_t i = 0; i < result.size(); ++i)
        for (const int child : model.nodes[result[i]].children)
            if (!model.nodes[child].isSkipped) result.push_back(child);
    return result;
}

}  // namespace vitrine
