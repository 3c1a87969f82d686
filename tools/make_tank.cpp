// SPDX-License-Identifier: MIT
// make_tank OUTDIR: writes the tank, four meshes as OBJ and their textures as PNG, and
// the chassis in pieces with a scene that drives them. It takes some
// tens of seconds, nearly all of it for the textures. The bytes are the same on every run.
#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <cstdio>
#include <exception>
#include <filesystem>

#include "models/model_files.hpp"
#include "models/tank/drive.hpp"
#include "models/tank/tank.hpp"
#include "models/tank/textures.hpp"

namespace vitrine {
namespace {

void writeTank(const std::filesystem::path& folder) {
    const std::vector<tank::Assembly> tank = tank::makeTank();
    writeText(folder / "drive.toml", tank::driveScene());
    const tank::Occluder occluder = tank::makeOccluder(tank);
    tbb::parallel_for(size_t{0}, tank.size(), [&](size_t i) {
        const tank::Assembly& assembly = tank[i];
        const tank::Atlas atlas = tank::unwrap(assembly, tank::kTextureSide);
        writeModel(folder, tank::toMesh(assembly, atlas));
        if (i == 0)  // the chassis, also piece by piece
            for (const Mesh& mesh : tank::makeDriveMeshes(assembly, atlas))
                writeModel(folder, mesh);
        const tank::Textures textures = tank::makeTextures(assembly, atlas, occluder);
        const auto write = [&](const char* kind, const ImageRgba8& picture) {
            writePicture(folder / fmt::format("{}_{}.png", assembly.name, kind), picture);
        };
        write("albedo", textures.albedo);
        write("normal", textures.normal);
        write("orm", textures.orm);
        write("gloss_metal", textures.glossMetal);
    });
}

}  // namespace
}  // namespace vitrine

int main(int argc, char** argv) try {
    if (argc != 2) {
        std::fputs("usage: make_tank OUTDIR\n", stderr);
        return 2;
    }
    std::filesystem::create_directories(argv[1]);
    vitrine::writeTank(argv[1]);
    return 0;
} catch (const std::exception& problem) {
    fmt::print(stderr, "make_tank: {}\n", problem.what());
    return 3;
}
