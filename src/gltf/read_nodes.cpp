// SPDX-License-Identifier: MIT
#include "gltf/read_nodes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gltf/pose.hpp"

namespace vitrine {
namespace {

constexpr float kInfinity = JsonValue::kInfinity;

class NodeReader {
  public:
    explicit NodeReader(ReadContext& context)
        : context_(context), model_(context.model), nodes_(context.root.array("nodes")) {}

    bool readAll() {
        if (!context_.spend(&GltfLimits::nodes, nodes_.size(), "nodes", nodes_)) return false;
        model_.nodes.resize(nodes_.size());
        for (size_t i = 0; i < nodes_.size(); ++i) readNode(nodes_.objectAt(i), i);
        const bool isForest = order();
        readScenes();
        return isForest;
    }

  private:
    void readNode(const JsonValue& value, size_t number) {
        GltfNode& node = model_.nodes[number];
        node.name = nameOf(value, "node", number);
        readTransform(value, node);
        node.mesh = value.index("mesh", model_.meshes.size());
        node.camera = value.index("camera", model_.cameras.size());
        node.light = value.object("extensions")
                         .object("KHR_lights_punctual")
                         .index("light", model_.lights.size());
        if (value.has("skin"))
            value.warnOnce("skins are not supported; meshes stay as they were modelled");
        const JsonValue children = value.array("children");
        for (size_t c = 0; c < children.size(); ++c) {
            const auto child = children.indexAt(c, nodes_.size());
            if (!child) continue;
            if (model_.nodes[*child].parent != kNoIndex) {
                children.error(fmt::format("node {} has another parent already: node {}", *child,
                                           model_.nodes[*child].parent));
                continue;
            }
            model_.nodes[*child].parent = static_cast<int>(number);
            node.children.push_back(static_cast<int>(*child));
        }
    }

    static void readTransform(const JsonValue& value, GltfNode& node) {
        // Infinite numbers are let through: skipUnusableNodes() finds them.
        node.translation = value.vector<3>("translation", node.translation, -kInfinity, kInfinity);
        node.scale = value.vector<3>("scale", node.scale, -kInfinity, kInfinity);
        const glm::vec4 q = value.vector<4>("rotation", {0, 0, 0, 1}, -kInfinity, kInfinity);
        node.rotation = glm::quat(q.w, q.x, q.y, q.z);
        glm::mat4 matrix(1.0f);
        if (!value.numbers("matrix", &matrix[0][0], 16, -kInfinity, kInfinity)) return;
        node.matrix = matrix;
        if (value.has("translation") || value.has("rotation") || value.has("scale"))
            value.error("matrix", "there must not be a translation, rotation or scale besides it");
    }

    /// Level by level from the roots. A node has one parent at most, so what is not reached is part
    /// of a cycle or hangs on one.
    bool order() {
        std::vector<int>& order = model_.nodeOrder;
        order.reserve(model_.nodes.size());
        for (size_t i = 0; i < model_.nodes.size(); ++i)
            if (model_.nodes[i].parent == kNoIndex) order.push_back(static_cast<int>(i));
        std::vector<bool> isReached(model_.nodes.size(), false);
        int depth = 1;
        for (size_t level = 0; level < order.size(); ++depth) {
            if (depth > context_.limits.nodeDepth) {
                nodes_.objectAt(order[level])
                    .error(fmt::format("more than {} levels of nodes", context_.limits.nodeDepth));
                return false;
            }
            for (const size_t end = order.size(); level < end; ++level) {
                isReached[order[level]] = true;
                const std::vector<int>& children = model_.nodes[order[level]].children;
                order.insert(order.end(), children.begin(), children.end());
            }
        }
        const auto lost = std::find(isReached.begin(), isReached.end(), false);
        if (lost == isReached.end()) return true;
        nodes_.objectAt(lost - isReached.begin())
            .error("the node is its own ancestor, or below one");
        return false;
    }

