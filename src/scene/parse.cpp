// SPDX-License-Identifier: MIT
#include "scene/parse.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "base/file.hpp"
#include "scene/import_overrides.hpp"
#include "scene/references.hpp"
#include "scene/values.hpp"

namespace vitrine {
namespace {

/// Walks the document section by section into the scene.
class SceneParser {
  public:
    SceneParser(Scene& scene, Diagnostics& diagnostics)
        : scene_(scene), diagnostics_(diagnostics) {}

    void parse(const toml::table& document) {
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
                named(node, section,
                      [&](const std::string& n, const toml::table& t) { material(n, t); });
            else if (section == "shape")
                named(node, section,
                      [&](const std::string& n, const toml::table& t) { shape(n, t); });
            else if (!node.is_table() && !node.is_array_of_tables())
                diagnostics_.error(
                    placeOf(key, node),
                    fmt::format("'{}' belongs to no section; write one above, such as "
                                "[render]",
                                section));
            else
                diagnostics_.error(placeOf(key, node),
                                   fmt::format("unknown section '{}'{}", section,
                                               didYouMean(section, sectionNames())));
        }
        checkReferences(scene_, diagnostics_);
    }

  private:
    template <class T>
    void single(const toml::node& node, const std::string& section, const OptionTable<T>& options,
                T& object, const std::vector<std::string>& otherKeys = {}) {
        if (const toml::table* table = node.as_table())
            readTable(*table, "[" + section + "]", options, otherKeys, object, diagnostics_);
        else
            diagnostics_.error(placeOf(node),
                               fmt::format("there is only one: write [{}]", section));
    }

