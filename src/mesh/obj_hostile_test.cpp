// SPDX-License-Identifier: MIT
// Whatever the bytes are, reading ends soon, and gives a safe mesh or an error with a place.
#include <gtest/gtest.h>

#include <ctime>
#include <random>

#include "mesh/obj.hpp"

namespace vitrine {
namespace {

const std::string kValid =
    "# every kind of statement\nmtllib x.mtl\no body\nv 0 0 0\nv 2 0 0 1.0\nv 2 1e0 0 1 0.5 0\n"
    "v 1 1 0\nv 1 2 0\nv -0.0 +2 0\nvt 0 0\nvt 1 0.5 0\nvn 0 0 1\nvn 0.1 0 -1e2\ng front left\n"
    "s 1\nusemtl glaze\nf 1/1/1 2/2/1 3/1/1 4/2/1 5/1/1 6/2/1\nf -1//-1 -2//-2 -3//-1\r\n"
    "f 1 2 \\\n 3\ns off\nl 1 2\np 3\nf 4/1 5/2 6/1\nvp 1\nf 1 1 2\n";

void expectSafeOrError(const std::string& text) {
    Diagnostics diagnostics;
    const std::optional<Mesh> mesh = readObj(text, "x", diagnostics);
    ASSERT_EQ(mesh.has_value(), !diagnostics.hasErrors());
    ASSERT_LE(diagnostics.list().size(), 30u);
    if (!mesh) return;
    ASSERT_FALSE(mesh->triangles.empty());
    ASSERT_EQ(mesh->normals.size(), mesh->positions.size());
    for (const glm::vec3& p : mesh->positions) ASSERT_TRUE(isFinite(p));
    for (const glm::vec3& n : mesh->normals) ASSERT_NEAR(glm::length(n), 1.0f, 1e-4f);
    for (size_t t = 0; t < mesh->triangles.size(); ++t) {
        ASSERT_LT(mesh->triangleParts[t], mesh->partNames.size());
        for (int k = 0; k < 3; ++k) ASSERT_LT(mesh->triangles[t][k], mesh->positions.size());
    }
}

/// Of the processor, which counts no waiting for other programs.
double secondsToRead(const std::string& text) {
    const std::clock_t start = std::clock();
    expectSafeOrError(text);
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

TEST(ObjHostile, EveryTruncation) {
    // An exact allocation each time, so that the address sanitizer sees a read past the end.
    for (size_t length = 0; length <= kValid.size(); ++length) {
        SCOPED_TRACE(length);
        const std::vector<char> bytes(kValid.begin(),
                                      kValid.begin() + static_cast<ptrdiff_t>(length));
        Diagnostics diagnostics;
        const auto mesh = readObj({bytes.data(), bytes.size()}, "x", diagnostics);
        ASSERT_EQ(mesh.has_value(), !diagnostics.hasErrors());
    }
}

TEST(ObjHostile, RandomMutations) {
    constexpr char kNasty[] = "\0\\\r\n\t /#-+.eE0123456789fvlgns\xff\x80\x1b";
    for (uint32_t seed = 0; seed < 20000; ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937 random(seed);
        std::string text = kValid;
        for (auto i = 0ul, edits = 1 + random() % 6; i < edits; ++i) {
            const size_t at = random() % text.size();
            const char byte = random() % 4 == 0 ? static_cast<char>(random())
                                                : kNasty[random() % (sizeof kNasty - 1)];
            switch (random() % 4) {
                case 0:
                    text.insert(at, 1, byte);
                    break;
                case 1:
                    text.erase(at, 1 + random() % 3);
                    break;
                case 2:
                    text.insert(at, text.substr(random() % text.size(), random() % 40));
                    break;
                default:
                    text[at] = byte;
            }
        }
        expectSafeOrError(text);
        if (HasFatalFailure()) return;
    }
}

TEST(ObjHostile, TimeStaysProportional) {
    std::string continued = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3";
    for (int i = 0; i < 500000; ++i) continued += " \\\n";
    EXPECT_LT(secondsToRead(continued), 5.0) << "line continuations";

    EXPECT_LT(secondsToRead(std::string(5'000'000, ' ')), 5.0) << "one long line";
    EXPECT_LT(secondsToRead("v " + std::string(5'000'000, '1')), 5.0) << "one long number";
    EXPECT_LT(secondsToRead("f" + std::string(5'000'000, '/')), 5.0) << "one long corner";

    // One position with many normals: a list per position would take quadratic time.
    std::string hub = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    for (int i = 1; i <= 100000; ++i) hub += "vn 0 0 1\nf 1//" + std::to_string(i) + " 2//1 3//1\n";
    EXPECT_LT(secondsToRead(hub), 5.0) << "one vertex in many versions";

    // Combs have as many inward as outward corners, and can be repeated at little cost in bytes.
    std::string combs, face = "f";
    for (int i = 0; i < 1024; ++i) {
        const std::string x = std::to_string(i);
        combs += "v " + x + " 0 0\nv " + x + ".4 9 0\nv " + x + ".5 9 0\nv " + x + ".9 0 0\n";
    }
    combs += "v 1024 0 0\nv 0 -9 0\n";
    for (int i = 1; i <= 4094; ++i) face += " " + std::to_string(i);
    for (int i = 0; i < 100; ++i) combs += face + "\n";
    EXPECT_LT(secondsToRead(combs), 20.0) << "large concave polygons";
}

TEST(ObjHostile, LargeFilesAreFast) {
    std::string grid;
    constexpr int kSide = 300;
    for (int y = 0; y <= kSide; ++y)
        for (int x = 0; x <= kSide; ++x)
            grid += "v " + std::to_string(x * 0.0123456) + " " + std::to_string(y * 0.0123456) +
                    " " + std::to_string((x * x + y * y) * 1e-4) + "\n";
    for (int y = 0; y < kSide; ++y)
        for (int x = 1; x <= kSide; ++x) {
            const int a = y * (kSide + 1) + x, b = a + kSide + 1;
            grid += "f " + std::to_string(a) + " " + std::to_string(a + 1) + " " +
                    std::to_string(b + 1) + " " + std::to_string(b) + "\n";
        }
    const double seconds = secondsToRead(grid);
    RecordProperty("bytes", std::to_string(grid.size()));
    RecordProperty("seconds", std::to_string(seconds));
    EXPECT_LT(seconds, 5.0) << grid.size() << " bytes";
}

}  // namespace
}  // namespace vitrine
