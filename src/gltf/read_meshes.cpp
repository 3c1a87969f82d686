// SPDX-License-Identifier: MIT
#include "gltf/read_meshes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "gltf/triangle_indices.hpp"

namespace vitrine {
namespace {

/// A component type, and whether its numbers stand for 0 to 1 or -1 to 1.
struct Format {
    ComponentType type;
    bool isNormalized;
    bool operator==(const Format&) const = default;
};
using Formats = std::vector<Format>;

constexpr Format kFloat{ComponentType::kFloat, false};
constexpr Format kByte{ComponentType::kByte, false}, kByteN{ComponentType::kByte, true};
constexpr Format kUByte{ComponentType::kUnsignedByte, false};
constexpr Format kUByteN{ComponentType::kUnsignedByte, true};
constexpr Format kShort{ComponentType::kShort, false}, kShortN{ComponentType::kShort, true};
constexpr Format kUShort{ComponentType::kUnsignedShort, false};
constexpr Format kUShortN{ComponentType::kUnsignedShort, true};

/// What an attribute may be made of.
struct Attribute {
    const char* name;
    int minComponents, maxComponents;
    Formats formats;
    Formats quantizedFormats;  // those that KHR_mesh_quantization adds
};
const Attribute kPosition{"POSITION",
                          3,
                          3,
                          {kFloat},
                          {kByte, kByteN, kUByte, kUByteN, kShort, kShortN, kUShort, kUShortN}};
const Attribute kNormal{"NORMAL", 3, 3, {kFloat}, {kByteN, kShortN}};
const Attribute kTangent{"TANGENT", 4, 4, {kFloat}, {kByteN, kShortN}};
const Attribute kUv{"TEXCOORD_0",
                    2,
                    2,
                    {kFloat, kUByteN, kUShortN},
                    {kByte, kByteN, kUByte, kShort, kShortN, kUShort}};
const Attribute kUv2{"TEXCOORD_1", 2, 2, kUv.formats, kUv.quantizedFormats};
const Attribute kColor{"COLOR_0", 3, 4, {kFloat, kUByteN, kUShortN}, {}};

bool contains(const Formats& formats, const Format& format) {
    return std::find(formats.begin(), formats.end(), format) != formats.end();
}

/// The vertices that a primitive uses, and how.
struct Topology {
    uint32_t first = 0, count = 0;  // a range of the accessors' elements
    std::vector<uint32_t> corners;  // from the start of that range
};

class MeshReader {
  public:
    MeshReader(ReadContext& context, const Accessors& accessors, bool allowsQuantization)
        : context_(context), accessors_(accessors), allowsQuantization_(allowsQuantization) {}

    void readAll() {
        const JsonValue meshes = context_.root.array("meshes");
        for (size_t i = 0; i < meshes.size(); ++i) {
            const JsonValue mesh = meshes.objectAt(i);
            GltfMesh result{nameOf(mesh, "mesh", i), {}};
            const JsonValue primitives = mesh.array("primitives");
            if (mesh.exists() && primitives.size() == 0) mesh.error("'primitives' is missing");
            for (size_t p = 0; p < primitives.size(); ++p)
                if (auto primitive = readPrimitive(primitives.objectAt(p), result.name))
                    result.primitives.push_back(std::move(*primitive));
            context_.model.meshes.push_back(std::move(result));
        }
    }

  private:
    std::optional<GltfPrimitive> readPrimitive(const JsonValue& primitive,
                                               const std::string& name) {
        const JsonValue attributes = primitive.object("attributes");
        const int material = primitive.index("material", context_.model.materials.size());
        const auto mode = readMode(primitive);
        if (!mode || !attributes.exists()) {
            if (primitive.exists() && !attributes.exists())
                primitive.error("'attributes' is missing");
            return {};
        }
        if (!attributes.has(kPosition.name)) {
            primitive.warning("left out: it has no positions");
            return {};
        }
        warnAboutUnsupported(primitive, attributes);
        const Accessor* positions = findAttribute(attributes, kPosition, nullptr);
        if (positions == nullptr) return {};
        const auto topology = readTopology(primitive, *mode, positions->count);
        if (!topology) return {};

        GltfPrimitive result;
        result.material = material;
        result.mesh.name = name;
        if (material != kNoIndex)
            result.mesh.partNames.push_back(context_.model.materials[material].name);
        result.mesh.triangles = toTriangles(*mode, topology->corners);
        readVertices(attributes, *positions, *topology, result.mesh);
        if (!sanitize(primitive, result.mesh)) return {};
        return result;
    }

    static std::optional<PrimitiveMode> readMode(const JsonValue& primitive) {
        constexpr auto kFirst = static_cast<uint64_t>(PrimitiveMode::kTriangles);
        constexpr auto kLast = static_cast<uint64_t>(PrimitiveMode::kTriangleFan);
        const uint64_t mode = primitive.whole("mode", kFirst);
        if (mode >= kFirst && mode <= kLast) return static_cast<PrimitiveMode>(mode);
        if (mode < kFirst)
            primitive.warnOnce("points and lines are not supported; left out");
        else
            primitive.error("mode", fmt::format("{} is not from 0 to {}", mode, kLast));
        return {};
    }

    static void warnAboutUnsupported(const JsonValue& primitive, const JsonValue& attributes) {
        if (primitive.has("targets"))
            primitive.warnOnce("morph targets are not supported; meshes keep their own shape");
        if (attributes.has("TEXCOORD_2"))
            attributes.warnOnce("more than two sets of texture coordinates are not supported");
    }

