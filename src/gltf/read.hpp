// SPDX-License-Identifier: MIT
// Reads .gltf and .glb files. They are untrusted: nothing outside the file's folder is opened, time
// and memory are bounded by GltfLimits, and everything is checked before it is used.
//
// Read: triangles in all forms (lists, strips, fans, sparse and normalised accessors, two uv sets,
// colours, tangents), materials, textures, nodes, perspective cameras, animated transforms, and
// KHR_lights_punctual, KHR_mesh_quantization, KHR_texture_transform and
// KHR_materials_{clearcoat,emissive_strength,ior,sheen,specular,transmission,unlit,volume}.
// Left out with a warning that names it: points, lines, skins, morph targets, orthographic cameras,
// further extensions. A further extension that the file requires is an error.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "base/error.hpp"
#include "gltf/model.hpp"
#include "image/image.hpp"

namespace vitrine {

/// What one file may cost, all of its parts and repetitions together.
struct GltfLimits {
    uint64_t bytes = 2ull << 30;        ///< of all files and data: URIs
    uint64_t jsonBytes = 256ull << 20;  ///< with the data: URIs in it
    uint64_t jsonValues = 4'000'000;    ///< about 100 bytes of memory each
    int jsonDepth = 256;
    uint64_t vertices = 32u << 20;
    uint64_t triangles = 32u << 20;
    uint64_t emptyElements = 1u << 20;  ///< that accessors without a bufferView promise
    uint64_t animationNumbers = 16u << 20;
    uint64_t pixels = 512u << 20;  ///< of all images, by their headers
    uint64_t nodes = 1u << 20;
    uint64_t materials = 1u << 16;
    int nodeDepth = 1024;
    int messages = 20;  ///< errors and warnings, each, reported one by one
};

/// The model, or nothing if `diagnostics` got an error. Messages carry the JSON pointer of the
/// place and, in a .gltf, its line and column. Pictures that are missing or broken are only
/// warnings.
std::optional<GltfModel> readGltf(const std::filesystem::path& file, Diagnostics& diagnostics,
                                  const GltfLimits& limits = {});

/// The pixels of a picture. If it cannot be decoded, a warning placed at `file` and a small
/// checkerboard of magenta and black.
ImageRgba8 decodeGltfImage(const GltfImage& image, const std::string& file,
                           Diagnostics& diagnostics);

}  // namespace vitrine
