// SPDX-License-Identifier: MIT
// Files of models, each read once, and what of them is in the scene already.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "import/model_library.hpp"
#include "import/model_names.hpp"
#include "scene/scene.hpp"

namespace vitrine {

struct ImportedFile {
    std::string path, name;  ///< `name`: in front of the names of its materials
    std::shared_ptr<const LibraryModel> model;
    std::vector<std::string> partNames;
    std::vector<std::shared_ptr<const ImageRgba8>> pictures;  ///< one an image, when used
    std::vector<std::string> materials;  ///< names in the scene, one a part name, when used
    struct MeshShape {
        bool known = false;
        std::string name;  ///< of the shape in the scene; "" if there are no triangles
        std::vector<std::string> parts;
    };
    std::vector<MeshShape> shapes;             ///< one a mesh
    std::optional<std::vector<Shape>> joined;  ///< one shape of the whole scene, or none
};

/// Brings shapes and materials of models into a scene, each when it is first used.
class ImportedFiles {
  public:
    ImportedFiles(Scene& scene, ModelLibrary& library, Diagnostics& diagnostics);

    /// The file that a scene names, or null with what is wrong among the diagnostics.
    ImportedFile* open(const Reference& reference);

    /// `[shape.X] mesh = "f.glb"`: all of the file's scene as the one mesh of a shape.
    void fillShape(size_t number);

    /// The shape of one of the file's meshes.
    const ImportedFile::MeshShape& shape(ImportedFile& file, int mesh);

  private:
    std::shared_ptr<const ImageRgba8> picture(ImportedFile& file, int image);
    const std::string& material(ImportedFile& file, int number);
    void giveMesh(Shape& shape, ImportedFile& file, const LibraryMesh& mesh);
    std::vector<Shape> joined(ImportedFile& file, const Reference& reference);

    Scene& scene_;
    ModelLibrary& library_;
    Diagnostics& diagnostics_;
    UniqueNames materialNames_, shapeNames_, fileNames_;
    std::vector<std::unique_ptr<ImportedFile>> files_;
};

/// Says that nodes were left out whose places no floats can express.
void warnSkippedNodes(const Reference& reference, size_t count, Diagnostics& diagnostics);

}  // namespace vitrine
