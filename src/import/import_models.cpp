// SPDX-License-Identifier: MIT
#include "import/import_models.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/text.hpp"
#include "gltf/pose.hpp"
#include "import/imported_files.hpp"
#include "import/model_animation.hpp"
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

class Importer {
  public:
    Importer(Scene& scene, ModelLibrary& library, Diagnostics& diagnostics)
        : scene_(scene), diagnostics_(diagnostics), files_(scene, library, diagnostics) {
        for (const Node& n : scene.nodes) nodeNames_.take(n.name);
        for (const Camera& c : scene.cameras) cameraNames_.take(c.name);
        for (const Light& l : scene.lights) lightNames_.take(l.name);
    }

    void importAll() {
        const size_t shapes = scene_.shapes.size(), nodes = scene_.nodes.size();
        for (size_t i = 0; i < shapes; ++i)
            if (isModelFile(scene_.shapes[i].mesh.name)) files_.fillShape(i);
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
        if (scene_.cameras.size() < 2) return;  // none in a scene with mistakes
        const Camera& first = scene_.cameras.front();
        if (first.where.file.empty() && first.name == "default")
            scene_.cameras.erase(scene_.cameras.begin());
    }

    /// `[[node]] include = "f.glb"`
    void include(size_t number) {
        const Reference reference = scene_.nodes[number].include;
        if (!isModelFile(reference.name)) {
            diagnostics_.error(reference.where, "what is included is a .gltf or .glb file");
            return;
        }
        ImportedFile* file = files_.open(reference);
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
        const int number = chosenAnimation(model, root, diagnostics_);
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
            const ImportedFile::MeshShape& mesh = files_.shape(file, source.mesh);
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
            if (skipped > 0) warnSkippedNodes(included.reference, skipped, diagnostics_);
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
    Diagnostics& diagnostics_;
    ImportedFiles files_;
    UniqueNames nodeNames_, cameraNames_, lightNames_;
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
