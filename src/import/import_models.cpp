// SPDX-License-Identifier: MIT
#include "import/import_models.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "base/file.hpp"
#include "base/text.hpp"
#include "gltf/pose.hpp"
#include "import/model_animation.hpp"
#include "import/model_material.hpp"
#include "import/model_mesh.hpp"
#include "import/model_names.hpp"
#include "scene/import_overrides.hpp"
#include "scene/place.hpp"
#include "scene/pose.hpp"
#include "scene/references.hpp"

namespace vitrine {
namespace {

/// Nodes that all models of a scene together may bring: a file can be included many times.
constexpr size_t kMaxNodes = 1u << 18;
/// And numbers of their animations.
constexpr size_t kMaxKeyNumbers = 1u << 25;

/// A file and what of it is in the scene already.
struct ImportedFile {
    std::string path, name;  ///< `name`: in front of the names of its materials
    std::shared_ptr<const GltfModel> model;
    std::vector<std::string> partNames;
    std::vector<std::shared_ptr<const ImageRgba8>> pictures;  ///< one an image, when used
    std::vector<std::string> materials;  ///< names in the scene, one a part name, when used
    struct MeshShape {
        bool known = false;
        std::string name;  ///< of the shape in the scene; "" if there are no triangles
        std::vector<std::string> parts;
    };
    std::vector<MeshShape> shapes;             ///< one a mesh
    std::optional<std::vector<Shape>> joined;  ///< one shape of the whole scene, or none
};

class Importer {
  public:
    Importer(Scene& scene, ModelLibrary& library, Diagnostics& diagnostics)
        : scene_(scene), library_(library), diagnostics_(diagnostics) {
        for (const Material& m : scene.materials) materialNames_.take(m.name);
        for (const Shape& s : scene.shapes) shapeNames_.take(s.name);
        for (const Node& n : scene.nodes) nodeNames_.take(n.name);
        for (const Camera& c : scene.cameras) cameraNames_.take(c.name);
        for (const Light& l : scene.lights) lightNames_.take(l.name);
    }

    void importAll() {
        const size_t shapes = scene_.shapes.size(), nodes = scene_.nodes.size();
        for (size_t i = 0; i < shapes; ++i)
            if (isModelFile(scene_.shapes[i].mesh.name)) fillShape(i);
        for (size_t i = 0; i < nodes; ++i)
            if (!scene_.nodes[i].include.empty()) include(i);
        // Nodes place the lights, and only then can a light be put elsewhere.
        applyOverrides(false);
        checkImportedReferences(scene_, diagnostics_);
        checkPlaces(nodes);
        applyOverrides(true);
        dropDefaultCamera();
    }

  private:
    /// A camera or light of a model, to be placed when all nodes are there.
    struct Attached {
        size_t node;
        size_t camera, light;  ///< kNone: there is none
    };
    static constexpr size_t kNone = ~size_t{0};

    void applyOverrides(bool ofLights) {
        for (const std::string& assignment : scene_.importOverrides)
            if (startsWith(assignment, "light.") == ofLights)
                applyImportOverride(scene_, assignment, diagnostics_);
    }

    /// The camera that a scene without any is given is not needed beside a model's.
    void dropDefaultCamera() {
        const Camera& first = scene_.cameras.front();
        if (scene_.cameras.size() > 1 && first.where.file.empty() && first.name == "default")
            scene_.cameras.erase(scene_.cameras.begin());
    }

    ImportedFile* open(const Reference& reference) {
        std::filesystem::path path;
        try {
            path = resolveInside(scene_.folder, reference.name);
        } catch (const std::invalid_argument& e) {
            diagnostics_.error(reference.where, fmt::format("'{}': {}", reference.name, e.what()));
            return nullptr;
        }
        std::error_code error;
        if (!std::filesystem::exists(path, error)) {
            diagnostics_.error(reference.where,
                               fmt::format("'{}': there is no such file", reference.name));
            return nullptr;
        }
        const auto model = library_.read(path, diagnostics_);
        if (model == nullptr) return nullptr;
        for (const auto& known : files_)
            if (known->model == model) return known.get();
        auto file = std::make_unique<ImportedFile>();
        file->path = path.string();
        file->name = fileNames_.make(path.stem().string());
        file->model = model;
        file->partNames = partNamesOf(*model);
        file->pictures.resize(model->images.size());
        file->materials.resize(file->partNames.size());
        file->shapes.resize(model->meshes.size());
        files_.push_back(std::move(file));
        return files_.back().get();
    }

