// SPDX-License-Identifier: MIT
#include "app/viewer/panel.hpp"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include "app/viewer/controls.hpp"

namespace vitrine {
namespace {

bool header(const char* label, const Controls& controls) {
    if (controls.searching()) ImGui::SetNextItemOpen(true);
    return ImGui::CollapsingHeader(label);
}

/// One object of a list. Returns true if its rows are to be drawn; then TreePop() must follow.
bool object(const std::string& label, const Controls& controls) {
    if (controls.searching()) ImGui::SetNextItemOpen(true);
    return ImGui::TreeNodeEx(label.c_str(), ImGuiTreeNodeFlags_SpanAvailWidth);
}

int indexOfShape(const Scene& scene, const std::string& name) {
    for (size_t i = 0; i < scene.shapes.size(); ++i)
        if (scene.shapes[i].name == name) return static_cast<int>(i);
    return -1;
}

/// The snippet of the node's shape, or nullptr.
const Snippet* fieldOf(const Scene& scene, const Assets& assets, const Node& node) {
    const int shape = indexOfShape(scene, node.shape.name);
    if (shape < 0) return nullptr;
    const auto& field = assets.fields[static_cast<size_t>(shape)];
    return field ? &*field : nullptr;
}

void nodeRows(const Scene& scene, const Assets& assets, const Node& node, Controls& controls) {
    const std::string path = "node." + node.name;
    controls.options(path, nodeOptions(), node);
    if (const Snippet* field = fieldOf(scene, assets, node))
        controls.parameters(path, *field, node.set);
}

/// A search leaves only what it finds.
bool nodeFound(const Scene& scene, const Assets& assets, const Node& node,
               const Controls& controls) {
    const std::string path = "node." + node.name;
    const Snippet* field = fieldOf(scene, assets, node);
    return controls.finds(path, nodeOptions()) ||
           (field != nullptr && controls.finds(path, *field));
}

bool materialFound(const Scene& scene, const Assets& assets, size_t i, const Controls& controls) {
    const std::string path = "material." + scene.materials[i].name;
    const auto& snippet = assets.materials[i];
    return controls.finds(path, materialOptions()) || (snippet && controls.finds(path, *snippet));
}

void materialRows(const Scene& scene, const Assets& assets, size_t i, Controls& controls) {
    const Material& material = scene.materials[i];
    const std::string path = "material." + material.name;
    if (const auto& snippet = assets.materials[i])
        controls.parameters(path, *snippet, material.set);
    controls.options(path, materialOptions(), material);
}

void selectionRows(const Scene& scene, const Assets& assets, const Node& node, Controls& controls) {
    nodeRows(scene, assets, node, controls);
    for (size_t i = 0; i < scene.materials.size(); ++i) {
        const std::string& name = scene.materials[i].name;
        bool used = node.material.name == name;
        for (const auto& part : node.parts) used = used || part.second.name == name;
        if (used && object("material " + name, controls)) {
            materialRows(scene, assets, i, controls);
            ImGui::TreePop();
        }
    }
}

template <class T>
void listRows(const char* section, const std::vector<T>& list, const OptionTable<T>& table,
              Controls& controls) {
    for (const T& entry : list) {
        const std::string path = fmt::format("{}.{}", section, entry.name);
        if (entry.name.empty() || !controls.finds(path, table)) continue;
        if (!object(entry.name, controls)) continue;
        controls.options(path, table, entry);
        ImGui::TreePop();
    }
}

void orbitRows(const std::vector<Camera>& cameras, Controls& controls) {
    for (const Camera& camera : cameras) {
        const std::string path = fmt::format("camera.{}.orbit", camera.name);
        if (!camera.orbit || camera.name.empty() || !controls.finds(path, orbitOptions())) continue;
        if (!object(camera.name + ": orbit", controls)) continue;
        controls.options(path, orbitOptions(), *camera.orbit);
        ImGui::TreePop();
    }
}

}  // namespace

void Panel::draw(const Scene& scene, const Assets& assets, Edits& edits, Selection& selection) {
    ImGui::SetNextItemWidth(-1);
    ImGui::InputTextWithHint("##search", "search all settings", &filter_);
    Controls controls(edits, filter_);
    // A search finds settings, whatever they belong to.
    if (!controls.searching()) {
        ImGui::SetNextItemOpen(true, ImGuiCond_Once);
        if (header("Objects", controls)) tree_.draw(scene, edits, selection);
    }
    const bool selected =
        selection.node >= 0 && static_cast<size_t>(selection.node) < scene.nodes.size();
    if (selected) {
        const Node& node = scene.nodes[static_cast<size_t>(selection.node)];
        if (selection.justMade) ImGui::SetNextItemOpen(true);
        if (ImGui::CollapsingHeader(fmt::format("Selected: {}###selected", node.name).c_str()))
            selectionRows(scene, assets, node, controls);
    }
    selection.justMade = false;
    if (header("Picture", controls)) controls.options("render", renderOptions(), scene.render);
    if (header("Surroundings", controls))
        controls.options("environment", environmentOptions(), scene.environment);
    if (header("Lights", controls)) listRows("light", scene.lights, lightOptions(), controls);
    if (header("Cameras", controls)) {
        listRows("camera", scene.cameras, cameraOptions(), controls);
        orbitRows(scene.cameras, controls);
    }
    if (header("Materials", controls))
        for (size_t i = 0; i < scene.materials.size(); ++i)
            if (materialFound(scene, assets, i, controls) &&
                object(scene.materials[i].name, controls)) {
                materialRows(scene, assets, i, controls);
                ImGui::TreePop();
            }
    if (controls.searching() && header("Objects", controls))
        for (size_t i = 0; i < scene.nodes.size(); ++i) {
            const Node& node = scene.nodes[i];
            if (node.name.empty() || !nodeFound(scene, assets, node, controls)) continue;
            if (!object(node.name, controls)) continue;
            if (ImGui::SmallButton("select")) selection = {static_cast<int>(i), true};
            nodeRows(scene, assets, node, controls);
            ImGui::TreePop();
        }
}

}  // namespace vitrine
