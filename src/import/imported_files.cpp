// SPDX-License-Identifier: MIT
#include "import/imported_files.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "base/file.hpp"
#include "import/model_material.hpp"

namespace vitrine {

ImportedFiles::ImportedFiles(Scene& scene, ModelLibrary& library, Diagnostics& diagnostics)
    : scene_(scene), library_(library), diagnostics_(diagnostics) {
    for (const Material& m : scene.materials) materialNames_.take(m.name);
    for (const Shape& s : scene.shapes) shapeNames_.take(s.name);
}

ImportedFile* ImportedFiles::open(const Reference& reference) {
    std::filesystem::path path;
    try {
        path = resolveInside(scene_.folder, reference.name);
    } catch (const std::invalid_argument& e) {
        diagnostics_.error(reference.where, fmt::format("'{}': {}", reference.name, e.what()));
        return nullptr;
    }
    std::error_code error;
    if (!std::filesystem::exists(path, error)) {
        diagnostics_.error(reference.where,
                           fmt::format("'{}': there is no such file", reference.name));
        return nullptr;
    }
    const auto model = library_.read(path, diagnostics_);
    if (model == nullptr) return nullptr;
    for (const auto& known : files_)
        if (known->model == model) return known.get();
    auto file = std::make_unique<ImportedFile>();
    file->path = path.string();
    file->name = fileNames_.make(path.stem().string());
    file->model = model;
    file->partNames = partNamesOf(*model);
    file->pictures.resize(model->images.size());
    file->materials.resize(file->partNames.size());
    file->shapes.resize(model->meshes.size());
    files_.push_back(std::move(file));
    return files_.back().get();
}

std::shared_ptr<const ImageRgba8> ImportedFiles::picture(ImportedFile& file, int image) {
    auto& known = file.pictures[static_cast<size_t>(image)];
    if (known == nullptr) known = library_.picture(*file.model, image, file.path, diagnostics_);
    return known;
}

/// The name in the scene of a model's material, which is there from now on.
const std::string& ImportedFiles::material(ImportedFile& file, int number) {
    const size_t part =
        number == kNoIndex ? file.partNames.size() - 1 : static_cast<size_t>(number);
    std::string& name = file.materials[part];
    if (!name.empty()) return name;
    name = materialNames_.make(file.name + '/' + file.partNames[part]);
    Material made =
        materialOf(*file.model, number, [&](int image) { return picture(file, image); });
    made.name = name;
    made.where = {file.path};
    scene_.materials.push_back(std::move(made));
    return name;
}

void ImportedFiles::giveMesh(Shape& shape, ImportedFile& file, const LibraryMesh& mesh) {
    for (size_t i = 0; i < mesh.materials.size(); ++i)
        shape.partMaterials.emplace_back(mesh.mesh->partNames[i],
                                         material(file, mesh.materials[i]));
    shape.imported = mesh.mesh;
}

void ImportedFiles::fillShape(size_t number) {
    const Reference reference = scene_.shapes[number].mesh;
    ImportedFile* file = open(reference);
    if (file == nullptr) return;
    if (!file->joined) file->joined = joined(*file, reference);
    if (file->joined->empty()) return;
    scene_.shapes[number].imported = file->joined->front().imported;
    scene_.shapes[number].partMaterials = file->joined->front().partMaterials;
}

std::vector<Shape> ImportedFiles::joined(ImportedFile& file, const Reference& reference) {
    const MeshSize size = sizeOfScene(*file.model);
    const GltfLimits limits;
    if (size.vertices > limits.vertices || size.triangles > limits.triangles) {
        diagnostics_.error(reference.where,
                           fmt::format("'{}' is too large for one shape: {} triangles, as its "
                                       "meshes stand in many places; use it by "
                                       "include",
                                       reference.name, size.triangles));
        return {};
    }
    const auto mesh = library_.wholeScene(*file.model);
    if (mesh->skipped > 0) warnSkippedNodes(reference, mesh->skipped, diagnostics_);
    if (mesh->mesh == nullptr) {
        diagnostics_.error(reference.where,
                           fmt::format("'{}' has no triangles to show", reference.name));
        return {};
    }
    std::vector<Shape> shapes(1);
    giveMesh(shapes[0], file, *mesh);
    return shapes;
}

const ImportedFile::MeshShape& ImportedFiles::shape(ImportedFile& file, int mesh) {
    ImportedFile::MeshShape& known = file.shapes[static_cast<size_t>(mesh)];
    if (known.known) return known;
    known.known = true;
    const GltfMesh& source = file.model->meshes[static_cast<size_t>(mesh)];
    const auto joined = library_.mesh(*file.model, mesh);
    if (joined->mesh == nullptr) return known;
    Shape made;
    made.name = known.name = shapeNames_.make(file.name + '/' + source.name);
    made.where = {file.path};
    known.parts = joined->mesh->partNames;
    giveMesh(made, file, *joined);
    scene_.shapes.push_back(std::move(made));
    return known;
}

void warnSkippedNodes(const Reference& reference, size_t count, Diagnostics& diagnostics) {
    diagnostics.warning(
        reference.where,
        fmt::format("{} node{} of '{}' left out: with {} parents too flat, small or large", count,
                    count == 1 ? "" : "s", reference.name, count == 1 ? "its" : "their"));
}

}  // namespace vitrine
