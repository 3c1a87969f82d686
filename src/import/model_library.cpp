// SPDX-License-Identifier: MIT
#include "import/model_library.hpp"

namespace vitrine {

std::shared_ptr<const GltfModel> ModelLibrary::read(const std::filesystem::path& file,
                                                    Diagnostics& diagnostics) {
    std::error_code error;
    std::filesystem::path key = std::filesystem::weakly_canonical(file, error);
    if (error) key = file;
    const auto known = models_.find(key);
    if (known != models_.end()) return known->second;
    std::shared_ptr<const GltfModel> model;
    if (auto content = readGltf(file, diagnostics))
        model = std::make_shared<GltfModel>(std::move(*content));
    return models_[key] = model;
}

}  // namespace vitrine