    void readScenes() {
        const JsonValue scenes = context_.root.array("scenes");
        for (size_t i = 0; i < scenes.size(); ++i) readScene(scenes.objectAt(i), i);
        model_.scene = std::max(0, context_.root.index("scene", scenes.size()));
        if (!model_.scenes.empty()) return;
        GltfScene all{"scene 0", {}};
        for (const int node : model_.nodeOrder)
            if (model_.nodes[node].parent == kNoIndex) all.nodes.push_back(node);
        model_.scenes.push_back(std::move(all));
    }

    void readScene(const JsonValue& value, size_t number) {
        GltfScene scene{nameOf(value, "scene", number), {}};
        const JsonValue roots = value.array("nodes");
        for (size_t i = 0; i < roots.size(); ++i) {
            const auto root = roots.indexAt(i, nodes_.size());
            if (!root) continue;
            if (model_.nodes[*root].parent != kNoIndex)
                roots.error(fmt::format("node {} is no root: its parent is node {}", *root,
                                        model_.nodes[*root].parent));
            scene.nodes.push_back(static_cast<int>(*root));
        }
        std::vector<int> sorted = scene.nodes;
        std::sort(sorted.begin(), sorted.end());
        if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end())
            roots.error("a node comes twice");
        model_.scenes.push_back(std::move(scene));
    }

    ReadContext& context_;
    GltfModel& model_;
    JsonValue nodes_;
};

bool isFiniteMatrix(const glm::mat4& m) {
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r)
            if (!std::isfinite(m[c][r])) return false;
    return true;
}

bool isInvertible(const glm::mat4& m) {
    const glm::dvec3 x(m[0]), y(m[1]), z(m[2]);
    // Of the volume of a box with the same edges: small scales are good, flat ones are not.
    constexpr double kFlat = 1e-9;
    const double box = glm::length(x) * glm::length(y) * glm::length(z);
    return box > 0 && std::abs(glm::dot(glm::cross(x, y), z)) > kFlat * box;
}

/// Why the node cannot be drawn by its own transform; "" if it can.
std::string_view problemOf(const GltfNode& node, const glm::mat4& parentFromNode, bool isAnimated) {
    const glm::quat& q = node.rotation;
    if (!node.matrix && q.x == 0 && q.y == 0 && q.z == 0 && q.w == 0) return "its rotation is zero";
    if (!isFiniteMatrix(parentFromNode)) return "its transform is infinite";
    const glm::vec4 lastRow(parentFromNode[0].w, parentFromNode[1].w, parentFromNode[2].w,
                            parentFromNode[3].w);
    if (lastRow != glm::vec4(0, 0, 0, 1)) return "its matrix is a projection";
    if (!isAnimated && !isInvertible(parentFromNode)) return "its transform makes all flat";
    return "";
}

}  // namespace

bool readNodes(ReadContext& context) {
    return NodeReader(context).readAll();
}

void skipUnusableNodes(ReadContext& context) {
    GltfModel& model = context.model;
    const JsonValue nodes = context.root.array("nodes");
    std::vector<bool> isAnimated(model.nodes.size(), false);
    for (const GltfAnimation& animation : model.animations)
        for (const GltfChannel& channel : animation.channels) isAnimated[channel.node] = true;

    const std::vector<glm::mat4> locals = restPose(model);
    const std::vector<glm::mat4> worlds = worldFromNodes(model, locals);
    for (const int i : model.nodeOrder) {
        GltfNode& node = model.nodes[i];
        if (node.parent != kNoIndex && model.nodes[node.parent].isSkipped) {
            node.isSkipped = true;
            continue;
        }
        std::string_view problem = problemOf(node, locals[i], isAnimated[i]);
        if (problem.empty() && !isFiniteMatrix(worlds[i]))
            problem = "its place in the world is infinite";
        if (problem.empty()) continue;
        node.isSkipped = true;
        nodes.objectAt(i).warning(fmt::format("left out, with all below it: {}", problem));
    }
}

}  // namespace vitrine
