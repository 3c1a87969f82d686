// SPDX-License-Identifier: MIT
// "--frames 0-99:2", "-r 1280x720" and "name_####.png".
#pragma once

#include <string>
#include <utility>

namespace vitrine {

struct FrameRange {
    int first = 0, last = 0, step = 1;
};

/// "A", "A-B" or "A-B:STEP", A <= B, STEP >= 1. Throws UsageError.
FrameRange parseFrames(const std::string& text);

/// Width and height. Throws UsageError.
std::pair<int, int> parseResolution(const std::string& text);

/// The run of '#' replaced by the frame's number with as many digits. Throws UsageError if there
/// is none.
std::string frameFileName(const std::string& pattern, int frame);

}  // namespace vitrine
