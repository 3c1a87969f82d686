// SPDX-License-Identifier: MIT
#include "scene/heading.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include "base/file.hpp"
#include "scene/parse.hpp"

namespace vitrine {
namespace {

SceneHeading headingOf(std::string_view text) {
    const auto file = std::filesystem::temp_directory_path() /
                      ("vitrine-heading-" + std::to_string(::getpid()) + ".toml");
    writeFileAtomically(file, text);
    SceneHeading heading = readHeading(file);
    std::filesystem::remove(file);
    return heading;
}

TEST(SceneHeading, IsWhatTheWholeSceneSays) {
    for (const char* name : {"lesson-both", "robot", "tank"}) {
        const std::string file = std::string("scenes/") + name + ".toml";
        const SceneHeading heading = readHeading(file);
        Diagnostics diagnostics;
        const Scene scene = parseScene(readFile(file, 1 << 20), file, {}, diagnostics);
        EXPECT_EQ(heading.title, scene.title);
        EXPECT_EQ(heading.description, scene.description);
        EXPECT_FALSE(heading.title.empty() || heading.description.empty()) << file;
    }
}

TEST(SceneHeading, IsEmptyWhereThereIsNone) {
    for (const char* text : {"", "[scene]\n", "scene = 3\n", "[scene]\ntitle = 3\n", "[scene\n",
                             "[[scene]]\ntitle = 'x'\n", "\xff\xfe"}) {
        const SceneHeading heading = headingOf(text);
        EXPECT_EQ(heading.title + heading.description, "") << text;
    }
    EXPECT_EQ(readHeading("/nowhere/a.toml").title, "");
    EXPECT_EQ(readHeading("/tmp").title, "");
}

}  // namespace
}  // namespace vitrine
