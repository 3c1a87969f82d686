// SPDX-License-Identifier: MIT
#include "frame/pass_context.hpp"

#include <algorithm>
#include <utility>

namespace vitrine {

void PathImages::allocate(int width, int height) {
    records = Texture(width, height, TexelFormat::kRgba32ui);
    origin = Texture(width, height, TexelFormat::kRgba32f);
    direction = Texture(width, height, TexelFormat::kRgba32f);
    throughput = Texture(width, height, TexelFormat::kRgba32f);
}

void PassContext::run(const std::string& pass, PassImages images) {
    const Program& program = programs.get(pass);
    images.buffers = scene.bindings();
    const auto& shaders = passShaders();
    const bool counts =
        counting && std::any_of(shaders.begin(), shaders.end(),
                                [&](const PassShader& s) { return s.name == pass && s.traces; });
    if (counts) {
        images.inputs.emplace_back("countersBefore", &counters[0]);
        images.outputs.emplace_back("outCounters", &counters[1]);
    }
    uniforms_.upload(std::as_bytes(std::span(&block, 1)));
    if (timing) timer_.begin(pass);
    runner_.run(program, uniforms_, images);
    if (timing) timer_.end();
    if (counts) std::swap(counters[0], counters[1]);
}

}  // namespace vitrine
