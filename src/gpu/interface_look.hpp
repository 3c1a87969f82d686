// SPDX-License-Identifier: MIT
// What menus and panels look like: letters, colours, corners.
#pragma once

#include <span>

struct ImFont;

namespace vitrine {

/// Gives ImGui its fonts and its style, once, for a display of so many pixels a point.
void chooseInterfaceLook(float scale);
/// For ImGui::PushFont(): large letters, and letters that are all equally wide.
ImFont* headingFont();
ImFont* sourceFont();

/// A TrueType file; empty if there was none where this was built.
std::span<const unsigned char> interfaceFontFile();

}  // namespace vitrine
