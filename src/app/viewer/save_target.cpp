// SPDX-License-Identifier: MIT
#include "app/viewer/save_target.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "app/viewer/folder_list.hpp"
#include "base/text.hpp"

namespace vitrine {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kEnding = ".toml";

fs::path folderOf(const fs::path& file) {
    return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

std::string realPath(const fs::path& path) {
    std::error_code error;
    const fs::path real = fs::canonical(path, error);
    return error ? "" : real.string();
}

}  // namespace

SaveTarget saveTarget(const std::string& scene, const std::string& typed) {
    if (typed.empty()) return {"", "It needs a name."};
    if (std::any_of(typed.begin(), typed.end(), [](unsigned char c) { return c < 0x20; }))
        return {"", "This name cannot be a file's."};
    const fs::path folder = folderOf(scene);
    fs::path file = typed.find('/') == std::string::npos && typed.front() != '~'
                        ? folder / typed
                        : typedPath(fs::absolute(folder), typed);
    if (!file.has_filename()) return {"", "This is a folder."};
    if (!endsWith(file.string(), kEnding)) file += kEnding;
    const std::string home = realPath(folder), there = realPath(folderOf(file));
    if (there.empty()) return {"", fmt::format("There is no folder {}.", folderOf(file).string())};
    if (there != home)
        return {"", fmt::format("It must stay in {}: from there it finds its models, pictures and "
                                "snippets.",
                                home)};
    std::error_code error;
    if (fs::is_directory(file, error)) return {"", "This is a folder."};
    return {file.string(), "", fs::exists(fs::symlink_status(file, error))};
}

std::string freeSceneName(const std::string& scene) {
    const fs::path folder = folderOf(scene);
    std::string stem = fs::path(scene).filename().string();
    for (const std::string_view ending : {".toml", ".sdf.glsl", ".gltf", ".glb", ".obj"})
        if (endsWith(stem, ending)) stem.erase(stem.size() - ending.size());
    std::string name = stem + std::string(kEnding);
    std::error_code error;
    for (int i = 2; fs::exists(folder / name, error); ++i)
        name = fmt::format("{}-{}{}", stem, i, kEnding);
    return name;
}

}  // namespace vitrine
