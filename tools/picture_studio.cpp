// SPDX-License-Identifier: MIT
#include "picture_studio.hpp"

#include <fmt/format.h>

namespace vitrine {

std::string pictureStudio(const std::string& name, const std::string& camera,
                          const std::string& material, double floor) {
    return fmt::format(R"([render]
bounces = 0
ao = 1.2
[[camera]]
{1}
[environment]
zenith = [0.75, 0.80, 0.88]
horizon = [0.80, 0.82, 0.85]
ground = [0.55, 0.54, 0.52]
intensity = 0.8
[[light]]
type = "sun"
direction = [-0.75, -1.2, -0.55]
color = [1.0, 0.95, 0.86]
intensity = 2.6
[material.shape]
{2}
[material.floor]
base_color = "#e9e6df"
roughness = 0.9
[shape.shape]
sdf = "{0}.sdf.glsl"
[shape.floor]
plane = {{ size = [60, 0, 60] }}
[[node]]
shape = "shape"
material = "shape"
[[node]]
shape = "floor"
material = "floor"
at = [0, {3:.1f}, 0]
)",
                       name, camera, material, floor);
}

}  // namespace vitrine