    /// Null if it is absent or, with an error, wrong.
    const Accessor* findAttribute(const JsonValue& attributes, const Attribute& attribute,
                                  const Accessor* positions) const {
        const Accessor* accessor = accessors_.find(attributes, attribute.name);
        if (accessor == nullptr) return nullptr;
        const Format format{accessor->type, accessor->isNormalized};
        const bool isQuantized = contains(attribute.quantizedFormats, format);
        std::string problem;
        if (accessor->isMatrix || accessor->components < attribute.minComponents ||
            accessor->components > attribute.maxComponents)
            problem = fmt::format("the accessor must be a VEC{}", attribute.maxComponents);
        else if (isQuantized && !allowsQuantization_)
            problem = "the accessor's type needs the extension KHR_mesh_quantization";
        else if (!isQuantized && !contains(attribute.formats, format))
            problem = "the accessor's type is not allowed here";
        else if (positions != nullptr && accessor->count != positions->count)
            problem = fmt::format("{} elements, but there are {} positions", accessor->count,
                                  positions->count);
        if (problem.empty()) return accessor;
        attributes.error(attribute.name, problem);
        return nullptr;
    }

    /// Nothing if there is not a single triangle, or, with an error, if something is wrong.
    std::optional<Topology> readTopology(const JsonValue& primitive, PrimitiveMode mode,
                                         uint32_t vertices) {
        const Accessor* indices = accessors_.find(primitive, "indices");
        if (primitive.has("indices") && (indices == nullptr || !areIndices(primitive, *indices)))
            return {};
        const uint32_t corners = indices != nullptr ? indices->count : vertices;
        const uint64_t triangles = triangleCount(mode, corners);
        if (triangles == 0) {
            primitive.warning(fmt::format("left out: {} corners make no triangle", corners));
            return {};
        }
        if (!context_.spend(&GltfLimits::triangles, triangles, "triangles", primitive)) return {};
        if (mode == PrimitiveMode::kTriangles && corners % 3 != 0)
            primitive.warning(fmt::format(
                "{} corners are not a multiple of 3; the last {} left out", corners, corners % 3));
        Topology result;
        if (indices == nullptr) {
            result.count = vertices;
            if (!context_.spend(&GltfLimits::vertices, vertices, "vertices", primitive)) return {};
            result.corners.resize(corners);
            std::iota(result.corners.begin(), result.corners.end(), 0u);
            return result;
        }
        result.corners = indices->readWhole();
        const auto [low, high] = std::minmax_element(result.corners.begin(), result.corners.end());
        if (*high >= vertices) {
            primitive.error("indices",
                            fmt::format("index {} at {} is out of range: there are {} vertices",
                                        *high, high - result.corners.begin(), vertices));
            return {};
        }
        // Many primitives may share one large accessor; each takes only the range it uses.
        result.first = *low;
        result.count = *high - *low + 1;
        if (!context_.spend(&GltfLimits::vertices, result.count, "vertices", primitive)) return {};
        for (uint32_t& corner : result.corners) corner -= result.first;
        return result;
    }

    static bool areIndices(const JsonValue& primitive, const Accessor& accessor) {
        const bool isWhole = accessor.type == ComponentType::kUnsignedByte ||
                             accessor.type == ComponentType::kUnsignedShort ||
                             accessor.type == ComponentType::kUnsignedInt;
        if (accessor.components == 1 && isWhole && !accessor.isNormalized &&
            !accessor.isInterleaved)
            return true;
        primitive.error("indices",
                        "the accessor must be a SCALAR of whole numbers without sign, not "
                        "normalized, in a bufferView without byteStride");
        return false;
    }

    void readVertices(const JsonValue& attributes, const Accessor& positions,
                      const Topology& topology, Mesh& mesh) const {
        const auto find = [&](const Attribute& attribute) {
            return findAttribute(attributes, attribute, &positions);
        };
        const uint32_t first = topology.first, count = topology.count;
        mesh.positions = positions.read<3>(first, count);
        const Accessor* normals = find(kNormal);
        if (normals != nullptr) mesh.normals = normals->read<3>(first, count);
        // Tangents without normals are to be ignored (section 3.7.2.1).
        if (const Accessor* tangents = find(kTangent); tangents != nullptr && normals != nullptr)
            mesh.tangents = tangents->read<4>(first, count);
        if (const Accessor* uvs = find(kUv)) mesh.uvs = readUvs(*uvs, topology);
        if (const Accessor* uvs2 = find(kUv2)) mesh.uvs2 = readUvs(*uvs2, topology);
        if (const Accessor* colors = find(kColor))
            mesh.colors = colors->read<4>(first, count, glm::vec4(1.0f));
    }

    /// From upper left to lower left. Tangents stay right: their bitangent already points to the
    /// upper side of the picture.
    static std::vector<glm::vec2> readUvs(const Accessor& accessor, const Topology& topology) {
        std::vector<glm::vec2> uvs = accessor.read<2>(topology.first, topology.count);
        for (glm::vec2& uv : uvs) uv.y = 1.0f - uv.y;
        return uvs;
    }

    /// False if nothing is left. A mesh that vanishes is no reason to refuse a file.
    static bool sanitize(const JsonValue& primitive, Mesh& mesh) {
        Diagnostics diagnostics;
        sanitizeMesh(mesh, {}, diagnostics);
        for (const Diagnostic& d : diagnostics.list())
            primitive.warning(d.severity == Severity::kError ? "left out: " + d.message
                                                             : d.message);
        return !diagnostics.hasErrors();
    }

    ReadContext& context_;
    const Accessors& accessors_;
    bool allowsQuantization_;
};

}  // namespace

void readMeshes(ReadContext& context, const Accessors& accessors, bool allowsQuantization) {
    MeshReader(context, accessors, allowsQuantization).readAll();
}

}  // namespace vitrine
