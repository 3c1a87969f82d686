// SPDX-License-Identifier: MIT
// For the tests of this folder only.
#pragma once

#include <string>
#include <vector>

#include "scene/parse.hpp"

namespace vitrine {

/// A scene that has to be good.
inline Scene goodScene(const std::string& text, const std::vector<std::string>& overrides = {}) {
    Diagnostics diagnostics;
    Scene scene = parseScene(text, "folder/t.toml", overrides, diagnostics);
    diagnostics.throwIfErrors();
    return scene;
}

/// All that is wrong with a scene, one message a line.
inline std::string problemsOf(const std::string& text,
                              const std::vector<std::string>& overrides = {}) {
    Diagnostics diagnostics;
    (void)parseScene(text, "t", overrides, diagnostics);
    return diagnostics.text();
}

}  // namespace vitrine
