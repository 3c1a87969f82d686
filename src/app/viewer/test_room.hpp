// SPDX-License-Identifier: MIT
// Scenes of boxes to run into, for tests.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "app/viewer/surroundings.hpp"
#include "scene/parse.hpp"

namespace vitrine::test {

/// What a scene's text stands for, as something to run into.
class Room {
  public:
    explicit Room(const std::string& text) {
        Diagnostics diagnostics;
        const Scene scene = parseScene(text, "room.toml", {}, diagnostics);
        packed_ = packScene(scene, loadAssets(scene, diagnostics), diagnostics);
        EXPECT_EQ(diagnostics.text(), "");
        meshes_ = std::make_unique<MeshSurroundings>(packed_);
    }

    std::vector<std::optional<ProbeHit>> operator()(std::span<const ProbeRay> rays) const {
        std::vector<std::optional<ProbeHit>> hits;
        for (const ProbeRay& ray : rays) hits.push_back(meshes_->closest(ray));
        return hits;
    }
    [[nodiscard]] const std::vector<PackedInstance>& instances() const { return packed_.instances; }

    /// A box with its middle at `at`, as text.
    static std::string box(glm::vec3 size, glm::vec3 at, const std::string& more = "") {
        static int number = 0;
        const std::string name = "box" + std::to_string(++number);
        const auto list = [](glm::vec3 v) {
            return "[" + std::to_string(v.x) + ", " + std::to_string(v.y) + ", " +
                   std::to_string(v.z) + "]";
        };
        return "[shape." + name + "]\nbox = { size = " + list(size) + " }\n[[node]]\nname = \"" +
               name + "\"\nshape = \"" + name + "\"\nat = " + list(at) + "\n" + more + "\n";
    }
    /// A floor whose top is at height 0.
    static std::string floor() { return box({40, 1, 40}, {0, -0.5f, 0}); }

  private:
    PackedScene packed_;
    std::unique_ptr<MeshSurroundings> meshes_;
};

}  // namespace vitrine::test
