// SPDX-License-Identifier: MIT
#include "frame/tree_boxes.hpp"

#include <algorithm>

namespace vitrine {
namespace {

void append(std::vector<glm::uvec4>& texels, const std::vector<uint32_t>& numbers) {
    for (size_t i = 0; i < numbers.size(); i += 4) {
        glm::uvec4& texel = texels.emplace_back(0u);
        for (size_t k = 0; k < 4 && i + k < numbers.size(); ++k)
            texel[static_cast<int>(k)] = numbers[i + k];
    }
}

}  // namespace

void TreeBoxes::upload(const TreeLevel& level) {
    std::vector<glm::vec4> corners;
    corners.reserve(2 * level.boxes.size());
    const auto isLonely = [](const TreeBox& box) { return box.lonely; };
    const auto lonely = std::count_if(level.boxes.begin(), level.boxes.end(), isLonely);
    const float step = 1 / static_cast<float>(level.boxes.size() - static_cast<size_t>(lonely));
    float hue = 0.5f * step;
    for (const TreeBox& box : level.boxes) {
        corners.emplace_back(box.box.min, static_cast<float>(box.instance));
        // The whole circle, in the order of the trees. What has no tree worth the name, such as
        // the ground, stays grey.
        corners.emplace_back(box.box.max, box.lonely ? -1.0f : hue);
        if (!box.lonely) hue += step;
    }
    std::vector<glm::uvec4> numbers;
    append(numbers, level.firstBox);
    firstTriangleTexel_ = static_cast<int>(numbers.size());
    append(numbers, level.boxOfTriangle);
    count_ = static_cast<int>(level.boxes.size());
    corners_.upload(std::as_bytes(std::span(corners)));
    numbers_.upload(std::as_bytes(std::span(numbers)));
}

}  // namespace vitrine
