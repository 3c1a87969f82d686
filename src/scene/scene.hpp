// SPDX-License-Identifier: MIT
// A scene as its author wrote it: plain data with defaults filled in and the place of whatever
// may still turn out to be wrong. Metres, seconds, degrees, +Y up, right-handed; colours linear.
#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/math.hpp"
#include "image/image.hpp"
#include "scene/animation.hpp"

namespace vitrine {

struct Mesh;

/// A linear RGB colour, distinct from a position.
struct Color {
    glm::vec3 rgb{0};
};

/// The name of something declared elsewhere (a shape, a material, a file), and where it is used.
struct Reference {
    std::string name;
    SourceLocation where;
    [[nodiscard]] bool empty() const { return name.empty(); }
};

/// A number, a truth value, a vector or a colour given to a parameter of a snippet.
struct ParameterValue {
    std::string name;
    glm::vec4 value{0};
    int components = 1;  ///< 1 to 4
    SourceLocation where;
};

/// How a light with a size throws shadows: by many rays to all of it, or by one to its middle that
/// minds how near it passes fields.
enum class ShadowMethod { kSampled, kPenumbra };
/// How ambient light is occluded on fields: by rays, or by asking fields at a few points.
enum class OcclusionMethod { kRays, kTaps };

enum class ToneMap { kNone, kFilmic, kAces, kAgx, kReinhard };

struct RenderSettings {
    int bounces = 2;
    int samples = 1;
    int ssaa = 1;
    float exposure = 0;           ///< stops
    float exposurePercent = 100;  ///< on top of that
    float gamma = 1;
    ToneMap toneMap = ToneMap::kFilmic;
    float threshold = 0.02f;
    ShadowMethod shadows = ShadowMethod::kSampled;
    float ao = 1;
    OcclusionMethod aoMode = OcclusionMethod::kRays;
    float aoDistance = 2;
    float sssAll = 0;  ///< least subsurface of every material
    int marchSteps = 1024;
    int seed = 0;
    float budgetMilliseconds = 70;  ///< a frame, in a window while something moves
};

enum class TreeBuilder { kNine, kBinned, kSpatial };
inline constexpr std::array<const char*, 3> kTreeBuilderNames{"nine", "binned", "spatial"};

/// How the trees of meshes are built (bvh/build.hpp).
struct TreeSettings {
    TreeBuilder builder = TreeBuilder::kBinned;
    int maxLeafSize = 4;
    float traversalCost = 1;     ///< of a node, in tests of a triangle
    float maxDuplicates = 0.5f;  ///< spatial: as a part of all triangles
    float minOverlap = 1e-5f;    ///< spatial: as a part of the root's area
};

/// Who blurs what a lens does not show sharp: samples through all of it, or a filter over a sharp
/// picture and its depth.
enum class LensBlur { kSampled, kFilter };

/// Round the camera's target on a level circle: a turntable, seen from beside it.
struct CameraOrbit {
    float period = 12;        ///< s a turn, counterclockwise seen from above; negative: clockwise
    float distance = 0;       ///< from the target, m
    float elevation = -kAny;  ///< degrees above the target
    float azimuth = -kAny;    ///< at time 0, degrees from +z towards +x

    static constexpr float kAny = 1e10f;  ///< not given
};

struct Camera {
    std::string name;
    glm::vec3 eye{3, 2, 4};
    glm::vec3 target{0, 0.5f, 0};
    glm::vec3 up{0, 1, 0};
    float fov = 0;            ///< vertical, degrees; 0: from focalLength
    float focalLength = 0;    ///< millimetres on a sensor 36 mm wide; 0: from fov
    float fStop = 0;          ///< focal length over the lens's diameter; 0: a pinhole
    float focusDistance = 0;  ///< along the view axis, m; 0: to the target
    int apertureBlades = 0;   ///< corners of the lens's opening; 0: round
    LensBlur lens = LensBlur::kSampled;
    /// In Scene::nodes: it goes with this node and looks along its -z, and eye, target and up are
    /// where the node puts them at rest. Of a model.
    std::optional<size_t> node;
    /// It goes by itself: this, or the path of its tracks in Scene::animations, is why.
    std::optional<CameraOrbit> orbit;
    LoopMode loop = LoopMode::kNone;  ///< of its path
    SourceLocation where;

