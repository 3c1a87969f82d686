// SPDX-License-Identifier: MIT
// docs/sdf.md has what the library has, with a picture of each, and every picture's scene can be
// read. VITRINE_UPDATE_DOCS=1 writes the page anew; the pictures are drawn by make_sdf_pages.sh.
#include "sdf_pages.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <set>

#include "base/file.hpp"
#include "pattern_pages.hpp"

namespace vitrine {
namespace {

namespace fs = std::filesystem;

TEST(SdfPage, IsThePageInDocs) {
    const std::string file = "docs/sdf.md";
    const char* update = std::getenv("VITRINE_UPDATE_DOCS");
    if (update != nullptr && std::string(update) == "1") writeFileAtomically(file, sdfPage());
    EXPECT_EQ(readFile(file, 1 << 20), sdfPage()) << "run this test with VITRINE_UPDATE_DOCS=1";
}

TEST(SdfPage, EveryFunctionHasItsPictureAndNothingElseHas) {
    std::set<std::string> names;
    for (const LibraryFunction& f : sdfLibrary().functions())
        if (!isPattern(f)) names.insert(f.name + ".png");
    uintmax_t bytes = 0;
    for (const fs::directory_entry& file : fs::directory_iterator("docs/sdf")) {
        EXPECT_EQ(names.erase(file.path().filename().string()), 1u) << file.path();
        bytes += file.file_size();
    }
    for (const std::string& name : names) ADD_FAILURE() << "docs/sdf/" << name << " is missing";
    EXPECT_LT(bytes, 1'500'000u) << "pictures are in the repository for ever";
}

TEST(SdfPage, EveryExampleIsAGoodSnippet) {
    for (const LibraryFunction& f : sdfLibrary().functions()) {
        if (isPattern(f)) continue;
        Diagnostics diagnostics;
        const auto snippet =
            parseSnippet(sdfPictureField(f), f.name, SnippetKind::kField, diagnostics);
        ASSERT_TRUE(snippet) << diagnostics.text();
        EXPECT_TRUE(snippet->bounds.has_value()) << f.name;
    }
}

}  // namespace
}  // namespace vitrine
