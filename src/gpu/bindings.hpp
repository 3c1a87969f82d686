// SPDX-License-Identifier: MIT
// What a pass reads, bound to the units of a program.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "gpu/mip_texture.hpp"
#include "gpu/program.hpp"
#include "gpu/texture.hpp"

namespace vitrine {

template <typename Resource>
using Named = std::vector<std::pair<std::string, const Resource*>>;

/// Makes the program and its uniform block current. Names that it does not use are ignored: a
/// variant may need less.
void useProgram(const Program& program, const UniformBlock& block);
void bindInputs(const Program& program, const Named<Texture>& textures);
void bindInputs(const Program& program, const Named<TexelBuffer>& buffers);
void bindInputs(const Program& program, const Named<TextureArray>& arrays);
void bindInputs(const Program& program, const Named<MipTexture>& pictures);

}  // namespace vitrine
