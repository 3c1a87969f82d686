// SPDX-License-Identifier: MIT
#include "pack/assets.hpp"

#include <fmt/format.h>

#include <chrono>
#include <functional>
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
    AssetReader(const Scene& scene, AssetCache& cache, Diagnostics& diagnostics)
        : scene_(scene), cache_(cache), diagnostics_(diagnostics) {}

    std::shared_ptr<const MeshAsset> mesh(const Shape& shape) {
        // Shapes that share a mesh share its tree. The tree keeps the mesh, and so its address.
        if (shape.imported != nullptr)
            return tree(fmt::format("{}", fmt::ptr(shape.imported.get())),
                        [&] { return shape.imported; });
        const auto make = [&]() -> std::shared_ptr<const Mesh> {
            auto mesh = makeMesh(shape);
            return mesh ? std::make_shared<const Mesh>(std::move(*mesh)) : nullptr;
        };
        if (shape.mesh.empty()) return tree(keyOf(shape), make);
        const auto known = meshes_.find(shape.mesh.name);
        if (known != meshes_.end()) return known->second;
        return meshes_[shape.mesh.name] = tree(pathOf(shape.mesh), make);
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
        const auto asset =
            cache_.pictures.get(pathOf(texture.file), [&]() -> std::shared_ptr<const ImageRgba8> {
                const auto bytes = read(texture.file, kMaxPictureBytes);
                if (!bytes) return nullptr;
                try {
                    return std::make_shared<ImageRgba8>(decodeImage(
                        {reinterpret_cast<const uint8_t*>(bytes->data()), bytes->size()}, path_));
                } catch (const InputError& e) {
                    diagnostics_.append(e.diagnostics());
                    return nullptr;
                }
            });
        return pictures_[texture.file.name] = asset;
    }

    std::shared_ptr<const SkyAsset> sky(const Environment& e) {
        if (e.atmosphere)
            return cache_.skies.get(fmt::format("{} {} {} {} {}", e.sunElevation, e.turbidity,
                                                e.ground.rgb.x, e.ground.rgb.y, e.ground.rgb.z),
                                    [&] { return makeSky(e); });
        if (e.picture.empty()) return nullptr;
        return cache_.skies.get(pathOf(e.picture), [&] { return makeSky(e); });
    }

  private:
    std::shared_ptr<const SkyAsset> makeSky(const Environment& environment) {
        auto asset = std::make_shared<SkyAsset>();
        if (environment.atmosphere) {
            const Atmosphere air = makeAtmosphere(
                {environment.sunElevation, environment.turbidity, environment.ground.rgb});
            asset->map = makeSkyMap(air.sky);
            asset->sun = {air.sunIrradiance, kSunRadiusDegrees};
            return asset;
        }
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

    std::optional<Mesh> makeMesh(const Shape& shape) {
        if (!shape.mesh.empty()) {
            if (isModelFile(shape.mesh.name)) return {};  // what is wrong has been said
            if (!endsWith(shape.mesh.name, ".obj")) {
                diagnostics_.error(shape.mesh.where, "a mesh is an .obj, .gltf or .glb file");
                return {};
            }
            const auto text = read(shape.mesh, kMaxObjBytes);
            return text ? readObj(*text, path_, diagnostics_) : std::nullopt;
        }
        if (shape.box) return makeBox(shape.box->size * 0.5f);
        if (shape.sphere) return makeSphere(shape.sphere->radius);
        if (shape.plane) return makePlane(shape.plane->size.x * 0.5f, shape.plane->size.z * 0.5f);
        if (shape.torus) {
            const TorusShape& t = *shape.torus;
            return makeTorus(t.radius, t.tube, t.segments, t.sides, t.arc);
        }
        if (shape.cylinder)
            return makeCylinder(shape.cylinder->radius, shape.cylinder->height * 0.5f);
        return {};
    }

    /// What a built-in shape is made from.
    static std::string keyOf(const Shape& shape) {
        std::string key = shape.name;
        const auto add = [&key](auto... values) { ((key += fmt::format(" {}", values)), ...); };
        if (shape.box) add("box", shape.box->size.x, shape.box->size.y, shape.box->size.z);
        if (shape.sphere) add("sphere", shape.sphere->radius);
        if (shape.plane) add("plane", shape.plane->size.x, shape.plane->size.z);
        if (const auto& t = shape.torus)
            add("torus", t->radius, t->tube, t->segments, t->sides, t->arc);
        if (shape.cylinder) add("cylinder", shape.cylinder->radius, shape.cylinder->height);
        return key;
    }

    [[nodiscard]] std::string pathOf(const Reference& file) const {
        return (scene_.folder / file.name).lexically_normal().string();
    }

    /// A mesh with its tree, which depends on what the scene says about trees as well.
    std::shared_ptr<const MeshAsset> tree(
        const std::string& key, const std::function<std::shared_ptr<const Mesh>()>& makeMesh) {
        const TreeSettings& t = scene_.bvh;
        const std::string whole =
            fmt::format("{}\n{} {} {} {} {}", key, static_cast<int>(t.builder), t.maxLeafSize,
                        t.traversalCost, t.maxDuplicates, t.minOverlap);
        return cache_.trees.get(whole, [&]() -> std::shared_ptr<const MeshAsset> {
            const auto mesh = makeMesh();
            return mesh != nullptr ? build(mesh) : nullptr;
        });
    }

    [[nodiscard]] std::shared_ptr<const MeshAsset> build(
        const std::shared_ptr<const Mesh>& mesh) const {
        auto asset = std::make_shared<MeshAsset>();
        asset->mesh = mesh;
        const auto start = std::chrono::steady_clock::now();
        asset->bvh = buildTriangleBvh(mesh->positions, mesh->triangles, buildOptions(scene_.bvh));
        asset->buildSeconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        return asset;
    }

    const Scene& scene_;
    AssetCache& cache_;
    Diagnostics& diagnostics_;
    std::string path_;
    std::map<std::string, std::shared_ptr<const MeshAsset>> meshes_;
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
    AssetCache cache;
    return loadAssets(scene, cache, diagnostics);
}

Assets loadAssets(const Scene& scene, AssetCache& cache, Diagnostics& diagnostics) {
    Assets assets;
    AssetReader reader(scene, cache, diagnostics);
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
