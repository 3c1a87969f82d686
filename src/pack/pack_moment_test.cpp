// SPDX-License-Identifier: MIT
// What is packed for a moment, against everything packed at that moment.
#include <gtest/gtest.h>

#include <cstring>

#include "bvh/build.hpp"
#include "mesh/primitives.hpp"
#include "pack/pack_scene.hpp"
#include "scene/pose.hpp"

namespace vitrine {
namespace {

template <class T>
bool sameBytes(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() &&
           (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

std::shared_ptr<const MeshAsset> meshAsset(Mesh mesh) {
    auto asset = std::make_shared<MeshAsset>();
    asset->bvh = buildTriangleBvh(mesh.positions, mesh.triangles);
    asset->mesh = std::make_shared<Mesh>(std::move(mesh));
    return asset;
}

/// Two meshes, a field with a parameter, a textured material, and animations of everything.
struct Moving {
    Scene scene;
    Assets assets;

    Moving() {
        for (const char* name : {"torus", "box", "field"}) {
            Shape shape;
            shape.name = name;
            scene.shapes.push_back(shape);
        }
        Diagnostics diagnostics;
        auto snippet = parseSnippet(
            "// bounds[-1, -1, -1, 1, 1, 1]\nuniform float size; // slider[0, 0.5, 1]\n"
            "float sdf(vec3 p) { return length(p) - size; }\n",
            "f.sdf.glsl", SnippetKind::kField, diagnostics);
        diagnostics.throwIfErrors();
        scene.shapes[2].sdf.name = "f.sdf.glsl";
        assets.meshes = {meshAsset(makeTorus(0.5f, 0.2f, 12, 8)), meshAsset(makeBox(glm::vec3(1))),
                         nullptr};
        assets.fields = {nullptr, nullptr, std::make_shared<Snippet>(std::move(*snippet))};
        Material material;
        material.name = "m";
        scene.materials = {material};
        assets.materials = {nullptr};
        assets.pictures.resize(1);
        assets.pictures[0].resize(VITRINE_SLOT_COUNT);
        const auto picture = std::make_shared<ImageRgba8>(4, 4);
        assets.pictures[0][VITRINE_SLOT_NORMAL] = assets.pictures[0][0] = picture;
        Light light;
        light.name = "l";
        scene.lights = {light};
        scene.cameras.emplace_back();
        for (int i = 0; i < 9; ++i) {
            Node node;
            node.name = "n" + std::to_string(i);
            node.shape.name = scene.shapes[static_cast<size_t>(i) % 3].name;
            node.material.name = "m";
            node.at = {3.0f * static_cast<float>(i), 0, 0};
            if (i > 0) node.parent.name = "n0";
            scene.nodes.push_back(node);
        }
        using Object = AnimationTarget::Object;
        move(Object::kNode, 0, "rotate", {0, 0, 0, 0}, {0, 170, 40, 0});
        move(Object::kNode, 1, "at", {0, 0, 0, 0}, {0, 90, 0, 0});
        move(Object::kNode, 2, "set.size", {0.1f, 0, 0, 0}, {0.9f, 0, 0, 0});
        move(Object::kNode, 4, "visible", {1, 0, 0, 0}, {-1, 0, 0, 0});
        move(Object::kNode, 8, "scale", {1, 1, 1, 0}, {0, 0, 0, 0});
        move(Object::kMaterial, 0, "normal_scale", {1, 0, 0, 0}, {3, 0, 0, 0});
        move(Object::kMaterial, 0, "base_color", {0, 0, 0, 0}, {1, 1, 1, 0});
        move(Object::kLight, 0, "direction", {0, -1, 0, 0}, {1, -1, 0, 0});
        move(Object::kRender, 0, "exposure", {0, 0, 0, 0}, {3, 0, 0, 0});
        move(Object::kEnvironment, 0, "zenith", {0, 0, 0, 0}, {1, 0, 1, 0});
    }

    void move(AnimationTarget::Object object, size_t index, const std::string& key,
              const glm::vec4& from, const glm::vec4& to) {
        AnimationTrack track;
        track.target = {object, index, key};
        track.times = {0, 2};
        track.values = {from, to};
        scene.animations.push_back(track);
    }

    [[nodiscard]] PackedScene pack(const Scene& s) const {
        Diagnostics diagnostics;
        PackedScene packed = packScene(s, assets, diagnostics);
        EXPECT_EQ(diagnostics.text(), "");
        return packed;
    }
};

TEST(PackMoment, GivesTheBytesOfAFullPack) {
    const Moving m;
    const PackedScene rest = m.pack(m.scene);
    for (const double time : {0.0, 0.3, 1.0, 1.7, 2.0, 0.3}) {
        const Scene posed = poseScene(m.scene, time);
        const PackedScene full = m.pack(posed);
        Diagnostics diagnostics;
        const PackedMoment moment = packMoment(posed, m.assets, rest, diagnostics);
        EXPECT_EQ(diagnostics.text(), "");
        EXPECT_TRUE(sameBytes(moment.tables, full.tables)) << time;
        EXPECT_TRUE(sameBytes(moment.upperSlots, full.upperSlots)) << time;
        EXPECT_EQ(std::memcmp(&moment.block, &full.block, sizeof moment.block), 0) << time;
        EXPECT_EQ(moment.fieldRoot, full.fieldRoot);
        EXPECT_EQ(moment.stackBound, full.stackBound);
        EXPECT_EQ(moment.instances.size(), full.instances.size());
        EXPECT_EQ(moment.worldBox.min, full.worldBox.min);
        EXPECT_EQ(moment.worldBox.max, full.worldBox.max);
        // And what is not packed again has indeed not changed.
        EXPECT_TRUE(sameBytes(rest.slots, full.slots)) << time;
        EXPECT_TRUE(sameBytes(rest.vertices, full.vertices)) << time;
        EXPECT_TRUE(sameBytes(rest.triangles, full.triangles)) << time;
        EXPECT_TRUE(sameBytes(rest.textures.color.pages.at(0).texels,
                              full.textures.color.pages.at(0).texels));
        EXPECT_EQ(rest.shaders.includes, full.shaders.includes);
        EXPECT_EQ(sameBytes(moment.tables, rest.tables), false) << "nothing moves";
    }
}

TEST(PackMoment, WhatHangsOnAHiddenNodeIsHiddenToo) {
    Moving m;
    m.scene.animations.clear();
    const auto shown = [&] {
        std::vector<size_t> nodes;
        for (const PackedInstance& instance : m.pack(m.scene).instances)
            nodes.push_back(instance.node);
        return nodes;
    };
    m.scene.nodes[4].parent.name = "n3";  // a mesh, a field below it, and one of each below that
    m.scene.nodes[5].parent.name = "n4";
    m.scene.nodes[6].parent.name = "n4";
    m.scene.nodes[4].visible = false;
    EXPECT_EQ(shown(), (std::vector<size_t>{0, 1, 2, 3, 7, 8}));
    m.scene.lights.emplace_back().node = 6;
    m.scene.lights.emplace_back().node = 7;
    const int lights = m.pack(m.scene).block.counts.x;
    m.scene.nodes[0].visible = false;
    EXPECT_EQ(shown(), std::vector<size_t>{}) << "all hang on it";
    EXPECT_EQ(m.pack(m.scene).block.counts.x, lights - 1);
    m.scene.nodes[0].visible = m.scene.nodes[4].visible = true;
    EXPECT_EQ(shown().size(), 9u);
    EXPECT_EQ(m.pack(m.scene).block.counts.x, lights + 1);
}

TEST(PackMoment, HiddenNodesCanAppear) {
    Moving m;
    m.scene.animations.clear();
    for (Node& node : m.scene.nodes) node.visible = false;
    const PackedScene rest = m.pack(m.scene);
    EXPECT_TRUE(rest.instances.empty());
    EXPECT_EQ(rest.fieldRoot, -1);
    for (Node& node : m.scene.nodes) node.visible = true;
    Diagnostics diagnostics;
    const PackedMoment moment = packMoment(m.scene, m.assets, rest, diagnostics);
    EXPECT_EQ(moment.instances.size(), 9u);
    EXPECT_TRUE(sameBytes(moment.tables, m.pack(m.scene).tables));
}

TEST(PackMoment, KeysThatTheSnippetRefusesAreErrors) {
    const auto problems = [](const std::string& key, const glm::vec4& last, size_t node,
                             int components = 1) {
        Moving m;
        m.scene.animations.clear();
        m.move(AnimationTarget::Object::kNode, node, key, {0.5f, 0, 0, 0}, last);
        m.scene.animations[0].where = {"t", 4, 1};
        m.scene.animations[0].components = components;
        Diagnostics diagnostics;
        (void)packScene(m.scene, m.assets, diagnostics);
        return diagnostics.text();
    };
    EXPECT_EQ(problems("set.size", {1, 0, 0, 0}, 2), "");
    EXPECT_EQ(problems("set.size", {2, 0, 0, 0}, 2),
              "t:4:1: error: size is 2; it must be from 0 to 1");
    EXPECT_EQ(problems("set.size", {1, 0, 0, 0}, 2, 3),
              "t:4:1: error: size is a float; give one number");
    EXPECT_EQ(problems("set.sise", {1, 0, 0, 0}, 2),
              "t:4:1: error: f.sdf.glsl has no parameter 'sise' (did you mean 'size'?)");
    EXPECT_EQ(problems("set.size", {1, 0, 0, 0}, 1),
              "t:4:1: error: only an SDF shape has parameters to animate");
}

}  // namespace
}  // namespace vitrine
