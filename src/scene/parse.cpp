// SPDX-License-Identifier: MIT
#include "scene/parse.hpp"

#include <fmt/format.h>

#include <set>

#include "base/file.hpp"
#include "scene/values.hpp"

namespace vitrine {
namespace {

/// Walks the document section by section into the scene.
class SceneParser {
  public:
    SceneParser(Scene& scene, Diagnostics& diagnostics) : scene_(scene), diagnostics_(diagnostics) {}

    void parse(const toml::table& document) {
        static const std::vector<std::string> kSections{"scene", "render",   "camera", "environment",
                                                        "light", "material", "shape",  "node"};
        for (const auto& [key, node] : document) {
            const std::string section(key.str());
            if (section == "scene")
                single(node, section, sceneOptions(), scene_);
            else if (section == "render")
                single(node, section, renderOptions(), scene_.render);
            else if (section == "environment")
                environment(node);
            else if (section == "camera")
                list(node, section, [&](const toml::table& t) { camera(t); });
            else if (section == "light")
                list(node, section, [&](const toml::table& t) { light(t); });
            else if (section == "node")
                list(node, section, [&](const toml::table& t) { this->node(t); });
            else if (section == "material")
                named(node, section, [&](const std::string& n, const toml::table& t) { material(n, t); });
            else if (section == "shape")
                named(node, section, [&](const std::string& n, const toml::table& t) { shape(n, t); });
            else
                diagnostics_.error(placeOf(key), fmt::format("unknown section '{}'{}", section,
                                                             didYouMean(section, kSections)));
        }
        checkReferences();
    }

  private:
    template <class T>
    void single(const toml::node& node, const std::string& section, const OptionTable<T>& options,
                T& object, const std::vector<std::string>& otherKeys = {}) {
        if (const toml::table* table = node.as_table())
            readTable(*table, "[" + section + "]", options, otherKeys, object, diagnostics_);
        else
            diagnostics_.error(placeOf(node), fmt::format("write [{}] on a line of its own", section));
    }

    template <class F>
    void list(const toml::node& node, const std::string& section, F&& each) {
        const toml::array* array = node.as_array();
        if (array == nullptr) {
            diagnostics_.error(placeOf(node), fmt::format("there can be several: write [[{}]]", section));
            return;
        }
        for (const toml::node& entry : *array) {
            if (const toml::table* table = entry.as_table())
                each(*table);
            else
                diagnostics_.error(placeOf(entry), fmt::format("write [[{}]]", section));
        }
    }

    template <class F>
    void named(const toml::node& node, const std::string& section, F&& each) {
        const toml::table* group = node.as_table();
        if (group == nullptr) {
            diagnostics_.error(placeOf(node), fmt::format("each needs a name: write [{}.NAME]", section));
            return;
        }
        for (const auto& [key, entry] : *group) {
            if (const toml::table* table = entry.as_table())
                each(std::string(key.str()), *table);
            else
                diagnostics_.error(placeOf(key), fmt::format("write [{}.{}]", section, key.str()));
        }
    }

    void environment(const toml::node& node) {
        single(node, "environment", environmentOptions(), scene_.environment, {"sky"});
        const toml::table* table = node.as_table();
        const toml::node* sky = table != nullptr ? table->get("sky") : nullptr;
        if (sky == nullptr) return;
        Color color;
        if (!readColor(*sky, "sky", {0, 1e9}, color, diagnostics_)) return;
        for (const char* key : {"zenith", "horizon", "ground"})
            if (const toml::node* clash = table->get(key))
                diagnostics_.error(placeOf(*clash),
                                   fmt::format("{} has no effect beside sky, which is all of them", key));
        scene_.environment.zenith = scene_.environment.horizon = scene_.environment.ground = color;
    }

