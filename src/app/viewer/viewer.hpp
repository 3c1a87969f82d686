// SPDX-License-Identifier: MIT
// The window: `vitrine view FILE`.
#pragma once

#include <string>
#include <vector>

#include "gpu/no_display.hpp"

namespace vitrine {

struct ViewOptions {
    std::string file;
    std::string camera;
    std::vector<std::string> overrides;
    std::string scenes;      ///< the folder of the scenes that come with the program
    std::string version;     ///< the program's
    bool startPage = false;  ///< `file` was not chosen by anybody: begin with the start screen
    int width = 1280, height = 800;
    std::string timings;  ///< how long the window took to answer goes to this file, "-": printed
};

/// Opens a window on a scene and stays until it is closed. Throws NoDisplay if
/// there is none to open it on. Returns the exit code.
int view(const ViewOptions& options);

}  // namespace vitrine