    std::shared_ptr<const ImageRgba8> picture(ImportedFile& file, int image) {
        auto& known = file.pictures[static_cast<size_t>(image)];
        if (known == nullptr)
            known = std::make_shared<ImageRgba8>(decodeGltfImage(
                file.model->images[static_cast<size_t>(image)], file.path, diagnostics_));
        return known;
    }

    /// The name in the scene of a model's material, which is there from now on.
    const std::string& material(ImportedFile& file, int number) {
        const size_t part =
            number == kNoIndex ? file.partNames.size() - 1 : static_cast<size_t>(number);
        std::string& name = file.materials[part];
        if (!name.empty()) return name;
        name = materialNames_.make(file.name + '/' + file.partNames[part]);
        Material made =
            materialOf(*file.model, number, [&](int image) { return picture(file, image); });
        made.name = name;
        made.where = {file.path};
        scene_.materials.push_back(std::move(made));
        return name;
    }

    void giveMesh(Shape& shape, ImportedFile& file, ModelMesh mesh) {
        for (size_t i = 0; i < mesh.materials.size(); ++i)
            shape.partMaterials.emplace_back(mesh.mesh.partNames[i],
                                             material(file, mesh.materials[i]));
        shape.imported = std::make_shared<Mesh>(std::move(mesh.mesh));
    }

    /// `[shape.X] mesh = "f.glb"`
    void fillShape(size_t number) {
        const Reference reference = scene_.shapes[number].mesh;
        ImportedFile* file = open(reference);
        if (file == nullptr) return;
        if (!file->joined) file->joined = joined(*file, reference);
        if (file->joined->empty()) return;
        scene_.shapes[number].imported = file->joined->front().imported;
        scene_.shapes[number].partMaterials = file->joined->front().partMaterials;
    }

    std::vector<Shape> joined(ImportedFile& file, const Reference& reference) {
        const MeshSize size = sizeOfScene(*file.model);
        const GltfLimits limits;
        if (size.vertices > limits.vertices || size.triangles > limits.triangles) {
            diagnostics_.error(reference.where,
                               fmt::format("'{}' is too large for one shape: {} triangles, as its "
                                           "meshes stand in many places; use it by "
                                           "include",
                                           reference.name, size.triangles));
            return {};
        }
        size_t skipped = 0;
        auto mesh = joinScene(*file.model, skipped);
        if (skipped > 0) warnSkipped(reference, skipped);
        if (!mesh) {
            diagnostics_.error(reference.where,
                               fmt::format("'{}' has no triangles to show", reference.name));
            return {};
        }
        std::vector<Shape> shapes(1);
        giveMesh(shapes[0], file, std::move(*mesh));
        return shapes;
    }

    void warnSkipped(const Reference& reference, size_t count) {
        diagnostics_.warning(
            reference.where,
            fmt::format("{} node{} of '{}' left out: with {} parents too flat, small or large",
                        count, count == 1 ? "" : "s", reference.name,
                        count == 1 ? "its" : "their"));
    }

    const ImportedFile::MeshShape& shape(ImportedFile& file, int mesh) {
        ImportedFile::MeshShape& known = file.shapes[static_cast<size_t>(mesh)];
        if (known.known) return known;
        known.known = true;
        const GltfMesh& source = file.model->meshes[static_cast<size_t>(mesh)];
        auto joined = joinMesh(*file.model, source);
        if (!joined) return known;
        Shape made;
        made.name = known.name = shapeNames_.make(file.name + '/' + source.name);
        made.where = {file.path};
        known.parts = joined->mesh.partNames;
        giveMesh(made, file, std::move(*joined));
        scene_.shapes.push_back(std::move(made));
        return known;
    }

