// SPDX-License-Identifier: MIT
#include "scene/heading.hpp"

#include "base/file.hpp"
#include "scene/document.hpp"

namespace vitrine {
SceneHeading readHeading(const std::filesystem::path& file) {
    Diagnostics diagnostics;
    try {
        const auto document =
            parseDocument(readFile(file, kMaxSceneBytes), file.string(), diagnostics);
        if (!document) return {};
        const auto scene = document->at_path("scene");
        return {scene["title"].value_or(std::string()),
                scene["description"].value_or(std::string())};
    } catch (const InputError&) {
        return {};
    }
}

}  // namespace vitrine
