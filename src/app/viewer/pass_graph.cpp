// SPDX-License-Identifier: MIT
#include "app/viewer/pass_graph.hpp"

#include <imgui.h>

#include <algorithm>
#include <set>

namespace vitrine {
namespace {

constexpr float kBarWidth = 3, kHeight = 80;  // ImGui units

double total(const PassSeconds& sample) {
    double sum = 0;
    for (const auto& [pass, seconds] : sample) sum += seconds;
    return sum;
}

/// Neighbours differ: steps of the golden ratio around the circle of hues.
ImU32 colorOf(size_t pass) {
    const float hue = glm::fract(0.08f + 0.618034f * static_cast<float>(pass));
    return ImColor::HSV(hue, 0.6f, 0.95f);
}

}  // namespace

PassSeconds difference(const PassSeconds& sums, const PassSeconds& before) {
    PassSeconds result = sums;
    for (const auto& [pass, seconds] : before) result[pass] -= seconds;
    return result;
}

void PassGraph::add(PassSeconds sample) {
    samples_.push_back(std::move(sample));
    if (samples_.size() > kMostSamples) samples_.pop_front();
}

void PassGraph::draw() const {
    ImGui::SetNextWindowPos({8, 30});
    ImGui::SetNextWindowBgAlpha(0.8f);
    ImGui::Begin("Passes", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                     ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoFocusOnAppearing |
                     ImGuiWindowFlags_NoNav);
    std::set<std::string> passes;
    double highest = 0;
    for (const PassSeconds& sample : samples_) {
        highest = std::max(highest, total(sample));
        for (const auto& [pass, seconds] : sample) passes.insert(pass);
    }
    ImGui::Text("ms a sample by pass; the highest stack: %.1f", 1000 * highest);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::Dummy({kBarWidth * kMostSamples, kHeight});
    const float scale = highest > 0 ? kHeight / static_cast<float>(highest) : 0;
    float x = corner.x + kBarWidth * static_cast<float>(kMostSamples - samples_.size());
    for (const PassSeconds& sample : samples_) {
        float y = corner.y + kHeight;
        size_t number = 0;
        for (const std::string& pass : passes) {
            const auto found = sample.find(pass);
            const float size =
                found == sample.end() ? 0 : scale * static_cast<float>(found->second);
            ImGui::GetWindowDrawList()->AddRectFilled({x, y - size}, {x + kBarWidth, y},
                                                      colorOf(number++));
            y -= size;
        }
        x += kBarWidth;
    }
    size_t number = 0;
    for (const std::string& pass : passes) {
        const auto found = samples_.back().find(pass);
        const double seconds = found == samples_.back().end() ? 0 : found->second;
        ImGui::TextColored(ImColor(colorOf(number++)), "%8.2f  %s", 1000 * seconds, pass.c_str());
    }
    ImGui::End();
}

}  // namespace vitrine
