// SPDX-License-Identifier: MIT
#include "app/cli/frames.hpp"

#include <fmt/format.h>

#include <charconv>
#include <string_view>

#include "base/error.hpp"

namespace vitrine {
namespace {

/// Takes digits from the front of `text`; -1 if there are none.
int takeNumber(std::string_view& text) {
    int value = -1;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || value < 0) return -1;
    text.remove_prefix(static_cast<size_t>(end - text.data()));
    return value;
}

bool takeSign(std::string_view& text, char sign) {
    if (text.empty() || text[0] != sign) return false;
    text.remove_prefix(1);
    return true;
}

}  // namespace

FrameRange parseFrames(const std::string& text) {
    constexpr int kMaxFrame = 9'999'999;  // more than a day of film
    std::string_view rest = text;
    FrameRange range;
    range.first = range.last = takeNumber(rest);
    if (takeSign(rest, '-')) range.last = takeNumber(rest);
    if (takeSign(rest, ':')) range.step = takeNumber(rest);
    if (!rest.empty() || range.first < 0 || range.last < range.first || range.last > kMaxFrame ||
        range.step < 1)
        throw UsageError(fmt::format("--frames: '{}' is not A-B or A-B:STEP with A <= B <= {}",
                                     text, kMaxFrame));
    return range;
}

std::pair<int, int> parseResolution(const std::string& text) {
    constexpr int kMaxSide = 16384;
    std::string_view rest = text;
    const int width = takeNumber(rest);
    const bool cross = takeSign(rest, 'x');
    const int height = takeNumber(rest);
    if (!cross || !rest.empty() || width < 1 || height < 1 || width > kMaxSide || height > kMaxSide)
        throw UsageError(
            fmt::format("-r: '{}' is not WIDTHxHEIGHT, each from 1 to {}", text, kMaxSide));
    return {width, height};
}

std::string frameFileName(const std::string& pattern, int frame) {
    const size_t first = pattern.find('#');
    if (first == std::string::npos)
        throw UsageError(fmt::format("-o: '{}' needs #### where the frame's number goes", pattern));
    size_t end = first;
    while (end < pattern.size() && pattern[end] == '#') ++end;
    return pattern.substr(0, first) + fmt::format("{:0{}}", frame, end - first) +
           pattern.substr(end);
}

}  // namespace vitrine
