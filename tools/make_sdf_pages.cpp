// SPDX-License-Identifier: MIT
// make_sdf_pages FOLDER writes the scene of each picture of docs/sdf.md into FOLDER and prints
// their names, one a line. The page itself is written by tools/sdf_pages_test.cpp.
#include <fmt/format.h>

#include "base/file.hpp"
#include "sdf_pages.hpp"

int main(int argc, char** argv) {
    if (argc != 2) {
        fmt::print(stderr, "usage: make_sdf_pages FOLDER\n");
        return 2;
    }
    const std::filesystem::path folder = argv[1];
    for (const vitrine::LibraryFunction& f : vitrine::sdfLibrary().functions()) {
        vitrine::writeFileAtomically(folder / (f.name + ".sdf.glsl"), vitrine::sdfPictureField(f));
        vitrine::writeFileAtomically(folder / (f.name + ".toml"), vitrine::sdfPictureScene(f));
        fmt::print("{}\n", f.name);
    }
    return 0;
}
