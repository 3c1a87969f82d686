// SPDX-License-Identifier: MIT
// The subcommands. Each gets its parsed options, writes to standard output, and throws what
// base/error.hpp names; main.cpp makes exit codes of that.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/session/session.hpp"

namespace vitrine {

struct RenderOptions {
    std::string file, output, resolution = "1280x720", frames, camera, view = "color";
    std::string backend = "auto", primary = "raster", mode = "hybrid", json;
    std::optional<int> samples, seed;
    float time = 0, fps = 24;
    std::vector<std::string> overrides;
    std::string version;
};
/// Draws a picture, or one a frame.
int render(const RenderOptions& options);

struct CheckOptions {
    std::string file, json;
    std::string output;  ///< a picture of the file's field cut through
    std::vector<std::string> overrides;
};
/// Prints all that is wrong. 0: nothing; 1: errors.
int check(const CheckOptions& options);

struct InfoOptions {
    std::string file, json;
    bool builders = false;    ///< build each mesh's tree in all ways, to compare them
    std::string exportBoxes;  ///< write the boxes of a level of the trees to this .obj
    int level = 0;
    std::vector<std::string> overrides;
};
/// Prints what is in a scene.
int info(const InfoOptions& options);

struct CompareOptions {
    std::string a, b, output, json;
    std::optional<double> tolerance;  ///< in steps of 1/255
    double fraction = 0.001;
};
/// Prints how two pictures differ. With a tolerance, 1 if more than `fraction` of the pixels
/// differ by more.
int compare(const CompareOptions& options);

/// Writes to a file, or to standard output for "-".
void writeJson(const std::string& file, const std::string& text);

}  // namespace vitrine
