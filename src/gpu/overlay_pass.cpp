// SPDX-License-Identifier: MIT
#include "gpu/overlay_pass.hpp"

#include <epoxy/gl.h>

#include <cassert>

#include "gpu/bindings.hpp"
#include "gpu/context.hpp"

namespace vitrine {

OverlayRunner::OverlayRunner() {
    glGenFramebuffers(1, &framebuffer_);
    glGenVertexArrays(1, &vertexArray_);
}

OverlayRunner::~OverlayRunner() {
    glDeleteFramebuffers(1, &framebuffer_);
    glDeleteVertexArrays(1, &vertexArray_);
}

void OverlayRunner::run(const Program& program, const UniformBlock& block, const PassImages& images,
                        int vertices) {
    assert(images.outputs.size() == 1);
    useProgram(program, block);
    bindInputs(program, images.inputs);
    bindInputs(program, images.buffers);

    const Texture& target = *images.outputs[0].second;
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target.id(), 0);
    const GLenum attachment = GL_COLOR_ATTACHMENT0;
    glDrawBuffers(1, &attachment);
    glViewport(0, 0, target.width(), target.height());
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glBindVertexArray(vertexArray_);
    glDrawArrays(GL_TRIANGLES, 0, vertices);
    glDisable(GL_BLEND);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, 0, 0);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    checkGl("drawing over a picture");
}

}  // namespace vitrine
