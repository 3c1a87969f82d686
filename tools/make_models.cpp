// SPDX-License-Identifier: MIT
// make_models OUTDIR: writes the models that the scenes use, as OBJ. The bytes are the same on
// every run.
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <filesystem>

#include "models/ammonite.hpp"
#include "models/model_files.hpp"

int main(int argc, char** argv) try {
    if (argc != 2) {
        std::fputs("usage: make_models OUTDIR\n", stderr);
        return 2;
    }
    std::filesystem::create_directories(argv[1]);
    vitrine::writeModel(argv[1], vitrine::makeAmmonite());
    return 0;
} catch (const std::exception& problem) {
    fmt::print(stderr, "make_models: {}\n", problem.what());
    return 3;
}
