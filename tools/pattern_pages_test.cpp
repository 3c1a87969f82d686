// SPDX-License-Identifier: MIT
// docs/patterns.md has what shaders/lib/material has, with a picture of each.
// VITRINE_UPDATE_DOCS=1 writes the page anew; the pictures are drawn by make_sdf_pages.sh.
#include "pattern_pages.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <set>

#include "base/file.hpp"

namespace vitrine {
namespace {

namespace fs = std::filesystem;

TEST(PatternPage, IsThePageInDocs) {
    const std::string file = "docs/patterns.md";
    const char* update = std::getenv("VITRINE_UPDATE_DOCS");
    if (update != nullptr && std::string(update) == "1") writeFileAtomically(file, patternPage());
    EXPECT_EQ(readFile(file, 1 << 20), patternPage()) << "run this test with VITRINE_UPDATE_DOCS=1";
    for (const LibraryFunction& f : sdfLibrary().functions()) {
        if (isPattern(f)) {
            EXPECT_NE(patternPage().find("`" + f.signature + "`"), std::string::npos) << f.name;
        }
    }
}

TEST(PatternPage, EveryFunctionHasItsPictureAndNothingElseHas) {
    std::set<std::string> names;
    for (const LibraryFunction& f : sdfLibrary().functions())
        if (isPattern(f)) names.insert(f.name + ".png");
    uintmax_t bytes = 0;
    for (const fs::directory_entry& file : fs::directory_iterator("docs/patterns")) {
        EXPECT_EQ(names.erase(file.path().filename().string()), 1u) << file.path();
        bytes += file.file_size();
    }
    for (const std::string& name : names)
        ADD_FAILURE() << "docs/patterns/" << name << " is missing";
    EXPECT_LT(bytes, 600'000u) << "pictures are in the repository for ever";
}

TEST(PatternPage, EveryPatternIsAGoodSnippet) {
    for (const LibraryFunction& f : sdfLibrary().functions()) {
        if (!isPattern(f)) continue;
        Diagnostics diagnostics;
        const auto material =
            parseSnippet(patternPictureMaterial(f), f.name, SnippetKind::kMaterial, diagnostics);
        ASSERT_TRUE(material) << diagnostics.text();
        EXPECT_TRUE(material->libraryFunctions.contains(f.name)) << f.name << " shows another";
        EXPECT_TRUE(parseSnippet(patternPictureField(f), f.name, SnippetKind::kField, diagnostics))
            << diagnostics.text();
    }
}

}  // namespace
}  // namespace vitrine
