// SPDX-License-Identifier: MIT
// The models that a scene names, each read once however often it is named, and what has been made
// of them. A library that is kept reads again only what has changed on the disk; a copy of it
// shares what is there already.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <set>

#include "base/reuse.hpp"
#include "gltf/read.hpp"
#include "image/image.hpp"
#include "import/model_mesh.hpp"

namespace vitrine {

/// A model, and what tells it from every other one that its library has read.
struct LibraryModel : GltfModel {
    int number = 0;
};

/// What joinMesh() or joinScene() gives, to be shared.
struct LibraryMesh {
    std::shared_ptr<const Mesh> mesh;  ///< null: no triangles
    std::vector<int> materials;
    size_t skipped = 0;
};

class ModelLibrary {
  public:
    /// Null if the file cannot be read; the first time, `diagnostics` gets the reason.
    std::shared_ptr<const LibraryModel> read(const std::filesystem::path& file,
                                             Diagnostics& diagnostics);
    /// An image of a model. What is wrong with it goes to `diagnostics` each time.
    std::shared_ptr<const ImageRgba8> picture(const LibraryModel& model, int image,
                                              const std::string& path, Diagnostics& diagnostics);
    /// One of its meshes.
    std::shared_ptr<const LibraryMesh> mesh(const LibraryModel& model, int mesh);
    /// All of its scene as one mesh.
    std::shared_ptr<const LibraryMesh> wholeScene(const LibraryModel& model);

    /// A scene has been loaded: forgets what it did not need, and which files could not be read.
    void sweep();
    /// How many models have been read, pictures decoded and meshes made.
    [[nodiscard]] int made() const { return models_.made() + pictures_.made() + meshes_.made(); }

  private:
    Reuse<LibraryModel> models_;
    Reuse<ImageRgba8> pictures_;
    Reuse<LibraryMesh> meshes_;
    std::set<std::string> unreadable_;
};

}  // namespace vitrine
