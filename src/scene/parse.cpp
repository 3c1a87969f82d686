// SPDX-License-Identifier: MIT
#include "scene/parse.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "base/file.hpp"
#include "base/text.hpp"
#include "scene/animations.hpp"
#include "scene/cameras.hpp"
#include "scene/import_overrides.hpp"
#include "scene/include.hpp"
#include "scene/references.hpp"
#include "scene/values.hpp"

namespace vitrine {
namespace {

constexpr float kDefaultSphereRadius = 0.1f;

/// Walks the document section by section into the scene.
class SceneParser {
  public:
    SceneParser(Scene& scene, const std::vector<std::string>& overrides, const IncludedFiles& files,
                Diagnostics& diagnostics)
        : scene_(scene), overrides_(overrides), files_(files), diagnostics_(diagnostics) {}

    void parse(const toml::table& document) {
        for (const auto& [key, node] : document) {
            const std::string section(key.str());
            if (section == "scene")
                about(node);
            else if (section == "render")
                single(node, section, renderOptions(), scene_.render);
            else if (section == "bvh")
                single(node, section, bvhOptions(), scene_.bvh);
            else if (section == "environment")
                environment(node);
            else if (section == "camera")
                list(node, section, [&](const toml::table& t) {
                    scene_.cameras.push_back(
                        readCamera(t, scene_.cameras.size(), ways_, diagnostics_));
                });
            else if (section == "light")
                list(node, section, [&](const toml::table& t) { light(t); });
            else if (section == "node")
                list(node, section, [&](const toml::table& t) { this->node(t); });
            else if (section == "animation")
                list(node, section, [](const toml::table&) {});  // below: they need all the rest
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
        readAnimations(document["animation"].as_array(), std::move(ways_), overrides_, scene_,
                       diagnostics_);
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

    void about(const toml::node& node) {
        single(node, "scene", sceneOptions(), scene_, {"include"});
        const toml::table* table = node.as_table();
        const toml::node* include = table != nullptr ? table->get("include") : nullptr;
        if (include != nullptr && placeOf(*include).line == 0)
            diagnostics_.error(placeOf(*include), "what is included stands in the scene");
    }

    void environment(const toml::node& node) {
        Environment& environment = scene_.environment;
        single(node, "environment", environmentOptions(), environment, {"sky"});
        const toml::table* table = node.as_table();
        if (table == nullptr) return;
        const toml::node* sky = table->get("sky");
        if (sky != nullptr && !readSky(*sky, environment)) return;
        if (!environment.atmosphere)
            for (const char* key : {"sun_elevation", "sun_azimuth", "turbidity"})
                refuse(*table, key, fmt::format("{} has no effect: sky is not \"sun\"", key));
        if (!environment.atmosphere && environment.picture.empty())
            refuse(*table, "rotation", "rotation has no effect: sky is no picture");
        if (sky == nullptr) return;
        for (const char* key : {"zenith", "horizon", "ground"})
            if (!(environment.atmosphere && std::string_view(key) == "ground"))
                refuse(*table, key,
                       fmt::format("{} has no effect beside sky, which is all of them", key));
    }

    /// A colour, a file, or "sun".
    bool readSky(const toml::node& sky, Environment& environment) {
        const auto* text = sky.as_string();
        if (text == nullptr || text->get().starts_with('#')) {
            Color color;
            if (!readColor(sky, "sky", {0, 1e9}, color, diagnostics_)) return false;
            environment.zenith = environment.horizon = environment.ground = color;
            return true;
        }
        environment.atmosphere = text->get() == "sun";
        if (environment.atmosphere) return true;
        if (!endsWith(text->get(), ".hdr") && !endsWith(text->get(), ".exr")) {
            diagnostics_.error(
                placeOf(sky),
                fmt::format("sky must be \"sun\", a colour, or a .hdr or .exr file, not '{}'",
                            text->get()));
            return false;
        }
        environment.picture = {files_.fromSceneFolder(text->get(), placeOf(sky)), placeOf(sky)};
        return true;
    }

    void light(const toml::table& table) {
        Light light;
        light.where = placeOf(table);
        readTable(table, "[[light]]", lightOptions(), {}, light, diagnostics_);
        if (glm::length(light.direction) < 1e-6f)
            diagnostics_.error(placeOf(*table.get("direction")), "direction has no length");
        if (light.type == LightType::kSpot && light.innerAngle > light.outerAngle)
            diagnostics_.error(light.where, "inner_angle is larger than outer_angle");
        const bool sun = light.type == LightType::kSun, rect = light.type == LightType::kRect;
        const bool round = light.type == LightType::kPoint || light.type == LightType::kSphere;
        if (light.type == LightType::kSphere && light.radius == 0) {
            if (const toml::node* radius = table.get("radius"))
                diagnostics_.error(placeOf(*radius),
                                   "a sphere light needs a radius; a point has none");
            light.radius = kDefaultSphereRadius;
        }
        if (sun && light.radius > 90)
            diagnostics_.error(placeOf(*table.get("radius")),
                               "the radius of a sun is at most 90 degrees");
        if (rect && std::min(light.size.x, light.size.y) <= 0)
            diagnostics_.error(placeOf(*table.get("size")),
                               "a rect light needs a width and a height");
        angles(table, sun || light.type == LightType::kSpot);
        if (sun) refuse(table, "at", "a sun light has no position");
        if (sun) refuse(table, "range", "a sun light has no range");
        if (round)
            refuse(table, "direction",
                   fmt::format("a {} light has no direction",
                               light.type == LightType::kPoint ? "point" : "sphere"));
        if (rect) refuse(table, "radius", "a rect light has a size instead of a radius");
        if (!rect) refuse(table, "size", "only a rect light has a size; others have a radius");
        if (light.type != LightType::kSpot)
            for (const char* key : {"inner_angle", "outer_angle"})
                refuse(table, key, "only a spot light has a cone");
        scene_.lights.push_back(light);
    }

    void angles(const toml::table& table, bool possible) {
        for (const char* key : {"polar", "azimuth"}) {
            if (!possible) refuse(table, key, fmt::format("only a sun or a spot has {}", key));
            if (possible && table.contains("direction"))
                refuse(table, key, "give direction, or polar and azimuth, not both");
        }
        if (possible && !table.contains("direction") && !table.contains("polar"))
            refuse(table, "azimuth", "azimuth needs polar, the angle from the zenith");
    }

    void refuse(const toml::table& table, const char* key, const std::string& message) {
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
        relocate(materialOptions(), material);
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
        relocate(shapeOptions(), shape);
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
        if (node.include.empty())
            refuse(table, "animation", "animation has no effect: the node includes no model");
        for (int axis = 0; axis < 3; ++axis)
            if (node.scale[axis] == 0) {
                diagnostics_.error(placeOf(*table.get("scale")), "scale must not be zero");
                node.scale = glm::vec3(1);
            }
        relocate(nodeOptions(), node);
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

    /// Names of files that stand in an included one become relative to the scene's folder.
    template <class T>
    void relocate(const OptionTable<T>& options, T& object) {
        for (const Option<T>& option : options) {
            Reference* file = nullptr;
            if (const auto* m = std::get_if<FileMember<T>>(&option.member))
                file = &(object.*m->member);
            if (const auto* m = std::get_if<TextureMember<T>>(&option.member))
                file = &(object.*m->member).file;
            if (file != nullptr && !file->empty())
                file->name = files_.fromSceneFolder(file->name, file->where);
        }
    }

    Scene& scene_;
    const std::vector<std::string>& overrides_;
    const IncludedFiles& files_;
    Diagnostics& diagnostics_;
    std::vector<AnimationTrack> ways_;  ///< of cameras
};

}  // namespace

Scene parseScene(std::string_view text, const std::string& file,
                 const std::vector<std::string>& overrides, Diagnostics& diagnostics) {
    Scene scene;
    scene.file = file;
    scene.folder = std::filesystem::path(file).parent_path();
    IncludedFiles files(scene.folder);
    Diagnostics found;
    std::optional<toml::table> document = files.load(text, file, found);
    if (document) {
        for (const std::string& assignment : overrides) {
            if (namesImported(*document, assignment))
                scene.importOverrides.push_back(assignment);
            else
                applyOverride(*document, assignment, found);
        }
        SceneParser(scene, overrides, files, found).parse(*document);
    }
    // The document gives its keys by the alphabet; people read errors from the top of the file.
    std::vector<Diagnostic> sorted = found.list();
    const auto place = [&](const Diagnostic& d) {
        return std::tuple(files.rank(d.where.file), d.where.line, d.where.column);
    };
    std::stable_sort(sorted.begin(), sorted.end(),
                     [&](const Diagnostic& a, const Diagnostic& b) { return place(a) < place(b); });
    for (Diagnostic& diagnostic : sorted) {
        diagnostic.message = printable(diagnostic.message);
        diagnostics.add(std::move(diagnostic));
    }
    if (!document) return scene;
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
