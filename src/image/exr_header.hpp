// SPDX-License-Identifier: MIT
// The header of an EXR file, read without OpenEXR: the library asks for memory by what a header
// says, so what it says is looked at first.
// Source: "OpenEXR File Layout", openexr.com (2021).
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace vitrine {

/// Inclusive, as in the file.
struct ExrWindow {
    int xMin = 0, yMin = 0, xMax = -1, yMax = -1;
    [[nodiscard]] int64_t width() const { return int64_t{xMax} - xMin + 1; }
    [[nodiscard]] int64_t height() const { return int64_t{yMax} - yMin + 1; }
};

struct ExrHeaderChannel {
    std::string name;
    int xSampling = 1, ySampling = 1;
};

struct ExrHeader {
    ExrWindow dataWindow, displayWindow;
    std::vector<ExrHeaderChannel> channels;
};

/// The header of the first part, after the headers of all parts have been held against our limits
/// and the length of the file. Throws InputError, placed at `file` and a byte in it.
ExrHeader readExrHeader(std::span<const uint8_t> bytes, const std::string& file);

}  // namespace vitrine
