// SPDX-License-Identifier: MIT
#include "app/viewer/controls.hpp"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>

namespace vitrine {
namespace {

/// Wider ranges than this are for dragging: a slider would have no fine places.
constexpr double kWidestSlider = 1000;

std::string lower(std::string_view text) {
    std::string result(text);
    std::transform(result.begin(), result.end(), result.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return result;
}

bool isSlider(Range range) {
    return range.maximum - range.minimum <= kWidestSlider;
}

std::string listText(const float* values, int count) {
    std::string text = "[";
    for (int i = 0; i < count; ++i) text += fmt::format("{}{}", i > 0 ? ", " : "", values[i]);
    return text + "]";
}

float dragSpeed(float value) {
    return std::max(std::abs(value), 0.1f) * 0.01f;
}

}  // namespace

bool Controls::matches(std::string_view path, std::string_view key, std::string_view help) const {
    if (filter_.empty()) return true;
    const std::string wanted = lower(filter_);
    for (const std::string_view text : {path, key, help})
        if (lower(text).find(wanted) != std::string::npos) return true;
    return false;
}

bool Controls::finds(const std::string& path, const Snippet& snippet) const {
    return std::any_of(snippet.parameters.begin(), snippet.parameters.end(),
                       [&](const Parameter& p) { return matches(path, p.name, p.label); });
}

void Controls::begin(const std::string& key, const std::string& label, const std::string& help) {
    ImGui::PushID(key.c_str());
    const bool changed = edits_.has(key);
    ImGui::AlignTextToFramePadding();
    if (changed) ImGui::PushStyleColor(ImGuiCol_Text, ImVec4(1.0f, 0.78f, 0.36f, 1));
    ImGui::TextUnformatted(label.c_str());
    if (changed) ImGui::PopStyleColor();
    if (ImGui::IsItemHovered()) {
        ImGui::BeginTooltip();
        ImGui::PushTextWrapPos(ImGui::GetFontSize() * 24);
        ImGui::TextUnformatted(help.c_str());
        ImGui::TextDisabled("--set %s%s", key.c_str(), changed ? "   (changed)" : "");
        ImGui::PopTextWrapPos();
        ImGui::EndTooltip();
    }
    ImGui::SameLine(ImGui::GetWindowWidth() * 0.48f);
    // There is always room for the button, so that nothing moves under the mouse.
    ImGui::SetNextItemWidth(-ImGui::GetFrameHeight() - ImGui::GetStyle().ItemInnerSpacing.x);
}

void Controls::end(const std::string& key) {
    if (edits_.has(key)) {
        ImGui::SameLine(ImGui::GetContentRegionMax().x - ImGui::GetFrameHeight());
        if (ImGui::Button("x", {ImGui::GetFrameHeight(), 0})) edits_.reset(key);
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("back to what the file says");
    }
    ImGui::PopID();
}

void Controls::send(const std::string& key, const std::string& value) {
    // A drag is one gesture, also its last step, which comes when the mouse is up already: what the
    // same click changes of the same item.
    static int gesture = 0;
    static double clicked = -1;
    static std::string last;
    const double click = ImGui::GetIO().MouseClickedTime[0];
    if (click != clicked || key != last) gesture = edits_.newGesture();
    clicked = click;
    last = key;
    edits_.set(key, value, gesture);
}

void Controls::number(const std::string& key, Range range, float value) {
    const auto low = static_cast<float>(range.minimum), high = static_cast<float>(range.maximum);
    const ImGuiSliderFlags flags = ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoRoundToFormat;
    const bool changed =
        isSlider(range)
            ? ImGui::SliderFloat("##value", &value, low, high, "%.4g", flags)
            : ImGui::DragFloat("##value", &value, dragSpeed(value), low, high, "%.4g", flags);
    if (changed) send(key, fmt::format("{}", value));
}

void Controls::number(const std::string& key, Range range, int value) {
    const int low = static_cast<int>(range.minimum), high = static_cast<int>(range.maximum);
    const bool changed =
        isSlider(range)
            ? ImGui::SliderInt("##value", &value, low, high, "%d", ImGuiSliderFlags_AlwaysClamp)
            : ImGui::DragInt("##value", &value, 1, low, high, "%d", ImGuiSliderFlags_AlwaysClamp);
    if (changed) send(key, fmt::format("{}", value));
}

void Controls::vector(const std::string& key, Range range, const float* values, int count) {
    std::array<float, 4> v{};
    std::copy(values, values + count, v.begin());
    float size = 0.5f;
    for (int i = 0; i < count; ++i) size = std::max(size, std::abs(v[static_cast<size_t>(i)]));
    if (ImGui::DragScalarN("##value", ImGuiDataType_Float, v.data(), count, dragSpeed(size),
                           nullptr, nullptr, "%.3g")) {
        for (float& x : v)
            x = std::clamp(x, static_cast<float>(range.minimum), static_cast<float>(range.maximum));
        send(key, listText(v.data(), count));
    }
}

void Controls::color(const std::string& key, glm::vec3 value, bool bright) {
    const ImGuiColorEditFlags flags =
        ImGuiColorEditFlags_Float | (bright ? ImGuiColorEditFlags_HDR : 0);
    if (ImGui::ColorEdit3("##value", &value.x, flags)) send(key, listText(&value.x, 3));
}

void Controls::flag(const std::string& key, bool value) {
    if (ImGui::Checkbox("##value", &value)) send(key, value ? "true" : "false");
}

void Controls::choice(const std::string& key, const std::vector<std::string>& words, int value) {
    if (!ImGui::BeginCombo("##value", words[static_cast<size_t>(value)].c_str())) return;
    for (size_t i = 0; i < words.size(); ++i)
        if (ImGui::Selectable(words[i].c_str(), static_cast<int>(i) == value))
            send(key, '"' + words[i] + '"');
    ImGui::EndCombo();
}

void Controls::text(const std::string& key, const std::string& value) {
    // Names and files: shown, and changed in the scene's file, where they can be checked.
    ImGui::TextDisabled("%s", value.empty() ? "-" : value.c_str());
    (void)key;
}

void Controls::parameters(const std::string& path, const Snippet& snippet,
                          const std::vector<ParameterValue>& given) {
    std::string group;
    for (const Parameter& p : snippet.parameters) {
        if (!matches(path, p.name, p.label)) continue;
        if (p.group != group) {
            group = p.group;
            if (!group.empty()) ImGui::TextDisabled("%s", group.c_str());
        }
        glm::vec4 value = p.defaultValue;
        for (const ParameterValue& g : given)
            if (g.name == p.name) value = g.value;
        const std::string key = fmt::format("{}.set.{}", path, p.name);
        begin(key, p.name, p.label);
        const Range range{p.minimum.x, p.maximum.x};
        switch (p.type) {
            case ParameterType::kFloat:
                number(key, range, value.x);
                break;
            case ParameterType::kInt:
                number(key, range, static_cast<int>(value.x));
                break;
            case ParameterType::kBool:
                flag(key, value.x != 0);
                break;
            case ParameterType::kColor:
                color(key, glm::vec3(value), p.maximum.x > 1);
                break;
            default:
                vector(key, {}, &value.x, componentCount(p.type));
        }
        end(key);
    }
}

}  // namespace vitrine
