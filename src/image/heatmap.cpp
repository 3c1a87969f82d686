// SPDX-License-Identifier: MIT
// Magma is the colour map by Nathaniel Smith and Stefan van der Walt (matplotlib, CC0), here as the
// sixth-degree fit by Matt Zucker (Shadertoy WlfXRN, CC0). Heat interpolates colours of our own.
#include "image/heatmap.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace vitrine {

glm::vec3 magma(float t) {
    static constexpr std::array<glm::vec3, 7> kCoefficients{{
        {-0.002136485f, -0.000749655f, -0.005386128f},
        {0.251660541f, 0.677523244f, 2.494026599f},
        {8.353717279f, -3.577719515f, 0.314467903f},
        {-27.668733087f, 14.264730781f, -13.649213188f},
        {52.176139812f, -27.943606072f, 12.944169442f},
        {-50.768525365f, 29.046582821f, 4.234152994f},
        {18.655705066f, -11.489773520f, -5.601961509f},
    }};
    t = glm::clamp(t, 0.0f, 1.0f);
    glm::vec3 color{0.0f};
    for (size_t i = kCoefficients.size(); i-- > 0;) color = color * t + kCoefficients[i];
    return glm::clamp(color, 0.0f, 1.0f);
}

glm::vec3 heat(float t) {
    static constexpr std::array<glm::vec3, 7> kColors{{
        {0.05f, 0.03f, 0.25f},
        {0.10f, 0.25f, 0.85f},
        {0.05f, 0.70f, 0.85f},
        {0.20f, 0.80f, 0.30f},
        {0.95f, 0.85f, 0.15f},
        {0.95f, 0.40f, 0.10f},
        {0.60f, 0.05f, 0.05f},
    }};
    const float position = glm::clamp(t, 0.0f, 1.0f) * static_cast<float>(kColors.size() - 1);
    const size_t below = std::min(static_cast<size_t>(position), kColors.size() - 2);
    return glm::mix(kColors[below], kColors[below + 1], position - static_cast<float>(below));
}

ImageRgba8 colorize(const ImageMap& map, glm::vec3 (*scale)(float)) {
    ImageRgba8 image(map.width, map.height);
    for (size_t i = 0; i < map.pixels.size(); ++i) {
        const float value = map.pixels[i];
        const glm::vec3 color = std::isnan(value) ? glm::vec3(1.0f, 0.0f, 1.0f) : scale(value);
        for (int channel = 0; channel < 3; ++channel)
            image.pixels[4 * i + channel] = static_cast<uint8_t>(color[channel] * 255.0f + 0.5f);
        image.pixels[4 * i + 3] = 255;
    }
    return image;
}

}  // namespace vitrine
