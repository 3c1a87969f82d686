// SPDX-License-Identifier: MIT
#include "pack/pack_scene.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include "base/file.hpp"
#include "scene/parse.hpp"

namespace vitrine {
namespace {

namespace fs = std::filesystem;
using glm::vec3;
using glm::vec4;

constexpr const char* kTwoParts =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
    "usemtl body\nf 1 2 3\nusemtl lid\nf 1 2 4\nf 1 3 4\n";
constexpr const char* kField = R"(// bounds[-1, -2, -3,  1, 2, 3]
// lipschitz[2]
// parts[shell, core]
uniform float size;  // slider[0.0, 0.5, 1.0] Size
uniform vec3 tint;   // color[0.1, 0.2, 0.3] Tint
vec2 sdf(vec3 p) { return vec2(length(p) - size + tint.x, 0.0); }
)";
constexpr const char* kPattern =
    "uniform float scale;  // slider[1.0, 2.0, 8.0] Scale\n"
    "void material(inout Surface s) { s.roughness = scale; }\n";

class PackScene : public testing::Test {
  protected:
    void SetUp() override {
        std::string name = fs::temp_directory_path() / "vitrine-pack-XXXXXX";
        ASSERT_NE(::mkdtemp(name.data()), nullptr);
        folder = name;
        write("two.obj", kTwoParts);
        write("f.sdf.glsl", kField);
        write("p.mat.glsl", kPattern);
    }
    void TearDown() override { fs::remove_all(folder); }
    void write(const std::string& file, std::string_view text) {
        writeFileAtomically(folder / file, text);
    }

    /// Loads and packs; what is wrong is in `problems`, without the folder.
    PackedScene pack(const std::string& text) {
        Diagnostics diagnostics;
        scene = parseScene(text, (folder / "t").string(), {}, diagnostics);
        assets = loadAssets(scene, diagnostics);
        PackedScene packed = packScene(scene, assets, diagnostics);
        problems = diagnostics.text();
        const std::string prefix = folder.string() + "/";
        for (size_t at; (at = problems.find(prefix)) != std::string::npos;)
            problems.erase(at, prefix.size());
        return packed;
    }
    /// Texel `index` of instance `i`.
    static vec4 instanceTexel(const PackedScene& p, int i, int index) {
        return p.tables.at(
            static_cast<size_t>(p.block.tables.x + i * VITRINE_INSTANCE_TEXELS + index));
    }
    /// Number of the material of a part of an instance.
    static int materialOf(const PackedScene& p, int instance, int part) {
        const auto first = static_cast<size_t>(instanceTexel(p, instance, 6).z);
        EXPECT_LT(part, static_cast<int>(p.tables.at(first).y)) << "the list is shorter";
        return static_cast<int>(p.tables.at(first + static_cast<size_t>(part)).x);
    }

