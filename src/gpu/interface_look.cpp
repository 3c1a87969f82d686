// SPDX-License-Identifier: MIT
#include "gpu/interface_look.hpp"

#include <imgui.h>

#include <cmath>

namespace vitrine {
namespace {

constexpr float kTextPixels = 16, kHeadingPixels = 30, kSourcePixels = 13;

ImFont *heading = nullptr, *source = nullptr;  // ImGui has one context, too

/// Names in scenes and folders are written in more than English.
const ImVector<ImWchar>& letters(ImFontAtlas& atlas) {
    static constexpr ImWchar kLatinGreekAndSigns[] = {0x100,  0x17f,  0x370, 0x3ff,
                                                      0x2010, 0x2026, 0};
    static ImVector<ImWchar> ranges;  // the atlas looks at it later
    if (!ranges.empty()) return ranges;
    ImFontGlyphRangesBuilder builder;
    builder.AddRanges(atlas.GetGlyphRangesCyrillic());
    builder.AddRanges(kLatinGreekAndSigns);
    builder.BuildRanges(&ranges);
    return ranges;
}

ImFont* addFont(float pixels, ImFontConfig config) {
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    const std::span<const unsigned char> file = interfaceFontFile();
    config.SizePixels = std::round(pixels);
    if (file.empty()) return atlas.AddFontDefault(&config);
    config.FontDataOwnedByAtlas = false;  // and so it is only read
    return atlas.AddFontFromMemoryTTF(const_cast<unsigned char*>(file.data()),
                                      static_cast<int>(file.size()), config.SizePixels, &config,
                                      letters(atlas).Data);
}

/// The first is that of all text.
void addFonts(float scale) {
    addFont(kTextPixels * scale, {});
    heading = addFont(kHeadingPixels * scale, {});
    ImFontConfig config;
    config.SizePixels = std::round(kSourcePixels * scale);
    source = ImGui::GetIO().Fonts->AddFontDefault(&config);
}

/// Greys that leave the picture its colours, and amber for what is chosen or changed.
void chooseColors(ImGuiStyle& style) {
    const ImVec4 amber(0.90f, 0.62f, 0.18f, 1), paleAmber(1.0f, 0.78f, 0.36f, 1);
    const auto grey = [](float value, float alpha = 1) {
        return ImVec4(0.96f * value, 0.99f * value, 1.06f * value, alpha);
    };
    const auto set = [&](ImGuiCol item, const ImVec4& color) { style.Colors[item] = color; };
    set(ImGuiCol_Text, grey(0.90f));
    set(ImGuiCol_TextDisabled, grey(0.56f));
    set(ImGuiCol_TextSelectedBg, ImVec4(amber.x, amber.y, amber.z, 0.4f));
    set(ImGuiCol_WindowBg, grey(0.085f));
    set(ImGuiCol_PopupBg, grey(0.11f, 0.97f));
    set(ImGuiCol_MenuBarBg, grey(0.125f));
    set(ImGuiCol_TitleBg, grey(0.125f));
    set(ImGuiCol_TitleBgActive, grey(0.16f));
    set(ImGuiCol_ModalWindowDimBg, ImVec4(0, 0, 0, 0.45f));
    set(ImGuiCol_Border, grey(0.24f));
    set(ImGuiCol_Separator, grey(0.24f));
    set(ImGuiCol_FrameBg, grey(0.17f));
    set(ImGuiCol_FrameBgHovered, grey(0.23f));
    set(ImGuiCol_FrameBgActive, grey(0.28f));
    set(ImGuiCol_Button, grey(0.21f));
    set(ImGuiCol_ButtonHovered, grey(0.29f));
    set(ImGuiCol_ButtonActive, grey(0.36f));
    set(ImGuiCol_Header, grey(0.16f));
    set(ImGuiCol_HeaderHovered, grey(0.23f));
    set(ImGuiCol_HeaderActive, grey(0.28f));
    set(ImGuiCol_SliderGrab, ImVec4(0.66f, 0.45f, 0.13f, 1));
    set(ImGuiCol_SliderGrabActive, amber);
    set(ImGuiCol_CheckMark, amber);
    set(ImGuiCol_PlotHistogram, amber);
    set(ImGuiCol_NavHighlight, paleAmber);
    set(ImGuiCol_ScrollbarBg, grey(0.085f));
    set(ImGuiCol_ScrollbarGrab, grey(0.25f));
    set(ImGuiCol_ScrollbarGrabHovered, grey(0.32f));
    set(ImGuiCol_ScrollbarGrabActive, grey(0.38f));
}

}  // namespace

void chooseInterfaceLook(float scale) {
    addFonts(scale);
    ImGuiStyle& style = ImGui::GetStyle();
    chooseColors(style);
    style.FrameRounding = style.GrabRounding = 3;
    style.PopupRounding = 4;
    style.ScaleAllSizes(scale);
}

ImFont* headingFont() {
    return heading;
}

ImFont* sourceFont() {
    return source;
}

}  // namespace vitrine
