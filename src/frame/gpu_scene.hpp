// SPDX-License-Identifier: MIT
// A packed scene in the GPU's memory.
#pragma once

#include <memory>

#include "gpu/image_pass.hpp"
#include "pack/pack_scene.hpp"

namespace vitrine {

struct GpuScene {
    TexelBuffer slots{TexelFormat::kRgba32ui};
    TexelBuffer triangles{TexelFormat::kRgba32ui};
    TexelBuffer vertices{TexelFormat::kRgba32f};
    TexelBuffer tables{TexelFormat::kRgba32f};

    TextureArray colorPages, dataPages;
    size_t meshSlotTexels = 0;  ///< the trees over the instances come after these
    TexelBuffer skyTree{TexelFormat::kRgba32f};
    MipTexture skyPicture;

    /// Throws MachineError if the GPU cannot hold it.
    void upload(const PackedScene& scene);
    /// Another moment of the scene that was uploaded: meshes and textures stay where they are.
    void update(const PackedMoment& moment);
    /// Under the names of shaders/scene/fetch.glsl.
    [[nodiscard]] std::vector<std::pair<std::string, const TexelBuffer*>> bindings() const;
    /// Under the name of shaders/scene/sky.glsl.
    [[nodiscard]] std::vector<std::pair<std::string, const MipTexture*>> pictures() const;
    /// Under the names of shaders/scene/texture.glsl.
    [[nodiscard]] std::vector<std::pair<std::string, const TextureArray*>> arrays() const;

  private:
    std::shared_ptr<const SkyAsset> uploadedSky_;
};

}  // namespace vitrine