    fs::path folder;
    Scene scene;
    Assets assets;
    std::string problems;
};

TEST_F(PackScene, GivesMaterialsToParts) {
    const PackedScene p = pack(R"([material.gold]
[material.iron]
[shape.s]
mesh = "two.obj"
[shape.f]
sdf = "f.sdf.glsl"
[[node]]
shape = "s"
[[node]]
shape = "s"
material = "gold"
[[node]]
shape = "s"
material = "gold"
parts = { lid = "iron" }
[[node]]
shape = "f"
parts = { core = "iron" }
)");
    EXPECT_EQ(problems, "");
    ASSERT_EQ(p.materialNames, (std::vector<std::string>{"gold", "iron", "(default)"}));
    const std::vector<std::pair<int, int>> expected{{2, 2}, {0, 0}, {0, 1}, {2, 1}};
    for (int i = 0; i < 4; ++i)
        EXPECT_EQ(std::make_pair(materialOf(p, i, 0), materialOf(p, i, 1)),
                  expected[static_cast<size_t>(i)])
            << "instance " << i;
}

TEST_F(PackScene, NamesUnknownParts) {
    (void)pack(
        "[material.m]\n[shape.s]\nmesh = \"two.obj\"\n[[node]]\nshape = \"s\"\n"
        "parts = { lit = \"m\" }\n");
    EXPECT_EQ(problems,
              "t:6:11: error: shape 's' has no part 'lit' (did you mean 'lid'?); its parts "
              "are 'body', 'lid'");
    (void)pack(
        "[material.m]\n[shape.s]\nsdf = \"f.sdf.glsl\"\n[[node]]\nshape = \"s\"\n"
        "parts = { zebra = \"m\" }\n");
    EXPECT_EQ(problems,
              "t:6:11: error: shape 's' has no part 'zebra'; its parts are 'shell', 'core'");
}

TEST_F(PackScene, GivesParametersToEachInstance) {
    const PackedScene p = pack(
        "[shape.f]\nsdf = \"f.sdf.glsl\"\n[[node]]\nshape = \"f\"\n"
        "[[node]]\nshape = \"f\"\nset = { size = 0.75, tint = \"#ffffff\" }\n");
    EXPECT_EQ(problems, "");
    const auto parameter = [&](int instance, int index) {
        const auto base = static_cast<int>(instanceTexel(p, instance, 6).w);
        return p.tables.at(static_cast<size_t>(p.block.tables.w + base + index));
    };
    EXPECT_EQ(parameter(0, 0).x, 0.5f);
    EXPECT_EQ(vec3(parameter(0, 1)), vec3(0.1f, 0.2f, 0.3f));
    EXPECT_EQ(parameter(1, 0).x, 0.75f);
    EXPECT_EQ(vec3(parameter(1, 1)), vec3(1));
    EXPECT_EQ(instanceTexel(p, 0, 6).x, VITRINE_KIND_FIELD);
    EXPECT_EQ(instanceTexel(p, 1, 6).y, 0) << "both are field 0";
    EXPECT_EQ(vec3(instanceTexel(p, 0, 7)), vec3(-1, -2, -3));
    EXPECT_EQ(vec3(instanceTexel(p, 0, 8)), vec3(1, 2, 3));
    EXPECT_EQ(instanceTexel(p, 0, 7).w, 0.5f) << "1 / lipschitz";
}

TEST_F(PackScene, ExplainsParameterMistakes) {
    (void)pack(R"([material.m]
snippet = "p.mat.glsl"
set = { scale = 9 }
[material.plain]
set = { scale = 1 }
[shape.f]
sdf = "f.sdf.glsl"
[shape.ball]
sphere = {}
[[node]]
shape = "f"
set = { siz = 1, tint = 1 }
[[node]]
shape = "f"
set = { size = [1, 2], tint = "#000000" }
[[node]]
shape = "ball"
set = { size = 1 }
)");
    EXPECT_EQ(problems,
              "t:3:17: error: scale is 9; it must be from 1 to 8\n"
              "t:5:17: error: set gives parameters to a snippet, but the material has none\n"
              "t:12:15: error: f.sdf.glsl has no parameter 'siz' (did you mean 'size'?)\n"
              "t:12:25: error: tint is a vec3; give 3 numbers\n"
              "t:15:16: error: size is a float; give one number\n"
              "t:18:16: error: only an SDF shape has parameters to set");
}

TEST_F(PackScene, PacksAFileOnce) {
    const char* once =
        "[shape.a]\nmesh = \"two.obj\"\n[shape.f]\nsdf = \"f.sdf.glsl\"\n"
        "[material.m]\nsnippet = \"p.mat.glsl\"\n"
        "[[node]]\nshape = \"a\"\n[[node]]\nshape = \"f\"\n";
    const PackedScene single = pack(once);
    const PackedScene twice =
        pack(std::string(once) +
             "[shape.b]\nmesh = \"two.obj\"\n[shape.g]\nsdf = \"f.sdf.glsl\"\n"
             "[material.n]\nsnippet = \"p.mat.glsl\"\n"
             "[[node]]\nshape = \"b\"\n[[node]]\nshape = \"g\"\n");
    EXPECT_EQ(problems, "");
    EXPECT_EQ(single.triangles.size(), 3u);
    EXPECT_EQ(twice.triangles.size(), 3u);
    EXPECT_EQ(twice.vertices, single.vertices);
    EXPECT_EQ(twice.shaders.includes, single.shaders.includes);
    EXPECT_EQ(twice.triangleCount, 6u) << "but instances are counted each";
    EXPECT_EQ(twice.instances.size(), 4u);
    EXPECT_EQ(instanceTexel(twice, 0, 6).y, instanceTexel(twice, 2, 6).y) << "the same root";
}

TEST_F(PackScene, LeavesOutWhatIsNotVisible) {
    const PackedScene p = pack(
        "[shape.a]\nsphere = {}\n[[node]]\nname = \"gone\"\nshape = \"a\"\n"
        "visible = false\nat = [100, 0, 0]\n[[node]]\nname = \"gone, too\"\n"
        "shape = \"a\"\nparent = \"gone\"\n[[node]]\nname = \"group\"\n"
        "[[node]]\nname = \"there\"\nshape = \"a\"\nparent = \"group\"\n");
    EXPECT_EQ(problems, "");
    ASSERT_EQ(p.instances.size(), 1u);
    EXPECT_EQ(p.instances[0].name, "there");
    EXPECT_EQ(p.instances[0].node, 3u);
}

TEST_F(PackScene, WorldBoxesContainTheirMeshes) {
    const PackedScene p = pack(
        "[shape.a]\nmesh = \"two.obj\"\n[[node]]\nname = \"up\"\n"
        "rotate = [10, 20, 30]\nscale = [-2, 1, 1]\n[[node]]\nshape = \"a\"\n"
        "parent = \"up\"\nat = [1, 2, 3]\nrotate = [50, 0, 70]\n"
        "scale = [1, -3, 0.5]\n");
    EXPECT_EQ(problems, "");
    ASSERT_EQ(p.instances.size(), 1u);
    const glm::mat4& m = p.instances[0].worldFromObject;
    EXPECT_GT(glm::determinant(glm::mat3(m)), 0) << "mirrored twice";
    Aabb exact;
    for (const vec3& v : assets.meshes[0]->mesh->positions) exact.grow(vec3(m * vec4(v, 1)));
    const Aabb& box = p.instances[0].worldBox;
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_LE(box.min[axis], exact.min[axis]);
        EXPECT_GE(box.max[axis], exact.max[axis]);
    }
    // The rows in the table undo each other.
    for (int row = 0; row < 3; ++row) {
        const vec4 toWorld = instanceTexel(p, 0, 3 + row), toObject = instanceTexel(p, 0, row);
        const vec4 expected(m[0][row], m[1][row], m[2][row], m[3][row]);
        EXPECT_EQ(toWorld, expected);
        const glm::mat4 inverse = glm::inverse(m);
        EXPECT_EQ(toObject,
                  vec4(inverse[0][row], inverse[1][row], inverse[2][row], inverse[3][row]));
    }
}

