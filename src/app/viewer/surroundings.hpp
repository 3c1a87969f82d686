// SPDX-License-Identifier: MIT
// The scene on show as something to run into.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "app/viewer/probe.hpp"
#include "app/viewer/scene_view.hpp"
#include "bvh/instance.hpp"

namespace vitrine {

/// The meshes of a moment, by the trees that the CPU has of them.
class MeshSurroundings {
  public:
    explicit MeshSurroundings(const PackedMoment& moment);
    [[nodiscard]] std::optional<ProbeHit> closest(const ProbeRay& ray) const;

  private:
    std::vector<std::shared_ptr<const MeshAsset>> assets_;
    std::vector<MeshView> views_;
    std::vector<Instance> instances_;
    Bvh tree_;
};

class Surroundings {
  public:
    explicit Surroundings(SceneView& view) : view_(view) {}

    /// As a Probe. Meshes are asked on the CPU; fields exist on the GPU alone, and where a scene
    /// has any, all is asked there.
    std::vector<std::optional<ProbeHit>> operator()(std::span<const ProbeRay> rays);

  private:
    void follow();
    std::vector<std::optional<ProbeHit>> askGpu(std::span<const ProbeRay> rays);

    SceneView& view_;
    std::optional<MeshSurroundings> meshes_;
    bool fields_ = false;
    int moment_ = -1;  ///< the one that all this is of
};

}  // namespace vitrine
