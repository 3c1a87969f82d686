// SPDX-License-Identifier: MIT
#include "import/model_library.hpp"

#include <fmt/format.h>

namespace vitrine {
namespace {

std::shared_ptr<const LibraryMesh> shared(std::optional<ModelMesh> mesh, size_t skipped) {
    auto result = std::make_shared<LibraryMesh>();
    result->skipped = skipped;
    if (!mesh) return result;
    result->mesh = std::make_shared<const Mesh>(std::move(mesh->mesh));
    result->materials = std::move(mesh->materials);
    return result;
}

}  // namespace

std::shared_ptr<const LibraryModel> ModelLibrary::read(const std::filesystem::path& file,
                                                       Diagnostics& diagnostics) {
    std::error_code error;
    std::filesystem::path canonical = std::filesystem::weakly_canonical(file, error);
    const std::string key = error ? file.string() : canonical.string();
    if (unreadable_.count(key) != 0) return nullptr;
    auto model = models_.get(key, [&]() -> std::shared_ptr<const LibraryModel> {
        auto content = readGltf(file, diagnostics);
        if (!content) return nullptr;
        return std::make_shared<LibraryModel>(
            LibraryModel{std::move(*content), models_.made() + 1});
    });
    if (model == nullptr) unreadable_.insert(key);
    return model;
}

std::shared_ptr<const ImageRgba8> ModelLibrary::picture(const LibraryModel& model, int image,
                                                        const std::string& path,
                                                        Diagnostics& diagnostics) {
    const std::string key = fmt::format("{} {}", model.number, image);
    const size_t before = diagnostics.list().size();
    auto picture = pictures_.get(key, [&] {
        return std::make_shared<const ImageRgba8>(
            decodeGltfImage(model.images[static_cast<size_t>(image)], path, diagnostics));
    });
    if (diagnostics.list().size() != before) pictures_.forget(key);
    return picture;
}

std::shared_ptr<const LibraryMesh> ModelLibrary::mesh(const LibraryModel& model, int mesh) {
    return meshes_.get(fmt::format("{} {}", model.number, mesh), [&] {
        return shared(joinMesh(model, model.meshes[static_cast<size_t>(mesh)]), 0);
    });
}

std::shared_ptr<const LibraryMesh> ModelLibrary::wholeScene(const LibraryModel& model) {
    return meshes_.get(fmt::format("{} whole", model.number), [&] {
        size_t skipped = 0;
        auto mesh = joinScene(model, skipped);
        return shared(std::move(mesh), skipped);
    });
}

void ModelLibrary::sweep() {
    models_.sweep();
    pictures_.sweep();
    meshes_.sweep();
    unreadable_.clear();
}

}  // namespace vitrine
