// SPDX-License-Identifier: MIT
// The models that a scene names, each read once however often it is named.
#pragma once

#include <filesystem>
#include <map>
#include <memory>

#include "gltf/read.hpp"

namespace vitrine {

class ModelLibrary {
  public:
    /// Null if the file cannot be read; the first time, `diagnostics` gets the reason.
    std::shared_ptr<const GltfModel> read(const std::filesystem::path& file,
                                          Diagnostics& diagnostics);

  private:
    std::map<std::filesystem::path, std::shared_ptr<const GltfModel>> models_;
};

}  // namespace vitrine