    /// `[[node]] include = "f.glb"`
    void include(size_t number) {
        const Reference reference = scene_.nodes[number].include;
        if (!isModelFile(reference.name)) {
            diagnostics_.error(reference.where, "what is included is a .gltf or .glb file");
            return;
        }
        ImportedFile* file = open(reference);
        if (file == nullptr) return;
        const GltfModel& model = *file->model;
        const std::vector<int> order = nodesOfScene(model, model.scene);
        added_ += order.size();
        if (added_ > kMaxNodes) {
            diagnostics_.error(
                reference.where,
                fmt::format("the models of the scene have more than {} nodes", kMaxNodes));
            return;
        }
        Node& root = scene_.nodes[number];
        if (root.name.empty()) root.name = nodeNames_.make(std::string(file->name));
        checkParts(root, *file);
        const Node parent = root;  // adding nodes moves it
        std::vector<std::string> names(model.nodes.size());
        std::vector<std::optional<size_t>> sceneNode(model.nodes.size());
        includes_.push_back({reference, scene_.nodes.size(), 0});
        for (const int i : order) {
            const GltfNode& node = model.nodes[static_cast<size_t>(i)];
            const std::string& up =
                node.parent == kNoIndex ? parent.name : names[static_cast<size_t>(node.parent)];
            sceneNode[static_cast<size_t>(i)] = scene_.nodes.size();
            names[static_cast<size_t>(i)] =
                addNode(*file, node, parent, up.empty() ? parent.name : up);
        }
        includes_.back().end = scene_.nodes.size();
        animate(model, parent, sceneNode);
    }

    /// Adds the tracks of the animation that plays.
    void animate(const GltfModel& model, const Node& root,
                 const std::vector<std::optional<size_t>>& sceneNode) {
        const int number = animationOf(model, root);
        if (number == kNoIndex) return;
        const GltfAnimation& animation = model.animations[static_cast<size_t>(number)];
        keyNumbers_ += sizeOf(animation);
        if (keyNumbers_ > kMaxKeyNumbers) {
            diagnostics_.error(root.include.where,
                               "the animations of the scene's models are too long together");
            return;
        }
        for (AnimationTrack& track : tracksOf(animation, sceneNode, root.include.where))
            scene_.animations.push_back(std::move(track));
    }

    /// The one that a node of the scene chooses of its model.
    int animationOf(const GltfModel& model, const Node& root) {
        std::vector<std::string> names;
        for (const GltfAnimation& animation : model.animations) names.push_back(animation.name);
        const std::string& wanted = root.animation.name;
        const auto found = std::find(names.begin(), names.end(), wanted);
        if (found != names.end()) return static_cast<int>(found - names.begin());
        if (!wanted.empty()) {
            if (wanted != "none")
                diagnostics_.error(root.animation.where,
                                   fmt::format("'{}' has no animation '{}'{}", root.include.name,
                                               wanted, didYouMean(wanted, names)));
            return kNoIndex;
        }
        const int first = firstAnimation(model);
        if (first == kNoIndex || names.size() == 1) return first;
        constexpr size_t kMostNames = 12;
        const std::string playing = names[static_cast<size_t>(first)];
        names.erase(names.begin() + first);
        const size_t unnamed = names.size() - std::min(names.size(), kMostNames);
        names.resize(names.size() - unnamed);
        diagnostics_.warning(
            root.include.where,
            printable(fmt::format(
                "'{}' has more than one animation: '{}' plays, and not '{}'{}; choose with "
                "animation = \"NAME\"",
                root.include.name, playing, fmt::join(names, "', '"),
                unnamed == 0 ? "" : fmt::format(" and {} more", unnamed))));
        return first;
    }

    /// Parts that a node names must be materials of its model.
    void checkParts(const Node& node, const ImportedFile& file) {
        for (size_t i = 0; i < node.parts.size(); ++i) {
            const std::string& part = node.parts[i].first;
            if (std::find(file.partNames.begin(), file.partNames.end(), part) ==
                file.partNames.end())
                diagnostics_.error(node.partPlaces[i],
                                   fmt::format("'{}' has no material '{}'{}", node.include.name,
                                               part, didYouMean(part, file.partNames)));
        }
    }

