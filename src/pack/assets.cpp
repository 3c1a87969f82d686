// SPDX-License-Identifier: MIT
#include "pack/assets.hpp"

#include <fmt/format.h>

#include <chrono>
#include <map>
#include <stdexcept>

#include "base/file.hpp"
#include "base/text.hpp"
#include "image/decode.hpp"
#include "image/exr.hpp"
#include "image/hdr.hpp"
#include "mesh/obj.hpp"
#include "mesh/primitives.hpp"
#include "pack/atmosphere.hpp"
#include "pack/tree_options.hpp"
#include "scene/references.hpp"

namespace vitrine {
namespace {

constexpr uint64_t kMaxSnippetBytes = 64u << 10;
constexpr uint64_t kMaxPictureBytes = 256u << 20;

/// Reads the files of one scene, each once.
class AssetReader {
  public:
    AssetReader(const Scene& scene, Diagnostics& diagnostics)
        : scene_(scene), diagnostics_(diagnostics) {}

    std::shared_ptr<const MeshAsset> mesh(const Shape& shape) {
        if (shape.imported != nullptr) return build(shape.imported);
        std::optional<Mesh> mesh;
        if (!shape.mesh.empty()) {
            const auto known = meshes_.find(shape.mesh.name);
            if (known != meshes_.end()) return known->second;
            if (isModelFile(shape.mesh.name)) return nullptr;  // what is wrong has been said
            if (!endsWith(shape.mesh.name, ".obj"))
                diagnostics_.error(shape.mesh.where, "a mesh is an .obj, .gltf or .glb file");
            else if (const auto text = read(shape.mesh, kMaxObjBytes))
                mesh = readObj(*text, path_, diagnostics_);
        } else if (shape.box) {
            mesh = makeBox(shape.box->size * 0.5f);
        } else if (shape.sphere) {
            mesh = makeSphere(shape.sphere->radius);
        } else if (shape.plane) {
            mesh = makePlane(shape.plane->size.x * 0.5f, shape.plane->size.z * 0.5f);
        } else if (shape.torus) {
            const TorusShape& t = *shape.torus;
            mesh = makeTorus(t.radius, t.tube, t.segments, t.sides, t.arc);
        } else if (shape.cylinder) {
            mesh = makeCylinder(shape.cylinder->radius, shape.cylinder->height * 0.5f);
        }
        std::shared_ptr<const MeshAsset> asset;
        if (mesh) asset = build(std::make_shared<Mesh>(std::move(*mesh)));
        if (!shape.mesh.empty()) meshes_[shape.mesh.name] = asset;
        return asset;
    }

    std::shared_ptr<const Snippet> snippet(const Reference& file, SnippetKind kind,
                                           std::string_view suffix) {
        if (file.empty()) return nullptr;
        if (!endsWith(file.name, suffix)) {
            diagnostics_.error(file.where, fmt::format("the file's name must end in {}", suffix));
            return nullptr;
        }
        const auto known = snippets_.find(file.name);
        if (known != snippets_.end()) return known->second;
        std::shared_ptr<const Snippet> asset;
        if (const auto text = read(file, kMaxSnippetBytes)) {
            if (auto snippet = parseSnippet(*text, path_, kind, diagnostics_))
                asset = std::make_shared<Snippet>(std::move(*snippet));
        }
        return snippets_[file.name] = asset;
    }

    std::shared_ptr<const ImageRgba8> picture(const MaterialTexture& texture) {
        if (texture.file.empty()) return texture.image;
        const auto known = pictures_.find(texture.file.name);
        if (known != pictures_.end()) return known->second;
        std::shared_ptr<const ImageRgba8> asset;
        if (const auto bytes = read(texture.file, kMaxPictureBytes)) {
            try {
                asset = std::make_shared<ImageRgba8>(decodeImage(
                    {reinterpret_cast<const uint8_t*>(bytes->data()), bytes->size()}, path_));
            } catch (const InputError& e) {
                diagnostics_.append(e.diagnostics());
            }
        }
        return pictures_[texture.file.name] = asset;
    }