    void camera(const toml::table& table) {
        Camera camera;
        camera.where = placeOf(table);
        readTable(table, "[[camera]]", cameraOptions(), {}, camera, diagnostics_);
        if (camera.fov > 0 && camera.focalLength > 0)
            diagnostics_.error(placeOf(*table.get("focal_length")),
                               "give fov or focal_length, not both");
        if (camera.fov == 0 && camera.focalLength == 0) camera.focalLength = Camera::kDefaultFocalLength;
        const glm::vec3 forward = camera.target - camera.eye;
        if (glm::length(forward) < 1e-6f)
            diagnostics_.error(camera.where, "the camera's eye and target are the same point");
        else if (glm::length(glm::cross(forward, camera.up)) < 1e-6f * glm::length(forward))
            diagnostics_.error(camera.where, "the camera looks along its up direction");
        scene_.cameras.push_back(camera);
    }

    void light(const toml::table& table) {
        Light light;
        light.where = placeOf(table);
        readTable(table, "[[light]]", lightOptions(), {}, light, diagnostics_);
        if (glm::length(light.direction) < 1e-6f)
            diagnostics_.error(placeOf(*table.get("direction")), "direction has no length");
        const bool sun = light.type == LightType::kSun;
        if (const toml::node* unused = table.get(sun ? "at" : "direction"))
            diagnostics_.error(placeOf(*unused), fmt::format("a {} light has no {}", sun ? "sun" : "point",
                                                             sun ? "position" : "direction"));
        scene_.lights.push_back(light);
    }

    void material(const std::string& name, const toml::table& table) {
        Material material;
        material.name = name;
        material.where = placeOf(table);
        readTable(table, "[material." + name + "]", materialOptions(), {"set"}, material, diagnostics_);
        if (const toml::node* set = table.get("set"))
            readParameters(*set, "set", material.set, diagnostics_);
        scene_.materials.push_back(material);
    }

    void shape(const std::string& name, const toml::table& table) {
        Shape shape;
        shape.name = name;
        shape.where = placeOf(table);
        static const std::vector<std::string> kBuiltIn{"box", "sphere", "plane", "torus", "cylinder"};
        readTable(table, "[shape." + name + "]", shapeOptions(), kBuiltIn, shape, diagnostics_);
        builtIn(table, "box", boxOptions(), shape.box);
        builtIn(table, "sphere", sphereOptions(), shape.sphere);
        builtIn(table, "plane", planeOptions(), shape.plane);
        builtIn(table, "torus", torusOptions(), shape.torus);
        builtIn(table, "cylinder", cylinderOptions(), shape.cylinder);
        const int given = !shape.sdf.empty() + !shape.mesh.empty() + shape.box.has_value() +
                          shape.sphere.has_value() + shape.plane.has_value() +
                          shape.torus.has_value() + shape.cylinder.has_value();
        if (given != 1)
            diagnostics_.error(shape.where,
                               fmt::format("shape '{}' must have exactly one of sdf, mesh, {}", name,
                                           fmt::join(kBuiltIn, ", ")));
        scene_.shapes.push_back(shape);
    }

    template <class T>
    void builtIn(const toml::table& table, const std::string& key, const OptionTable<T>& options,
                 std::optional<T>& out) {
        const toml::node* node = table.get(key);
        if (node == nullptr) return;
        out.emplace();
        if (const toml::table* inner = node->as_table())
            readTable(*inner, key, options, {}, *out, diagnostics_);
        else
            diagnostics_.error(placeOf(*node), fmt::format("{} must be a table, as in {{ {} = 1 }}", key,
                                                           options[0].key));
    }

    void node(const toml::table& table) {
        Node node;
        node.where = placeOf(table);
        readTable(table, "[[node]]", nodeOptions(), {"set", "parts"}, node, diagnostics_);
        if (const toml::node* set = table.get("set"))
            readParameters(*set, "set", node.set, diagnostics_);
        if (const toml::node* parts = table.get("parts")) partMaterials(*parts, node);
        for (int axis = 0; axis < 3; ++axis)
            if (std::abs(node.scale[axis]) < 1e-6f && table.get("scale") != nullptr) {
                diagnostics_.error(placeOf(*table.get("scale")), "scale must not be zero");
                node.scale = glm::vec3(1);
            }
        scene_.nodes.push_back(node);
    }

