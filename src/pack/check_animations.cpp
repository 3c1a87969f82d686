// SPDX-License-Identifier: MIT
#include "pack/check_animations.hpp"

#include "pack/parameters.hpp"
#include "scene/target.hpp"

namespace vitrine {
namespace {

/// The snippet of a node or material; null, with a diagnostic if there should be one.
const Snippet* snippetOf(const AnimationTrack& track, const Scene& scene, const Assets& assets,
                         Diagnostics& diagnostics) {
    if (track.target.object == AnimationTarget::Object::kMaterial) {
        if (scene.materials[track.target.index].snippet.empty())
            diagnostics.error(track.where, "the material has no snippet with parameters");
        return assets.materials[track.target.index].get();
    }
    const Node& node = scene.nodes[track.target.index];
    for (size_t i = 0; i < scene.shapes.size(); ++i) {
        if (scene.shapes[i].name != node.shape.name) continue;
        if (scene.shapes[i].sdf.empty() && assets.fields[i] == nullptr) break;
        return assets.fields[i].get();
    }
    diagnostics.error(track.where, "only an SDF shape has parameters to animate");
    return nullptr;
}

}  // namespace

void checkAnimations(const Scene& scene, const Assets& assets, Diagnostics& diagnostics) {
    for (const AnimationTrack& track : scene.animations) {
        const auto name = parameterOf(track.target.key);
        if (!name) continue;
        const Snippet* snippet = snippetOf(track, scene, assets, diagnostics);
        if (snippet == nullptr) continue;
        for (const glm::vec4& value : track.values) {
            Diagnostics found;
            (void)parameterValues(*snippet, {{*name, value, track.components, track.where}}, found);
            diagnostics.append(found);
            if (found.hasErrors()) break;  // one key is enough to see what is meant
        }
    }
}

}  // namespace vitrine
