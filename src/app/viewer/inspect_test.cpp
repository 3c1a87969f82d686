// SPDX-License-Identifier: MIT
#include "app/viewer/inspect.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "base/file.hpp"
#include "pack/hit_record.hpp"
#include "scene/parse.hpp"

namespace vitrine {
namespace {

namespace fs = std::filesystem;

class InspectTest : public testing::Test {
  protected:
    void SetUp() override {
        std::string name = fs::temp_directory_path() / "vitrine-inspect-XXXXXX";
        ASSERT_NE(::mkdtemp(name.data()), nullptr);
        folder_ = name;
        writeFileAtomically(folder_ / "two.obj",
                            "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
                            "usemtl body\nf 1 2 3\nusemtl lid\nf 1 2 4\nf 1 3 4\n");
        writeFileAtomically(folder_ / "f.sdf.glsl",
                            "// bounds[-1, -1, -1,  1, 1, 1]\n// parts[shell, core]\n"
                            "vec2 sdf(vec3 p) { return vec2(length(p) - 0.5, 0.0); }\n");
        Diagnostics diagnostics;
        const Scene scene = parseScene(R"([material.gold]
[material.iron]
[shape.s]
mesh = "two.obj"
[shape.f]
sdf = "f.sdf.glsl"
[[node]]
name = "box"
shape = "s"
material = "gold"
parts = { lid = "iron" }
[[node]]
name = "blob"
shape = "f"
parts = { core = "iron" }
)",
                                       (folder_ / "t").string(), {}, diagnostics);
        const Assets assets = loadAssets(scene, diagnostics);
        packed_ = packScene(scene, assets, diagnostics);
        ASSERT_EQ(diagnostics.text(), "");
    }
    void TearDown() override { fs::remove_all(folder_); }

    [[nodiscard]] std::string fact(const glm::uvec4& record, const std::string& name) const {
        for (const auto& [key, value] : inspect(packed_, packed_, record, {1, 2, 3}, {0, 0, -1}))
            if (key == name) return value;
        return "";
    }
    fs::path folder_;
    PackedScene packed_;
};

TEST_F(InspectTest, TellsPartAndMaterialOfEachTriangle) {
    int lids = 0;
    for (unsigned triangle = 0; triangle < 3; ++triangle) {
        const glm::uvec4 hit = record::packHit(0, triangle, 0, 2.5f);
        EXPECT_EQ(fact(hit, "node"), "box");
        EXPECT_EQ(fact(hit, "triangle"), std::to_string(triangle) + " of 3");
        const bool lid = fact(hit, "part") == "1 (lid)";
        EXPECT_TRUE(lid || fact(hit, "part") == "0 (body)") << fact(hit, "part");
        EXPECT_EQ(fact(hit, "material"), lid ? "iron" : "gold");
        EXPECT_EQ(fact(hit, "distance"), "2.5 m");
        EXPECT_EQ(fact(hit, "position"), "1  2  0.5");
        lids += lid ? 1 : 0;
    }
    EXPECT_EQ(lids, 2);
}

TEST_F(InspectTest, TellsPartAndMaterialOfAField) {
    const glm::uvec4 core = record::packHit(1, record::packPart(1, -3), 0, 1);
    EXPECT_EQ(fact(core, "node"), "blob");
    EXPECT_EQ(fact(core, "part"), "1 (core)");
    EXPECT_EQ(fact(core, "material"), "iron");
    EXPECT_EQ(fact(record::packHit(1, 0, 0, 1), "material"), "(default)");
}

TEST_F(InspectTest, WhatDoesNotFitTheSceneIsNothing) {
    for (const glm::uvec4& record : {record::missRecord(), record::noRecord(),
                                     record::packHit(2, 0, 0, 1), record::packHit(0, 3, 0, 1)})
        EXPECT_EQ(fact(record, ""), "nothing");
}

}  // namespace
}  // namespace vitrine
