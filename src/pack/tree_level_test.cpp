// SPDX-License-Identifier: MIT
#include "pack/tree_level.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>

#include "bvh/test_meshes.hpp"
#include "mesh/obj.hpp"
#include "pack/tree_options.hpp"

namespace vitrine {
namespace {

std::shared_ptr<const MeshAsset> assetOf(const test::Mesh& mesh, TreeBuilder builder) {
    auto asset = std::make_shared<MeshAsset>();
    vitrine::Mesh shape;
    shape.positions = mesh.positions;
    shape.triangles = mesh.triangles;
    asset->mesh = std::make_shared<vitrine::Mesh>(std::move(shape));
    TreeSettings settings;
    settings.builder = builder;
    asset->bvh = buildTriangleBvh(mesh.positions, mesh.triangles, buildOptions(settings));
    return asset;
}

/// Two instances of one mesh, one of them a mirror image, a flat square and a field.
std::vector<PackedInstance> instances(TreeBuilder builder) {
    test::Random random(41);
    const auto soup = assetOf(test::soup(random, 400, 1, 0.2f), builder);
    test::Mesh square;
    square.add({-3, -2, -3}, {3, -2, -3}, {3, -2, 3});
    square.add({-3, -2, -3}, {3, -2, 3}, {-3, -2, 3});
    const auto flat = assetOf(square, builder);
    glm::mat4 turned = glm::rotate(glm::mat4(1), 0.7f, glm::normalize(glm::vec3(1, 2, 3)));
    turned = glm::scale(glm::translate(glm::mat4(1), glm::vec3(5, 1, 0)) * turned,
                        glm::vec3(-1, 2, 0.5f));
    const Aabb bounds{{-1, -1, -1}, {1, 2, 1}};
    return {{"first", 0, glm::mat4(1), {}, false, 0, 400, soup->bvh.box(), soup},
            {"second one", 1, turned, {}, false, 0, 400, soup->bvh.box(), soup},
            {"flat", 2, glm::mat4(1), {}, false, 400, 2, flat->bvh.box(), flat},
            {"", 3, glm::translate(glm::mat4(1), glm::vec3(0, 9, 0)), {}, true, 0, 0, bounds, {}}};
}

bool contains(const Aabb& box, const glm::vec3& p, float slack) {
    return glm::all(glm::greaterThanEqual(p, box.min - slack)) &&
           glm::all(glm::lessThanEqual(p, box.max + slack));
}

TEST(TreeLevel, LevelZeroIsOneBoxAnInstance) {
    const auto list = instances(TreeBuilder::kBinned);
    const TreeLevel level = treeLevel(list, 0);
    ASSERT_EQ(level.boxes.size(), list.size());
    for (uint32_t i = 0; i < list.size(); ++i) {
        EXPECT_EQ(level.firstBox[i], i);
        EXPECT_EQ(level.boxes[i].instance, i);
        EXPECT_EQ(level.boxes[i].box.min, list[i].objectBox.min);
        EXPECT_EQ(level.boxes[i].box.max, list[i].objectBox.max);
        EXPECT_EQ(level.boxes[i].lonely, i == 2);
    }
}

TEST(TreeLevel, TrianglesAreInTheirBoxes) {
    for (const TreeBuilder builder : {TreeBuilder::kNine, TreeBuilder::kBinned}) {
        const auto list = instances(builder);
        for (const int depth : {0, 1, 4, 63}) {
            const TreeLevel level = treeLevel(list, depth);
            EXPECT_EQ(level.boxOfTriangle.size(), 402u);
            EXPECT_EQ(level.firstBox.back(), level.boxes.size());
            for (size_t i = 0; i < 3; ++i) {
                const Mesh& mesh = *list[i].mesh->mesh;
                for (size_t t = 0; t < mesh.triangles.size(); ++t) {
                    const uint32_t box =
                        level.firstBox[i] +
                        level.boxOfTriangle[static_cast<size_t>(list[i].firstTriangle) + t];
                    ASSERT_LT(box, level.firstBox[i + 1]);
                    ASSERT_EQ(level.boxes[box].instance, i);
                    for (int c = 0; c < 3; ++c)
                        ASSERT_TRUE(contains(level.boxes[box].box,
                                             mesh.positions[mesh.triangles[t][c]], 0));
                }
            }
        }
    }
}

TEST(TreeLevel, TooManyBoxesAreRefused) {
    std::vector<PackedInstance> many(3000, instances(TreeBuilder::kBinned)[0]);
    EXPECT_EQ(treeLevel(many, 0).boxes.size(), 3000u);
    many.resize(kMaxTreeBoxes / treeLevel({many.data(), 1}, kMaxTreeLevel).boxes.size() + 1,
                many[0]);
    EXPECT_THROW((void)treeLevel(many, kMaxTreeLevel), UsageError);
}

/// The exported file read back by our own reader, in boxes of each part.
struct ReadBack {
    Mesh mesh;
    std::vector<size_t> triangles;  ///< by part
};

ReadBack readBack(const std::string& text) {
    Diagnostics diagnostics;
    auto mesh = readObj(text, "boxes.obj", diagnostics);
    EXPECT_EQ(diagnostics.text(), "");
    ReadBack result;
    if (!mesh) return result;
    result.mesh = std::move(*mesh);
    result.triangles.resize(result.mesh.partNames.size());
    for (const uint32_t part : result.mesh.triangleParts) ++result.triangles.at(part);
    return result;
}

TEST(TreeLevel, TheObjHoldsAllBoxesAndTheyHoldAllTriangles) {
    for (const TreeBuilder builder :
         {TreeBuilder::kNine, TreeBuilder::kBinned, TreeBuilder::kSpatial}) {
        const auto list = instances(builder);
        for (const int depth : {0, 3, 6}) {
            SCOPED_TRACE(depth);
            const TreeLevel level = treeLevel(list, depth);
            const ReadBack read = readBack(objOfTreeLevel(list, level));
            ASSERT_EQ(read.mesh.partNames, (std::vector<std::string>{"0_first", "1_second_one",
                                                                     "2_flat", "3_instance"}));
            for (size_t i = 0; i < list.size(); ++i) {
                // Twelve triangles a box; the flat one has its two sides.
                const size_t boxes = level.firstBox[i + 1] - level.firstBox[i];
                EXPECT_EQ(read.triangles[i], i == 2 ? 4 : 12 * boxes);
            }
            // Box by box, back in object space: triangle corners are in one of them.
            for (size_t i = 0; i < 2; ++i) {
                const glm::mat4 objectFromWorld = glm::inverse(list[i].worldFromObject);
                std::vector<Aabb> boxes(level.firstBox[i + 1] - level.firstBox[i]);
                size_t seen = 0;
                for (size_t t = 0; t < read.mesh.triangles.size(); ++t) {
                    if (read.mesh.triangleParts[t] != i) continue;
                    for (int c = 0; c < 3; ++c)
                        boxes[seen / 12].grow(glm::vec3(
                            objectFromWorld *
                            glm::vec4(read.mesh.positions[read.mesh.triangles[t][c]], 1)));
                    ++seen;
                }
                const Mesh& mesh = *list[i].mesh->mesh;
                for (const glm::uvec3& t : mesh.triangles)
                    for (int c = 0; c < 3; ++c)
                        ASSERT_TRUE(std::any_of(boxes.begin(), boxes.end(), [&](const Aabb& box) {
                            return contains(box, mesh.positions[t[c]], 1e-5f);
                        }));
            }
        }
    }
}

TEST(TreeLevel, FacesOfTheObjLookOutwards) {
    const auto list = instances(TreeBuilder::kBinned);
    const ReadBack read = readBack(objOfTreeLevel(list, treeLevel(list, 0)));
    const Mesh& mesh = read.mesh;
    for (size_t part = 0; part < 4; ++part) {
        glm::vec3 centre(0);
        float corners = 0, volume = 0;
        for (int pass = 0; pass < 2; ++pass)
            for (size_t t = 0; t < mesh.triangles.size(); ++t) {
                if (mesh.triangleParts[t] != part) continue;
                const glm::vec3 a = mesh.positions[mesh.triangles[t].x];
                const glm::vec3 b = mesh.positions[mesh.triangles[t].y];
                const glm::vec3 c = mesh.positions[mesh.triangles[t].z];
                if (pass == 0) {
                    centre += a + b + c;
                    corners += 3;
                } else {
                    const glm::vec3 o = centre / corners;
                    const float part6 = glm::dot(a - o, glm::cross(b - o, c - o));
                    EXPECT_GE(part6, -1e-5f) << "part " << part;
                    volume += part6 / 6;
                }
            }
        const glm::vec3 e = list[part].objectBox.extent();
        const float scale = std::abs(glm::determinant(glm::mat3(list[part].worldFromObject)));
        EXPECT_NEAR(volume, e.x * e.y * e.z * scale, 1e-3f * (1 + volume));
    }
}

}  // namespace
}  // namespace vitrine
