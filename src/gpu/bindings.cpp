// SPDX-License-Identifier: MIT
#include "gpu/bindings.hpp"

#include <epoxy/gl.h>

namespace vitrine {
namespace {

template <typename Resource>
void bindEach(const Program& program, const Named<Resource>& resources, GLenum target) {
    for (const auto& [name, resource] : resources) {
        const int unit = program.unit(name);
        if (unit < 0) continue;
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
        glBindTexture(target, resource->id());
    }
    glActiveTexture(GL_TEXTURE0);
}

}  // namespace

void useProgram(const Program& program, const UniformBlock& block) {
    glUseProgram(program.id());
    glBindBufferBase(GL_UNIFORM_BUFFER, kFrameBlockBinding, block.id());
}

void bindInputs(const Program& program, const Named<Texture>& textures) {
    bindEach(program, textures, GL_TEXTURE_2D);
}
void bindInputs(const Program& program, const Named<TexelBuffer>& buffers) {
    bindEach(program, buffers, GL_TEXTURE_BUFFER);
}
void bindInputs(const Program& program, const Named<TextureArray>& arrays) {
    bindEach(program, arrays, GL_TEXTURE_2D_ARRAY);
}
void bindInputs(const Program& program, const Named<MipTexture>& pictures) {
    bindEach(program, pictures, GL_TEXTURE_2D);
}

}  // namespace vitrine
