// SPDX-License-Identifier: MIT
#include "app/viewer/notices.hpp"

#include "app/viewer/overlay.hpp"

namespace vitrine {
namespace {

constexpr std::chrono::seconds kMessageTime{4}, kRefusalTime{10};

}  // namespace

void Notices::say(std::string text) {
    message_ = std::move(text);
    messageAt_ = Clock::now();
    window_.wake();
}

void Notices::refuse(Diagnostics why) {
    refusal_ = std::move(why);
    refusedAt_ = Clock::now();
    window_.wake();
}

void Notices::draw(const Diagnostics& problems, glm::vec2 pictureSize) {
    if (problems.hasErrors())
        drawProblems(problems, "The last good picture stays until the file is mended.",
                     pictureSize);
    else if (refusal_.hasErrors())
        drawProblems(refusal_, "The scene stays as it is.", pictureSize);
    if (!message_.empty()) drawMessage(message_, pictureSize);
    const Clock::time_point now = Clock::now();
    if (refusal_.hasErrors() && now - refusedAt_ > kRefusalTime) {
        refusal_ = {};
        window_.wake();
    }
    if (!message_.empty() && now - messageAt_ > kMessageTime) {
        message_.clear();
        window_.wake();
    }
}

}  // namespace vitrine