    std::string addNode(ImportedFile& file, const GltfNode& source, const Node& root,
                        const std::string& parent) {
        Node node;
        node.name = nodeNames_.make(root.name + '/' + source.name);
        node.parent = {parent, root.include.where};
        node.where = root.include.where;
        node.visible = root.visible;
        if (source.matrix) {
            node.matrix = source.matrix;
        } else {
            node.at = source.translation;
            node.orientation = glm::normalize(source.rotation);
            node.scale = source.scale;
        }
        if (source.mesh != kNoIndex) {
            const ImportedFile::MeshShape& mesh = shape(file, source.mesh);
            node.shape = {mesh.name, root.include.where};
            if (!mesh.name.empty()) node.material = root.material;
            for (size_t i = 0; i < root.parts.size(); ++i)
                if (std::find(mesh.parts.begin(), mesh.parts.end(), root.parts[i].first) !=
                    mesh.parts.end()) {
                    node.parts.push_back(root.parts[i]);
                    node.partPlaces.push_back(root.partPlaces[i]);
                }
        }
        attach(*file.model, source, root);
        scene_.nodes.push_back(std::move(node));
        return scene_.nodes.back().name;
    }

    /// Cameras and lights get all but their places, which overrides of nodes may still change.
    void attach(const GltfModel& model, const GltfNode& source, const Node& root) {
        Attached attached{scene_.nodes.size(), kNone, kNone};
        if (source.camera != kNoIndex) {
            const GltfCamera& from = model.cameras[static_cast<size_t>(source.camera)];
            if (from.isPerspective) {
                Camera camera;
                camera.name = cameraNames_.make(root.name + '/' + from.name);
                camera.fov = std::clamp(glm::degrees(from.yfov), 0.1f, 170.0f);
                camera.where = root.include.where;
                attached.camera = scene_.cameras.size();
                scene_.cameras.push_back(camera);
            }
        }
        if (source.light != kNoIndex && root.visible) {
            const GltfLight& from = model.lights[static_cast<size_t>(source.light)];
            Light light;
            light.name = lightNames_.make(root.name + '/' + from.name);
            light.type = from.type == GltfLightType::kDirectional ? LightType::kSun
                         : from.type == GltfLightType::kPoint     ? LightType::kPoint
                                                                  : LightType::kSpot;
            light.color.rgb = from.color;
            light.intensity = from.intensity;
            light.range = from.range;
            light.innerAngle = glm::degrees(from.innerConeAngle);
            light.outerAngle = glm::degrees(from.outerConeAngle);
            light.where = root.include.where;
            attached.light = scene_.lights.size();
            scene_.lights.push_back(light);
        }
        if (attached.camera != kNone || attached.light != kNone) attached_.push_back(attached);
    }

    /// Whose place in the world no floats can express is not drawn. What moves may come from there.
    void checkPlaces(size_t firstImported) {
        world_ = worldFromNodes(scene_);
        const std::vector<bool> moved = movedNodes(scene_);
        for (const Included& included : includes_) {
            size_t skipped = 0;
            for (size_t i = std::max(included.first, firstImported); i < included.end; ++i)
                if (!scene_.nodes[i].shape.empty() && !moved[i] && !isUsablePlace(world_[i])) {
                    scene_.nodes[i].shape = {};
                    scene_.nodes[i].material = {};
                    scene_.nodes[i].parts.clear();
                    ++skipped;
                }
            if (skipped > 0) warnSkipped(included.reference, skipped);
        }
        for (const Attached& attached : attached_) place(attached, moved[attached.node]);
    }

    void place(const Attached& attached, bool moved) {
        const glm::mat4& world = world_[attached.node];
        const bool usable = isUsablePlace(world);
        if (attached.camera != kNone) {
            Camera& camera = scene_.cameras[attached.camera];
            camera.node = attached.node;
            if (usable) placeOn(world, camera);
        }
        if (attached.light != kNone) {
            Light& light = scene_.lights[attached.light];
            light.node = attached.node;
            if (usable) placeOn(world, light);
            if (!usable && !moved) light.intensity = 0;
        }
    }

    struct Included {
        Reference reference;
        size_t first, end;  ///< nodes of the scene
    };

    Scene& scene_;
    ModelLibrary& library_;
    Diagnostics& diagnostics_;
    UniqueNames materialNames_, shapeNames_, nodeNames_, cameraNames_, lightNames_, fileNames_;
    std::vector<std::unique_ptr<ImportedFile>> files_;
    std::vector<Attached> attached_;
    std::vector<Included> includes_;
    std::vector<glm::mat4> world_;
    size_t added_ = 0, keyNumbers_ = 0;
};

}  // namespace

void importModels(Scene& scene, ModelLibrary& library, Diagnostics& diagnostics) {
    Importer(scene, library, diagnostics).importAll();
}

}  // namespace vitrine
