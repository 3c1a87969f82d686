// SPDX-License-Identifier: MIT
// Where "Save as" may write a scene.
#pragma once

#include <string>

namespace vitrine {

struct SaveTarget {
    std::string file;     ///< with its ending; "": `problem` says why not
    std::string problem;  ///< a sentence
    bool exists = false;  ///< something would be overwritten
};

/// For a name that was typed, while `scene` (a scene, a model or a field) is open. The folder must
/// be the scene's own: from there it names its models, pictures and snippets, and nothing outside
/// of it may be read.
SaveTarget saveTarget(const std::string& scene, const std::string& typed);

/// A name that is free: "robot-2.toml" beside "robot.toml", "chair.toml" beside "chair.glb".
std::string freeSceneName(const std::string& scene);

}  // namespace vitrine
