// SPDX-License-Identifier: MIT
// make_sdf_pages FOLDER writes the scene of each picture of docs/sdf.md and docs/patterns.md into
// FOLDER and prints their names below docs/, one a line. The pages themselves are written by
// tools/sdf_pages_test.cpp and tools/pattern_pages_test.cpp.
#include <fmt/format.h>

#include "base/file.hpp"
#include "pattern_pages.hpp"
#include "sdf_pages.hpp"

int main(int argc, char** argv) {
    if (argc != 2) {
        fmt::print(stderr, "usage: make_sdf_pages FOLDER\n");
        return 2;
    }
    const std::filesystem::path folder = argv[1];
    std::filesystem::create_directories(folder / "sdf");
    std::filesystem::create_directories(folder / "patterns");
    for (const vitrine::LibraryFunction& f : vitrine::sdfLibrary().functions()) {
        const bool pattern = vitrine::isPattern(f);
        const std::string name = (pattern ? "patterns/" : "sdf/") + f.name;
        const auto write = [&](const char* ending, const std::string& text) {
            vitrine::writeFileAtomically(folder / (name + ending), text);
        };
        write(".sdf.glsl", pattern ? vitrine::patternPictureField(f) : vitrine::sdfPictureField(f));
        write(".toml", pattern ? vitrine::patternPictureScene(f) : vitrine::sdfPictureScene(f));
        if (pattern) write(".mat.glsl", vitrine::patternPictureMaterial(f));
        fmt::print("{}\n", name);
    }
    return 0;
}