TEST_F(PackScene, RefusesScalesBeyondFloats) {
    for (const char* scale : {"1e9", "1e-6"}) {
        std::string text = "[shape.a]\nsphere = {}\n";
        for (int i = 0; i < 8; ++i)
            text += "[[node]]\nname = \"n" + std::to_string(i) + "\"\nscale = " + scale +
                    (i > 0 ? "\nparent = \"n" + std::to_string(i - 1) + "\"\n" : "\n");
        const PackedScene p =
            pack(text + "[[node]]\nname = \"leaf\"\nshape = \"a\"\nparent = \"n7\"\n");
        EXPECT_EQ(problems,
                  "t:34:1: error: with its parents, node 'leaf' is scaled or moved too far");
        EXPECT_TRUE(p.instances.empty());
    }
}

TEST_F(PackScene, ReportsFilesWhereTheSceneNamesThem) {
    write("bad.obj", "v 0 0 0\nf 1 2 3\n");
    write("nobounds.sdf.glsl", "float sdf(vec3 p) { return length(p); }\n");
    fs::create_directory(folder / "dir.obj");
    (void)pack(R"([shape.a]
mesh = "missing.obj"
[shape.b]
mesh = "../two.obj"
[shape.c]
mesh = "/etc/hostname.obj"
[shape.d]
mesh = "two.stl"
[shape.e]
sdf = "f.glsl"
[shape.f]
mesh = "dir.obj"
[shape.g]
mesh = "bad.obj"
[shape.h]
sdf = "nobounds.sdf.glsl"
[material.m]
snippet = "f.glsl"
)");
    EXPECT_EQ(problems,
              "t:2:8: error: 'missing.obj': cannot read: No such file or directory\n"
              "t:4:8: error: '../two.obj': the path leads out of the scene's folder\n"
              "t:6:8: error: '/etc/hostname.obj': the path is absolute; write it relative to the "
              "scene's folder\n"
              "t:8:8: error: a mesh is an .obj, .gltf or .glb file\n"
              "t:10:7: error: the file's name must end in .sdf.glsl\n"
              "t:12:8: error: 'dir.obj': not a regular file\n"
              "bad.obj:2:5: error: vertex 2 does not exist: there is 1 so far\n"
              "t:18:11: error: the file's name must end in .mat.glsl");
}

