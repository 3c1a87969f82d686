// SPDX-License-Identifier: MIT
// What lies over the picture: mistakes in the scene's files, a passing message, the timeline.
#pragma once

#include <string>

#include "app/viewer/inspect.hpp"
#include "app/viewer/timeline.hpp"
#include "base/error.hpp"
#include "base/math.hpp"

namespace vitrine {

/// Each mistake with its place and the line of the file that it is in, and what becomes of them.
void drawProblems(const Diagnostics& problems, const char* outlook, glm::vec2 pictureSize);
/// In the lower left corner.
void drawFacts(const Facts& facts, glm::vec2 pictureSize);
void drawMessage(const std::string& text, glm::vec2 pictureSize);
/// What is being done meanwhile, in the lower right corner.
void drawProgress(const std::string& text, glm::vec2 pictureSize);

/// What a hand has done to the timeline.
struct TimelineTouch {
    bool played = false;  ///< it is to play, or to stand if it plays
    bool moved = false;   ///< its time is another one
    bool record = false;  ///< a film is wanted
};
TimelineTouch drawTimeline(Timeline& timeline, glm::vec2 pictureSize);

/// Line `line`, from 1, of a file; empty if there is none.
std::string sourceLine(const std::string& file, int line);

}  // namespace vitrine
