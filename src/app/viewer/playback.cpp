// SPDX-License-Identifier: MIT
#include "app/viewer/playback.hpp"

#include <algorithm>

#include "app/viewer/overlay.hpp"

namespace vitrine {
namespace {

constexpr float kFrame = 1.0f / 30;  // s

}  // namespace

void Playback::addCommands(std::vector<Command>& list) {
    Timeline& timeline = view_.timeline;
    if (timeline.duration <= 0) return;
    list.push_back({"Time", "Play", "Space", ' ', false, false,
                    [this] { view_.play(!view_.timeline.playing); }, timeline.playing});
    list.push_back({"Time", "Loop", "L", 'L', false, false,
                    [&timeline] { timeline.loop = !timeline.loop; }, timeline.loop});
    list.push_back(
        {"Time", "A frame back", "Left", kKeyLeft, false, false, [this] { step(-kFrame); }});
    list.push_back(
        {"Time", "A frame on", "Right", kKeyRight, false, false, [this] { step(kFrame); }});
}

void Playback::draw(glm::vec2 pictureSize) {
    if (view_.timeline.duration <= 0) return;
    const TimelineTouch touch = drawTimeline(view_.timeline, pictureSize);
    if (touch.played) view_.play(!view_.timeline.playing);
    if (touch.moved) view_.showTime();
    if (touch.record) recorder_.ask();
}

void Playback::step(float seconds) {
    Timeline& timeline = view_.timeline;
    timeline.playing = false;
    timeline.time = std::clamp(timeline.time + seconds, 0.0f, timeline.duration);
    view_.showTime();
}

}  // namespace vitrine