TEST_F(PackScene, AFieldWithoutBoundsIsNoInstance) {
    write("nobounds.sdf.glsl", "float sdf(vec3 p) { return length(p); }\n");
    const PackedScene p = pack("[shape.e]\nsdf = \"nobounds.sdf.glsl\"\n[[node]]\nshape = \"e\"\n");
    EXPECT_EQ(problems, "nobounds.sdf.glsl: error: the field's bounds are not known");
    EXPECT_TRUE(p.instances.empty());
}

TEST_F(PackScene, WhatTheUserWroteWins) {
    Snippet field;
    field.foundBounds = Aabb{glm::vec3(-2), glm::vec3(2)};
    field.measuredLipschitz = 3;
    EXPECT_EQ(field.box()->max.x, 2);
    EXPECT_EQ(field.stepDivisor(), 3);
    field.bounds = Aabb{glm::vec3(-1), glm::vec3(1)};
    field.lipschitz = 0.5f;
    EXPECT_EQ(field.box()->max.x, 1);
    EXPECT_EQ(field.stepDivisor(), 0.5f);
}

size_t countOf(const std::string& text, const std::string& what) {
    size_t count = 0;
    for (size_t at = 0; (at = text.find(what, at)) != std::string::npos; ++at) ++count;
    return count;
}

TEST_F(PackScene, EachFieldIsDispatchedOnce) {
    write("g.sdf.glsl", "// bounds[-1,-1,-1, 1,1,1]\nfloat sdf(vec3 p) { return length(p); }\n");
    const PackedScene p = pack(
        "[shape.a]\nsdf = \"f.sdf.glsl\"\n[shape.b]\nsdf = \"g.sdf.glsl\"\n"
        "[material.m]\nsnippet = \"p.mat.glsl\"\n"
        "[[node]]\nshape = \"a\"\n[[node]]\nshape = \"b\"\n");
    const std::string& field = p.shaders.includes.at("generated/field.glsl");
    EXPECT_EQ(countOf(field, "if (shape == 0) return f0_sdf(p);"), 1u) << field;
    EXPECT_EQ(countOf(field, "if (shape == 1) return vec2(f1_sdf(p), 0.0);"), 1u);
    EXPECT_EQ(countOf(field, "if (shape == 0) f0bind(base);"), 1u);
    EXPECT_EQ(countOf(field, "if (shape == 1) f1bind(base);"), 1u);
    EXPECT_EQ(countOf(field, "if (shape == "), 4u) << "and nothing else";
    EXPECT_EQ(countOf(field, "f0vvalue0 = fetchParameter(base, 0).x;"), 1u);
    EXPECT_EQ(countOf(field, "f0vvalue1 = fetchParameter(base, 1).xyz;"), 1u);
    const std::string& material = p.shaders.includes.at("generated/material.glsl");
    EXPECT_EQ(countOf(material, "if (number == 1)"), 1u) << material;
    EXPECT_EQ(countOf(material, "if (number == "), 1u);
    ASSERT_EQ(p.shaders.snippets.size(), 3u);
    for (size_t i = 0; i < 3; ++i)
        EXPECT_EQ(p.shaders.snippets[i].options.lineBase, lineBaseOf(static_cast<int>(i)));
}

TEST_F(PackScene, AnEmptySceneIsEmpty) {
    const PackedScene p = pack("");
    EXPECT_EQ(problems, "");
    EXPECT_EQ(p.block.counts.z, -1) << "no tree";
    EXPECT_FALSE(p.hasMeshes || p.hasFields);
    EXPECT_EQ(p.stackBound, 0);
}

}  // namespace
}  // namespace vitrine
