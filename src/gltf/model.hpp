// SPDX-License-Identifier: MIT
// A glTF 2.0 file as plain data. Every index in it is in range, the nodes are trees, the meshes
// have passed sanitizeMesh(), and what is read is finite, except for transforms of skipped nodes.
// Names are those of the specification.
//
// Where Vitrine differs: (0,0) of all uvs is the lower left of a picture (glTF: upper left), here
// already converted; GltfTextureInfo holds the file's numbers, and uvFromMeshUv() is their matrix.
// Source: Khronos, "glTF 2.0 Specification" (2021), and the extensions named at each member.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "base/math.hpp"
#include "mesh/mesh.hpp"

namespace vitrine {

/// "No such thing", wherever an index may be absent.
inline constexpr int kNoIndex = -1;

/// An encoded picture; decodeGltfImage() makes pixels of it.
struct GltfImage {
    std::string name;   ///< the file's name, or what the file calls it
    std::string bytes;  ///< of a PNG or JPEG file; empty if it could not be read
    int width = 0;      ///< by the picture's header
    int height = 0;
};

enum class GltfWrap { kRepeat, kMirroredRepeat, kClampToEdge };
enum class GltfFilter { kLinear, kNearest };
enum class GltfMipmap { kLinear, kNearest, kNone };

struct GltfTexture {
    int image = kNoIndex;  ///< none: only in a format that is not supported
    GltfWrap wrapS = GltfWrap::kRepeat;
    GltfWrap wrapT = GltfWrap::kRepeat;
    GltfFilter magFilter = GltfFilter::kLinear;
    GltfFilter minFilter = GltfFilter::kLinear;
    GltfMipmap mipmap = GltfMipmap::kLinear;
};

/// A use of a texture, with KHR_texture_transform.
struct GltfTextureInfo {
    int texture = kNoIndex;
    int texCoord = 0;  ///< 0: Mesh::uvs, 1: Mesh::uvs2
    glm::vec2 offset{0};
    float rotation = 0;  ///< radians
    glm::vec2 scale{1};
};

/// Where in the picture, (0,0) lower left, a mesh's uv lies.
glm::mat3 uvFromMeshUv(const GltfTextureInfo& info);

enum class GltfAlphaMode { kOpaque, kMask, kBlend };

/// Factors multiply their texture. sRGB are baseColor, emissive, sheenColor and specularColor,
/// all other textures hold linear numbers.
struct GltfMaterial {
    std::string name;
    glm::vec4 baseColorFactor{1};
    GltfTextureInfo baseColorTexture;
    float metallicFactor = 1;
    float roughnessFactor = 1;
    GltfTextureInfo metallicRoughnessTexture;  ///< green: roughness, blue: metallic
    GltfTextureInfo normalTexture;
    float normalScale = 1;
    GltfTextureInfo occlusionTexture;  ///< red
    float occlusionStrength = 1;
    glm::vec3 emissiveFactor{0};
    GltfTextureInfo emissiveTexture;
    float emissiveStrength = 1;  ///< KHR_materials_emissive_strength
    GltfAlphaMode alphaMode = GltfAlphaMode::kOpaque;
    float alphaCutoff = 0.5f;
    bool doubleSided = false;
    bool unlit = false;  ///< KHR_materials_unlit

    float ior = 1.5f;  ///< KHR_materials_ior; 0: total reflection

    float transmissionFactor = 0;         ///< KHR_materials_transmission
    GltfTextureInfo transmissionTexture;  ///< red

    float thicknessFactor = 0;  ///< KHR_materials_volume, in the mesh's units; 0: a thin wall
    GltfTextureInfo thicknessTexture;                                    ///< green
    float attenuationDistance = std::numeric_limits<float>::infinity();  ///< nothing is absorbed
    glm::vec3 attenuationColor{1};

    float clearcoatFactor = 0;         ///< KHR_materials_clearcoat
    GltfTextureInfo clearcoatTexture;  ///< red
    float clearcoatRoughnessFactor = 0;
    GltfTextureInfo clearcoatRoughnessTexture;  ///< green
    GltfTextureInfo clearcoatNormalTexture;
    float clearcoatNormalScale = 1;

    glm::vec3 sheenColorFactor{0};  ///< KHR_materials_sheen
    GltfTextureInfo sheenColorTexture;
    float sheenRoughnessFactor = 0;
    GltfTextureInfo sheenRoughnessTexture;  ///< alpha

    float specularFactor = 1;         ///< KHR_materials_specular
    GltfTextureInfo specularTexture;  ///< alpha
    glm::vec3 specularColorFactor{1};
    GltfTextureInfo specularColorTexture;
};

struct GltfPrimitive {
    Mesh mesh;
    int material = kNoIndex;  ///< none: GltfMaterial{}
};

struct GltfMesh {
    std::string name;
    std::vector<GltfPrimitive> primitives;  ///< may be empty: points and lines are left out
};

/// Looks along its node's -z, +y is up.
struct GltfCamera {
    std::string name;
    bool isPerspective = true;  ///< orthographic ones are not supported: nothing below holds
    float yfov = 0;             ///< radians
    float aspectRatio = 0;      ///< 0: that of the picture
    float znear = 0;
    float zfar = 0;  ///< 0: infinitely far
};

enum class GltfLightType { kDirectional, kPoint, kSpot };

/// KHR_lights_punctual. Shines along its node's -z.
struct GltfLight {
    std::string name;
    GltfLightType type = GltfLightType::kPoint;
    glm::vec3 color{1};
    float intensity = 1;       ///< point, spot: candela; directional: lux
    float range = 0;           ///< metres; 0: no end
    float innerConeAngle = 0;  ///< radians from the axis
    float outerConeAngle = kPi / 4;
};

struct GltfNode {
    std::string name;
    int parent = kNoIndex;
    std::vector<int> children;
    glm::vec3 translation{0};
    glm::quat rotation{1, 0, 0, 0};
    glm::vec3 scale{1};
    std::optional<glm::mat4> matrix;  ///< instead of the three above
    int mesh = kNoIndex;
    int camera = kNoIndex;
    int light = kNoIndex;
    bool isSkipped = false;  ///< its transform, or an ancestor's, is unusable: not to be drawn
};

struct GltfScene {
    std::string name;
    std::vector<int> nodes;  ///< the roots
};

enum class GltfPath { kTranslation, kRotation, kScale };
enum class GltfInterpolation { kLinear, kStep, kCubicSpline };

/// One property of one node over time.
struct GltfChannel {
    int node = kNoIndex;
    GltfPath path = GltfPath::kTranslation;
    GltfInterpolation interpolation = GltfInterpolation::kLinear;
    std::vector<float> times;  ///< seconds, growing; at least one
    /// One a time, or three for kCubicSpline: in-tangent, value, out-tangent. Rotations: x y z w.
    std::vector<glm::vec4> values;
};

struct GltfAnimation {
    std::string name;
    std::vector<GltfChannel> channels;
    float duration = 0;  ///< the last time of all channels
};

struct GltfModel {
    std::vector<GltfImage> images;
    std::vector<GltfTexture> textures;
    std::vector<GltfMaterial> materials;
    std::vector<GltfMesh> meshes;
    std::vector<GltfCamera> cameras;
    std::vector<GltfLight> lights;
    std::vector<GltfNode> nodes;
    std::vector<int> nodeOrder;     ///< all nodes, parents before their children
    std::vector<GltfScene> scenes;  ///< at least one: without any in the file, one of all roots
    int scene = 0;                  ///< the one to show
    std::vector<GltfAnimation> animations;
};

}  // namespace vitrine
