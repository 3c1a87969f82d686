// SPDX-License-Identifier: MIT
#include "mesh/obj.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <locale>

namespace vitrine {
namespace {

const std::string kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

struct Read {
    std::optional<Mesh> mesh;
    std::string messages;
};

Read read(const std::string& text, const ObjLimits& limits = {}) {
    Diagnostics diagnostics;
    Read result{readObj(text, "a.obj", diagnostics, limits), ""};
    result.messages = diagnostics.text();
    EXPECT_EQ(result.mesh.has_value(), !diagnostics.hasErrors());
    return result;
}

TEST(Obj, ReadsPositionsUvsAndNormals) {
    const Read r = read(
        "o thing\nv 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0\n"
        "vt 0 0\nvt 1 0 0\nvt 0.5\nvn 0 0 2\nf 1/1/1 2/2/1 3/3/1\n");
    EXPECT_EQ(r.messages, "");
    ASSERT_TRUE(r.mesh);
    EXPECT_EQ(r.mesh->name, "thing");
    EXPECT_EQ(r.mesh->positions, (std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    EXPECT_EQ(r.mesh->uvs, (std::vector<glm::vec2>{{0, 0}, {1, 0}, {0.5f, 0}}));
    EXPECT_EQ(r.mesh->normals, std::vector<glm::vec3>(3, {0, 0, 1}));
    EXPECT_EQ(r.mesh->triangles, (std::vector<glm::uvec3>{{0, 1, 2}}));
    EXPECT_EQ(r.mesh->partNames, std::vector<std::string>{"thing"});
}

TEST(Obj, SpellingsOfTheSameTriangle) {
    const char* texts[] = {
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3",
        "\xef\xbb\xbfv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
        "v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\n\r\nf 1 2 3\r\n",
        "v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r",
        "  v\t0  0\t0 \n\n\tv 1 0 0\nv 0 1 0\nf  1\t2 3  \n",
        "# head\nv 0 0 0 # here\nv 1 0 0\n#v 9 9 9\nv 0 1 0\nf 1 2 3 #x\n",
        "v 0 \\\n 0 0\nv 1 0 0\nv 0 1 0\nf 1 \\\r\n2 \\\n3\n",
        "v 0e0 .0 0.\nv +1.0E+00 -0 1e-99999\nv 0 1e0 0\nf 1 2 3\n",
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\n",
        "v 9 9 9\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 4\nv 5 5 5",
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nvt 0 0\nf 1/ 2// -1//-1\n",
    };
    for (const char* text : texts) {
        SCOPED_TRACE(text);
        const Read r = read(text);
        EXPECT_EQ(r.messages, "");
        ASSERT_TRUE(r.mesh);
        EXPECT_EQ(r.mesh->positions, (std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
        EXPECT_EQ(r.mesh->normals, std::vector<glm::vec3>(3, {0, 0, 1}));
    }
}

/// Built here, because no machine need have a German locale installed.
struct DecimalComma : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
};

TEST(Obj, NumbersDoNotDependOnTheLocale) {
    const std::locale before = std::locale::global(std::locale(std::locale(), new DecimalComma));
    const Read r = read("v 0.5 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    std::locale::global(before);
    ASSERT_TRUE(r.mesh);
    EXPECT_EQ(r.mesh->positions[0].x, 0.5f);
}

TEST(Obj, PartsAreNamedAfterMaterialThenGroupThenObject) {
    const Read r = read(
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
        "o body\nf 1 2 3\ng wing\nf 1 2 3\nusemtl red paint\nf 1 2 3\n"
        "g other\nf 1 2 3\nusemtl\nf 1 2 3\nusemtl red paint # again\nf 1 2 3\n");
    ASSERT_TRUE(r.mesh);
    EXPECT_EQ(r.mesh->partNames,
              (std::vector<std::string>{"default", "body", "wing", "red paint", "other"}));
    EXPECT_EQ(r.mesh->triangleParts, (std::vector<uint32_t>{0, 1, 2, 3, 3, 4, 3}));
}

TEST(Obj, CornersThatAreEqualBecomeOneVertex) {
    const Read r = read(
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 1\nvn 0 0 1\n"
        "f 1/1/1 2/1/1 3/1/1\nf 1/1/1 3/1/1 4/1/1\nf 1/2/1 3/1/1 4/1/1\n");
    ASSERT_TRUE(r.mesh);
    EXPECT_EQ(r.mesh->positions.size(), 5u) << "corner 1 has two texture coordinates";
    EXPECT_EQ(r.mesh->triangles[1], glm::uvec3(0, 2, 3));
    EXPECT_EQ(r.mesh->triangles[2], glm::uvec3(4, 2, 3));
}

TEST(Obj, OneVertexForEachTextureCoordinateOfAPlace) {
    std::string text = kTriangle;
    for (int i = 1; i <= 3000; ++i) {
        const std::string n = std::to_string(i);
        text += "vt " + n + "\nf 1/" + n + " 2 3\nf 3 1/" + n + " 2\n";
    }
    const Read r = read(text);
    ASSERT_TRUE(r.mesh);
    EXPECT_EQ(r.mesh->positions.size(), 3002u);
    EXPECT_EQ(r.mesh->uvs[r.mesh->triangles[2468].x].x, 1235.0f);
}

TEST(Obj, ConcavePolygonIsCutRight) {
    const Read r = read("v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nf 1 2 3 4 5 6\n");
    ASSERT_TRUE(r.mesh);
    ASSERT_EQ(r.mesh->triangles.size(), 4u);
    float area = 0.0f;
    for (const glm::uvec3& v : r.mesh->triangles) {
        const glm::vec3 a = r.mesh->positions[v.x];
        const float z = glm::cross(r.mesh->positions[v.y] - a, r.mesh->positions[v.z] - a).z;
        EXPECT_GT(z, 0.0f);
        area += 0.5f * z;
    }
    EXPECT_FLOAT_EQ(area, 3.0f);
}

TEST(Obj, NormalsAreMadeOnlyWhereMissing) {
    const Read r = read(
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvn 1 0 0\n"
        "f 1//1 2//1 3//1\nf 1 4 2\n");
    ASSERT_TRUE(r.mesh);
    EXPECT_EQ(r.mesh->normals[r.mesh->triangles[0].x], glm::vec3(1, 0, 0));
    EXPECT_EQ(r.mesh->normals[r.mesh->triangles[1].x], glm::vec3(0, 1, 0));
}

TEST(Obj, SmoothingGroupsDecideGeneratedNormals) {
    const std::string roof = "v 0 0 0\nv 0 0 1\nv 1 -0.2 0\nv -1 -0.2 0\n";
    const std::string faces = "f 1 2 3\nf 2 1 4\n";
    EXPECT_EQ(read(roof + faces).mesh->positions.size(), 4u);
    EXPECT_EQ(read(roof + "s off\n" + faces).mesh->positions.size(), 6u);
    EXPECT_EQ(read(roof + "s 0\n" + faces).mesh->positions.size(), 6u);
    EXPECT_EQ(read(roof + "s 7\n" + faces).mesh->positions.size(), 4u);
    EXPECT_EQ(read(roof + "s 1\nf 1 2 3\ns 2\nf 2 1 4\n").mesh->positions.size(), 6u);
    // A triangle that is dropped must not shift the groups of those behind it.
    EXPECT_EQ(read(roof + "s off\nf 1 1 2\ns 1\n" + faces).mesh->positions.size(), 4u);
}

struct Case {
    std::string text, messages;
};

TEST(Obj, SaysWhatIsWrongAndWhere) {
    const Case cases[] = {
        {"", "a.obj: error: the mesh has no triangles"},
        {kTriangle, "a.obj: error: the mesh has no triangles"},
        {"v 0 0\n", "a.obj:1:1: error: v needs 3 numbers, this one has 2"},
        {"\n  vt\n", "a.obj:2:3: error: vt needs 1 number, this one has 0"},
        {"v 0 1,5 0\n", "a.obj:1:5: error: '1,5' is not a number"},
        {"v 0 - 0\n", "a.obj:1:5: error: '-' is not a number"},
        {"v 0 +-1 0\n", "a.obj:1:5: error: '+-1' is not a number"},
        {"v 0 0x1p3 0\n", "a.obj:1:5: error: '0x1p3' is not a number"},
        {kTriangle + "f 1 2\n",
         "a.obj:4:1: error: a face needs at least 3 corners, this one has 2"},
        {kTriangle + "f\n", "a.obj:4:1: error: a face needs at least 3 corners, this one has 0"},
        {kTriangle + "f 1 0 3\n",
         "a.obj:4:5: error: vertex 0 does not exist: indices count from 1"},
        {kTriangle + "f 1 2 4\n", "a.obj:4:7: error: vertex 4 does not exist: there are 3 so far"},
        {kTriangle + "f 1 2 -4\n",
         "a.obj:4:7: error: vertex -4 does not exist: there are 3 so far"},
        {kTriangle + "f 1 2 \\\n 99999999999999999999\n",
         "a.obj:5:2: error: vertex 99999999999999999999 does not exist: there are 3 so far"},
        {kTriangle + "f 1 2 4294967297\n",
         "a.obj:4:7: error: vertex 4294967297 does not exist: there are 3 so far"},
        {kTriangle + "vt 0 0\nf 1/1 2/2 3/1\n",
         "a.obj:5:7: error: texture coordinate 2 does not exist: there is 1 so far"},
        {kTriangle + "f 1//1 2//1 3//1\n",
         "a.obj:4:3: error: normal 1 does not exist: there are 0 so far"},
        {kTriangle + "f 1 2 3.5\n",
         "a.obj:4:7: error: '3.5' is not a corner: expected v, v/vt, v//vn or v/vt/vn with whole "
         "numbers"},
        {kTriangle + "f 1 2 /1\nf 1/1/1/1 2 3\n",
         "a.obj:4:7: error: '/1' is not a corner: expected v, v/vt, v//vn or v/vt/vn with whole "
         "numbers\n"
         "a.obj:5:3: error: '1/1/1/1' is not a corner: expected v, v/vt, v//vn or v/vt/vn with "
         "whole numbers"},
        {kTriangle + std::string("f 1 2\0 3\n", 9),
         "a.obj:4:6: error: a NUL byte: this is not a text file"},
        {kTriangle + "f 1 1 2\n",
         "a.obj: warning: 1 triangle dropped: no area\n"
         "a.obj: error: the mesh has no usable triangle left"},
        {kTriangle + "v nan 0 0\nv 0 inf 0\nv 0 0 -1e999\nf 1 2 3\nf 1 2 4\nf 1 2 5\nf 1 2 6\n",
         "a.obj: warning: 3 triangles dropped: infinite, huge or not-a-number coordinates"},
        {kTriangle + "f 1 2 3\nl 1 2\np 1\n",
         "a.obj:5:1: warning: 2 line or point statements skipped"},
        {"mtllib ../../etc/passwd\nmtllib b.mtl\n" + kTriangle + "f 1 2 3\n",
         "a.obj:1:1: warning: mtllib is not read: the scene file gives materials to parts"},
        {kTriangle + "f 1 2 3\nvp 0 0\n call x.obj \ns \x1b[2J\n",
         "a.obj:5:1: warning: 3 statements not understood, the first is 'vp'"},
        {kTriangle + "f 1 2 3\n\x1b[2J\xff" + std::string(60, 'x') + "\n",
         "a.obj:5:1: warning: 1 statement not understood, the first is '_[2J_" +
             std::string(35, 'x') + "...'"},
        {"g " + std::string(257, 'n') + "\n", "a.obj:1:3: error: a name of more than 256 bytes"},
    };
    for (const Case& c : cases) {
        SCOPED_TRACE(c.text);
        EXPECT_EQ(read(c.text).messages, c.messages);
    }
}

TEST(Obj, ManyErrorsAreCappedAndCounted) {
    std::string text = kTriangle;
    for (int i = 0; i < 25; ++i) text += "f 1 2 9\n";
    const std::string messages = read(text).messages;
    EXPECT_EQ(std::count(messages.begin(), messages.end(), '\n'), 20);
    EXPECT_NE(messages.find("a.obj:23:7: error"), messages.npos);
    EXPECT_EQ(messages.find("a.obj:24:7: error"), messages.npos);
    EXPECT_TRUE(messages.ends_with("\na.obj: error: and 5 more errors")) << messages;
}

TEST(Obj, BrokenNamesAreCleaned) {
    const Read r = read(kTriangle + "g na\x07me \xc3\xa4\nf 1 2 3\ng \xe4\nf 1 2 3\n");
    ASSERT_TRUE(r.mesh);
    EXPECT_EQ(r.mesh->partNames, (std::vector<std::string>{"na_me \xc3\xa4", "_"}));
}

TEST(Obj, BudgetsStopTheReading) {
    const auto with = [](auto set) {
        ObjLimits limits;
        set(limits);
        return limits;
    };
    const std::string quad = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
    EXPECT_EQ(read(quad, with([](ObjLimits& l) { l.vertices = 3; })).messages,
              "a.obj:4:1: error: more than 3 v statements");
    EXPECT_EQ(read(quad + "vt 0\nvt 1\nvt 2\nf 1/1 2/1 3/1\nf 1/2 2/2 4/2\n",
                   with([](ObjLimits& l) { l.vertices = 4; }))
                  .messages,
              "a.obj:9:1: error: more than 4 different corners");
    EXPECT_EQ(read(quad + "f 1 2 3 4\n", with([](ObjLimits& l) { l.triangles = 1; })).messages,
              "a.obj:5:1: error: more than 1 triangles");
    EXPECT_EQ(
        read(quad + "f 1 2 3 4\nf 1 2 3\n", with([](ObjLimits& l) { l.corners = 3; })).messages,
        "a.obj:5:1: error: a face of more than 3 corners");
    EXPECT_EQ(read(quad + "g a\nf 1 2 3\ng b\nf 1 2 3\n", with([](ObjLimits& l) { l.parts = 1; }))
                  .messages,
              "a.obj:8:1: error: more than 1 parts");
    EXPECT_EQ(read("v 0 0 0\nv 4 3 0\nv 0 1 0\nv -4 3 0\nf 1 2 3 4\n",
                   with([](ObjLimits& l) { l.earTests = 1; }))
                  .messages,
              "a.obj:5:1: error: too many large concave polygons: cut them into triangles "
              "beforehand");
}

}  // namespace
}  // namespace vitrine