    static constexpr float kDefaultFocalLength = 35;
};

/// Why nothing can be seen with this camera; "" if it is good.
std::string problemOf(const Camera& camera);

/// What is around the scene. A gradient: zenith above, horizon, ground below, blended smoothly. Or
/// a picture. Or an atmosphere with a sun, computed.
struct Environment {
    Color zenith{{0.22f, 0.34f, 0.60f}};
    Color horizon{{0.55f, 0.62f, 0.70f}};
    Color ground{{0.20f, 0.19f, 0.18f}};  ///< below an atmosphere: its reflectance
    Reference picture;                    ///< a .hdr or .exr file
    bool atmosphere = false;
    float sunElevation = 40;  ///< degrees above the horizon
    float sunAzimuth = 35;    ///< degrees from +z towards +x
    float turbidity = 2.5f;   ///< 1: air without haze
    float rotation = 0;       ///< degrees about +y, counterclockwise seen from above
    float intensity = 1;
};

enum class LightType { kSun, kPoint, kSpot, kSphere, kRect };

struct Light {
    std::string name;
    LightType type = LightType::kSun;
    glm::vec3 at{0, 4, 0};            ///< all but the sun
    glm::vec3 direction{-1, -2, -1};  ///< sun, spot, rect: the way the light travels
    float polar = kNoAngle;  ///< sun, spot: where the light comes from, degrees from the zenith
    float azimuth = 0;       ///< and from +z towards +x; both hold instead of direction
    Color color{{1, 1, 1}};
    float intensity = 3;      ///< sun: irradiance, W/m2; others: radiant intensity, W/sr
    float radius = 0;         ///< m; of a sun, degrees; 0: hard shadows
    glm::vec3 size{1, 1, 0};  ///< rect: width and height, m; z is not used
    float innerAngle = 0;     ///< spot: full light within, degrees from the axis
    float outerAngle = 45;
    float range = 0;             ///< point, spot: nothing is lit beyond, m; 0: no end
    std::optional<size_t> node;  ///< it goes with this node and shines along its -z; see Camera
    SourceLocation where;

    static constexpr float kNoAngle = -1;  ///< polar: not given
};

/// The way the light of a sun, spot or rect travels, unit, by its angles or its direction.
glm::vec3 travelOf(const Light& light);
/// Gives angles to a light that has a direction; it travels as before.
void useAngles(Light& light);

enum class TextureWrap { kRepeat, kClamp, kMirror };

/// A picture laid over a surface: a file, or pixels that came with a model.
struct MaterialTexture {
    Reference file;
    std::shared_ptr<const ImageRgba8> image;
    TextureWrap wrapU = TextureWrap::kRepeat, wrapV = TextureWrap::kRepeat;
    bool nearest = false;  ///< square texels instead of blended ones
    int uvSet = 0;
    /// From the mesh's coordinates to the picture's, both with (0, 0) at the lower left.
    glm::mat3 pictureFromMesh{1};

    [[nodiscard]] bool given() const { return !file.empty() || image != nullptr; }
};

/// What a surface with opacity below 1 does: nothing, let rays pass below a cutoff, or let part of
/// them pass.
enum class AlphaMode { kOpaque, kMask, kBlend };

/// One channel of a picture, as it is or reversed (a glossiness is a reversed roughness).
enum class Channel { kRed, kGreen, kBlue, kAlpha, kNotRed, kNotGreen, kNotBlue, kNotAlpha };

/// How light is answered: by all the layers below, or as in the textbooks.
enum class SurfaceModel { kPbr, kLambert, kBlinnPhong };

/// glTF 2.0 metallic-roughness with the KHR_materials extensions of the same names.
struct Material {
    std::string name;
    Color baseColor{{0.8f, 0.8f, 0.8f}};
    float metallic = 0;
    float roughness = 0.5f;
    Color emission{{0, 0, 0}};
    float emissionStrength = 1;
    MaterialTexture baseColorTexture, metallicRoughnessTexture, normalTexture, occlusionTexture,
        emissionTexture;
    Channel roughnessFrom = Channel::kGreen, metallicFrom = Channel::kBlue;
    float normalScale = 1, occlusionStrength = 1;

    float opacity = 1;  ///< times the alpha of the base colour's texture
    AlphaMode alphaMode = AlphaMode::kOpaque;
    float alphaCutoff = 0.5f;
    bool doubleSided = true;
    bool unlit = false;  ///< shows its base colour whatever the light is

    float ior = 1.5f;                 ///< index of refraction
    float specular = 1;               ///< of dielectrics
    Color specularColor{{1, 1, 1}};   ///< of their reflection at normal incidence
    MaterialTexture specularTexture;  ///< alpha
    MaterialTexture specularColorTexture;