    void partMaterials(const toml::node& parts, Node& node) {
        const toml::table* table = parts.as_table();
        if (table == nullptr) {
            diagnostics_.error(placeOf(parts), "parts must be a table, as in { lid = \"brass\" }");
            return;
        }
        for (const auto& [key, value] : *table) {
            Reference reference{{}, placeOf(value)};
            if (!readText(value, "parts", reference.name, diagnostics_)) continue;
            node.parts.emplace_back(std::string(key.str()), reference);
            node.partPlaces.push_back(placeOf(key));
        }
    }

    // ---- what one section says of another ----------------------------------------------------

    template <class T>
    std::vector<std::string> namesOf(const std::vector<T>& objects) {
        std::vector<std::string> names;
        for (const T& object : objects)
            if (!object.name.empty()) names.push_back(object.name);
        return names;
    }

    void checkName(const Reference& reference, const std::string& what,
                   const std::vector<std::string>& names) {
        if (reference.empty() || std::find(names.begin(), names.end(), reference.name) != names.end())
            return;
        diagnostics_.error(reference.where, fmt::format("no {} is named '{}'{}", what, reference.name,
                                                        didYouMean(reference.name, names)));
    }

    template <class T>
    void checkUnique(const std::vector<T>& objects, const std::string& what) {
        std::set<std::string> seen;
        for (const T& object : objects)
            if (!object.name.empty() && !seen.insert(object.name).second)
                diagnostics_.error(object.where, fmt::format("two {}s are named '{}'", what, object.name));
    }

    void checkReferences() {
        const auto materials = namesOf(scene_.materials);
        const auto shapes = namesOf(scene_.shapes);
        const auto nodes = namesOf(scene_.nodes);
        checkUnique(scene_.nodes, "node");
        checkUnique(scene_.cameras, "camera");
        checkUnique(scene_.lights, "light");
        for (const Node& node : scene_.nodes) {
            checkName(node.shape, "shape", shapes);
            checkName(node.material, "material", materials);
            checkName(node.parent, "node", nodes);
            for (const auto& [part, material] : node.parts) checkName(material, "material", materials);
        }
        checkParents();
    }

    void checkParents() {
        for (Node& node : scene_.nodes) {
            const Node* at = &node;
            for (size_t steps = 0; at != nullptr && !at->parent.empty(); ++steps) {
                if (steps > scene_.nodes.size()) {
                    diagnostics_.error(node.parent.where,
                                       fmt::format("node '{}' is its own ancestor", node.name));
                    node.parent = {};
                    break;
                }
                const Node* next = nullptr;
                for (const Node& other : scene_.nodes)
                    if (other.name == at->parent.name) next = &other;
                at = next;
            }
        }
    }

    Scene& scene_;
    Diagnostics& diagnostics_;
};

}  // namespace

Scene parseScene(std::string_view text, const std::string& file,
                 const std::vector<std::string>& overrides, Diagnostics& diagnostics) {
    Scene scene;
    scene.file = file;
    scene.folder = std::filesystem::path(file).parent_path();
    std::optional<toml::table> document = parseDocument(text, file, diagnostics);
    if (!document) return scene;
    for (const std::string& assignment : overrides) applyOverride(*document, assignment, diagnostics);
    SceneParser(scene, diagnostics).parse(*document);
    if (scene.cameras.empty()) {
        Camera camera;
        camera.name = "default";
        camera.focalLength = Camera::kDefaultFocalLength;
        scene.cameras.push_back(camera);
    }
    return scene;
}

Scene loadScene(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                Diagnostics& diagnostics) {
    return parseScene(readFile(file, kMaxSceneBytes), file.string(), overrides, diagnostics);
}

}  // namespace vitrine