    std::shared_ptr<const SkyAsset> sky(const Environment& environment) {
        auto asset = std::make_shared<SkyAsset>();
        if (environment.atmosphere) {
            const Atmosphere air = makeAtmosphere(
                {environment.sunElevation, environment.turbidity, environment.ground.rgb});
            asset->map = makeSkyMap(air.sky);
            asset->sun = {air.sunIrradiance, kSunRadiusDegrees};
            return asset;
        }
        if (environment.picture.empty()) return nullptr;
        const auto bytes = read(environment.picture, kMaxPictureBytes);
        if (!bytes) return nullptr;
        try {
            const std::span content(reinterpret_cast<const uint8_t*>(bytes->data()), bytes->size());
            asset->map =
                makeSkyMap(isHdr(content) ? decodeHdr(content, path_) : decodeSkyExr(content));
        } catch (const InputError& e) {
            diagnostics_.append(e.diagnostics());
            return nullptr;
        }
        if (asset->map.mendedTexels > 0)
            diagnostics_.warning(
                environment.picture.where,
                fmt::format("'{}': {} texels are negative, infinite or no numbers; they count as "
                            "the nearest light there is",
                            environment.picture.name, asset->map.mendedTexels));
        return asset;
    }

  private:
    ImageRgba32f decodeSkyExr(std::span<const uint8_t> content) const {
        const ImageSize size = exrSize(content, path_);
        if (size.pixelCount() > kMaxHdrPixels)
            throw InputError(
                {path_}, fmt::format("a sky of {} x {} pixels is too large; at most {} are read",
                                     size.width, size.height, kMaxHdrPixels));
        return decodeExr(content, path_);
    }

    /// The content; `path_` is then where it came from.
    std::optional<std::string> read(const Reference& file, uint64_t limit) {
        try {
            const std::filesystem::path path = resolveInside(scene_.folder, file.name);
            path_ = path.string();
            return readFile(path, limit);
        } catch (const std::invalid_argument& e) {
            diagnostics_.error(file.where, fmt::format("'{}': {}", file.name, e.what()));
        } catch (const InputError& e) {
            // The place that can be mended is where the scene names the file.
            for (const Diagnostic& d : e.diagnostics().list())
                diagnostics_.error(file.where, fmt::format("'{}': {}", file.name, d.message));
        }
        return {};
    }

    /// Shapes that share a mesh share its tree.
    std::shared_ptr<const MeshAsset> build(const std::shared_ptr<const Mesh>& mesh) {
        auto& known = built_[mesh.get()];
        if (known != nullptr) return known;
        auto asset = std::make_shared<MeshAsset>();
        asset->mesh = mesh;
        const auto start = std::chrono::steady_clock::now();
        asset->bvh = buildTriangleBvh(mesh->positions, mesh->triangles, buildOptions(scene_.bvh));
        asset->buildSeconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        return known = asset;
    }

    const Scene& scene_;
    Diagnostics& diagnostics_;
    std::string path_;
    std::map<std::string, std::shared_ptr<const MeshAsset>> meshes_;
    std::map<const Mesh*, std::shared_ptr<const MeshAsset>> built_;
    std::map<std::string, std::shared_ptr<const Snippet>> snippets_;
    std::map<std::string, std::shared_ptr<const ImageRgba8>> pictures_;
};

}  // namespace

std::array<const MaterialTexture*, VITRINE_SLOT_COUNT> materialTextures(const Material& m) {
    return {&m.baseColorTexture,          &m.metallicRoughnessTexture, &m.normalTexture,
            &m.occlusionTexture,          &m.emissionTexture,          &m.transmissionTexture,
            &m.specularTexture,           &m.specularColorTexture,     &m.clearcoatTexture,
            &m.clearcoatRoughnessTexture, &m.clearcoatNormalTexture,   &m.sheenColorTexture,
            &m.sheenRoughnessTexture};
}

Assets loadAssets(const Scene& scene, Diagnostics& diagnostics) {
    Assets assets;
    AssetReader reader(scene, diagnostics);
    for (const Shape& shape : scene.shapes) {
        assets.meshes.push_back(shape.sdf.empty() ? reader.mesh(shape) : nullptr);
        assets.fields.push_back(reader.snippet(shape.sdf, SnippetKind::kField, ".sdf.glsl"));
    }
    for (const Material& material : scene.materials) {
        assets.materials.push_back(
            reader.snippet(material.snippet, SnippetKind::kMaterial, ".mat.glsl"));
        auto& pictures = assets.pictures.emplace_back();
        for (const MaterialTexture* texture : materialTextures(material))
            pictures.push_back(reader.picture(*texture));
    }
    assets.sky = reader.sky(scene.environment);
    return assets;
}

}  // namespace vitrine