    float transmission = 0;  ///< share of the light, not reflected, that goes on inside
    MaterialTexture transmissionTexture;  ///< red
    bool thin = false;                    ///< a sheet: light passes without refraction
    Color attenuationColor{{1, 1, 1}};    ///< left of white light after attenuationDistance
    float attenuationDistance = 0;        ///< m; 0: nothing is absorbed

    float clearcoat = 0, clearcoatRoughness = 0, clearcoatNormalScale = 1;
    MaterialTexture clearcoatTexture;           ///< red
    MaterialTexture clearcoatRoughnessTexture;  ///< green
    MaterialTexture clearcoatNormalTexture;

    Color sheenColor{{0, 0, 0}};
    float sheenRoughness = 0;
    MaterialTexture sheenColorTexture;
    MaterialTexture sheenRoughnessTexture;  ///< alpha

    float subsurface = 0;              ///< share of light that comes through from behind
    Color subsurfaceColor{{1, 1, 1}};  ///< of that light, times baseColor
    float subsurfaceRadius = 0.1f;     ///< m of substance that leave 1/e of it

    SurfaceModel model = SurfaceModel::kPbr;
    Color highlightColor{{0.2f, 0.2f, 0.2f}};  ///< kBlinnPhong: what its highlight sends back
    float shininess = 40;                      ///< kBlinnPhong: its exponent

    Reference snippet;              ///< a .mat.glsl file
    float curvatureRadius = 0.02f;  ///< m: what a field's curvature is taken over for the snippet
    std::vector<ParameterValue> set;
    SourceLocation where;
};

struct BoxShape {
    glm::vec3 size{1};
};
struct SphereShape {
    float radius = 0.5f;
};
struct PlaneShape {
    glm::vec3 size{10, 0, 10};
};
struct TorusShape {
    float radius = 0.5f;
    float tube = 0.2f;
    int segments = 96;
    int sides = 48;
    float arc = 360;  ///< degrees
};
struct CylinderShape {
    float radius = 0.5f;
    float height = 1;
};

/// Exactly one of the members is given.
struct Shape {
    std::string name;
    Reference sdf;   ///< a .sdf.glsl file
    Reference mesh;  ///< an .obj, .gltf or .glb file
    std::optional<BoxShape> box;
    std::optional<SphereShape> sphere;
    std::optional<PlaneShape> plane;
    std::optional<TorusShape> torus;
    std::optional<CylinderShape> cylinder;
    /// Triangles of a model that has been read already, and the materials that it gives its parts.
    std::shared_ptr<const Mesh> imported;
    std::vector<std::pair<std::string, std::string>> partMaterials;
    SourceLocation where;
};

struct Node {
    std::string name;
    Reference parent;
    Reference shape;
    Reference include;    ///< a .gltf or .glb file whose nodes stand below this one
    Reference animation;  ///< of that file, the one that plays; none: the first
    Reference material;
    std::vector<std::pair<std::string, Reference>> parts;  ///< material by part name
    glm::vec3 at{0};
    glm::vec3 rotate{0};                   ///< degrees about x, then y, then z
    std::optional<glm::quat> orientation;  ///< instead of rotate: a model's
    glm::vec3 scale{1};
    std::optional<glm::mat4> matrix;  ///< of a model: before the scale
    std::vector<ParameterValue> set;
    bool visible = true;
    SourceLocation where;
    std::vector<SourceLocation> partPlaces;  ///< one an entry of `parts`
};

struct Scene {
    std::string file;              ///< for messages
    std::filesystem::path folder;  ///< where references to files start, and which they stay inside
    std::string title, description;
    RenderSettings render;
    TreeSettings bvh;
    std::vector<Camera> cameras;
    Environment environment;
    std::vector<Light> lights;
    std::vector<Material> materials;
    std::vector<Shape> shapes;
    std::vector<Node> nodes;
    std::vector<AnimationTrack> animations;
    /// `--set` of things that come with the models: KEY=VALUE, see import/import_models.hpp.
    std::vector<std::string> importOverrides;
};

struct NodeAndParent {
    size_t node;
    std::optional<size_t> parent;
};
/// All nodes, each after its parent.
std::vector<NodeAndParent> nodesParentsFirst(const Scene& scene);

/// `worldFromObject` of each node: translation, rotation and scale of it and its ancestors.
std::vector<glm::mat4> worldFromNodes(const Scene& scene);

/// Which nodes are there for rays: neither they nor an ancestor has been made invisible.
std::vector<bool> visibleNodes(const Scene& scene);

}  // namespace vitrine