    template <class F>
    void list(const toml::node& node, const std::string& section, F&& each) {
        const toml::array* array = node.as_array();
        if (array == nullptr) {
            diagnostics_.error(placeOf(node),
                               fmt::format("there can be several: write [[{}]]", section));
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
            diagnostics_.error(placeOf(node),
                               fmt::format("each has a name: write [{}.NAME]", section));
            return;
        }
        for (const auto& [key, entry] : *group) {
            if (key.str().empty())
                diagnostics_.error(placeOf(key, entry),
                                   fmt::format("the {}'s name is empty", section));
            else if (const toml::table* table = entry.as_table())
                each(std::string(key.str()), *table);
            else if (entry.is_array_of_tables())
                diagnostics_.error(
                    placeOf(key, entry),
                    fmt::format("there is only one: write [{}.{}]", section, key.str()));
            else
                diagnostics_.error(placeOf(key, entry),
                                   fmt::format("'{0}' belongs to no {1}; each has a name: write "
                                               "[{1}.NAME] above",
                                               key.str(), section));
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
                diagnostics_.error(
                    placeOf(*clash),
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
        if (camera.fov == 0 && camera.focalLength == 0)
            camera.focalLength = Camera::kDefaultFocalLength;
        const glm::vec3 forward = camera.target - camera.eye;
        if (glm::length(forward) < 1e-6f)
            diagnostics_.error(camera.where, "the camera's eye and target are the same point");
        else if (glm::length(camera.up) < 1e-6f)
            diagnostics_.error(placeOf(*table.get("up")), "up has no length");
        else if (glm::length(glm::cross(glm::normalize(forward), glm::normalize(camera.up))) <
                 1e-6f)
            diagnostics_.error(camera.where, "the camera looks along its up direction");
        scene_.cameras.push_back(camera);
    }

    void light(const toml::table& table) {
        Light light;
        light.where = placeOf(table);
        readTable(table, "[[light]]", lightOptions(), {}, light, diagnostics_);
        if (glm::length(light.direction) < 1e-6f)
            diagnostics_.error(placeOf(*table.get("direction")), "direction has no length");
        if (light.type == LightType::kSpot && light.innerAngle > light.outerAngle)
            diagnostics_.error(light.where, "inner_angle is larger than outer_angle");
        if (light.type == LightType::kSun) refuse(table, "at", "a sun light has no position");
        if (light.type == LightType::kPoint)
            refuse(table, "direction", "a point light has no direction");
        if (light.type == LightType::kSun) refuse(table, "range", "a sun light has no range");
        if (light.type != LightType::kSpot)
            for (const char* key : {"inner_angle", "outer_angle"})
                refuse(table, key, "only a spot light has a cone");
        scene_.lights.push_back(light);
    }

    void refuse(const toml::table& table, const char* key, const char* message) {
        if (const toml::node* unused = table.get(key))
            diagnostics_.error(placeOf(*unused), message);
    }

    void material(const std::string& name, const toml::table& table) {
        Material material;
        material.name = name;
        material.where = placeOf(table);
        readTable(table, "[material." + name + "]", materialOptions(), {"set"}, material,
                  diagnostics_);
        if (const toml::node* set = table.get("set"))
            readParameters(*set, "set", material.set, diagnostics_);
        scene_.materials.push_back(material);
    }

    void shape(const std::string& name, const toml::table& table) {
        Shape shape;
        shape.name = name;
        shape.where = placeOf(table);
        static const std::vector<std::string> kBuiltIn{"box", "sphere", "plane", "torus",
                                                       "cylinder"};
        const size_t mistakes = diagnostics_.list().size();
        readTable(table, "[shape." + name + "]", shapeOptions(), kBuiltIn, shape, diagnostics_);
        builtIn(table, "box", boxOptions(), shape.box);
        builtIn(table, "sphere", sphereOptions(), shape.sphere);
        builtIn(table, "plane", planeOptions(), shape.plane);
        builtIn(table, "torus", torusOptions(), shape.torus);
        builtIn(table, "cylinder", cylinderOptions(), shape.cylinder);
        if (shape.plane && std::min(shape.plane->size.x, shape.plane->size.z) <= 0)
            diagnostics_.error(placeOf(*table.get("plane")), "a plane needs a size along x and z");
        const int given = !shape.sdf.empty() + !shape.mesh.empty() + shape.box.has_value() +
                          shape.sphere.has_value() + shape.plane.has_value() +
                          shape.torus.has_value() + shape.cylinder.has_value();
        // What was meant to be the shape has been complained about.
        const bool misspelt = given == 0 && diagnostics_.list().size() > mistakes;
        if (given != 1 && !misspelt)
            diagnostics_.error(
                shape.where, fmt::format("shape '{}' must have exactly one of sdf, mesh, {}", name,
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
            diagnostics_.error(placeOf(*node), fmt::format("{} must be a table, as in {{ {} = 1 }}",
                                                           key, options[0].key));
    }

    void node(const toml::table& table) {
        Node node;
        node.where = placeOf(table);
        readTable(table, "[[node]]", nodeOptions(), {"set", "parts"}, node, diagnostics_);
        if (const toml::node* set = table.get("set"))
            readParameters(*set, "set", node.set, diagnostics_);
        if (const toml::node* parts = table.get("parts")) partMaterials(*parts, node);
        for (const char* key : {"material", "parts", "set"}) {
            const bool used = !node.shape.empty() || (!node.include.empty() && key[0] != 's');
            if (const toml::node* unused = used ? nullptr : table.get(key))
                diagnostics_.error(placeOf(*unused),
                                   fmt::format("{} has no effect: the node has no shape", key));
        }
        if (!node.shape.empty() && !node.include.empty())
            diagnostics_.error(node.include.where, "give shape or include, not both");
        for (int axis = 0; axis < 3; ++axis)
            if (node.scale[axis] == 0) {
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
            if (!readText(value, "parts." + std::string(key.str()), reference.name, diagnostics_))
                continue;
            node.parts.emplace_back(std::string(key.str()), reference);
            node.partPlaces.push_back(placeOf(key, value));
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
    for (const std::string& assignment : overrides) {
        if (namesImported(*document, assignment))
            scene.importOverrides.push_back(assignment);
        else
            applyOverride(*document, assignment, diagnostics);
    }
    // The document gives its keys by the alphabet; people read errors from the top of the file.
    Diagnostics found;
    SceneParser(scene, found).parse(*document);
    std::vector<Diagnostic> sorted = found.list();
    std::stable_sort(sorted.begin(), sorted.end(), [](const Diagnostic& a, const Diagnostic& b) {
        return std::tie(a.where.line, a.where.column) < std::tie(b.where.line, b.where.column);
    });
    for (Diagnostic& diagnostic : sorted) {
        diagnostic.message = printable(diagnostic.message);
        diagnostics.add(std::move(diagnostic));
    }
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
