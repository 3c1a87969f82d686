// SPDX-License-Identifier: MIT
#include "gpu/image_pass.hpp"

#include <epoxy/gl.h>

#include <algorithm>
#include <cassert>

#include "gpu/context.hpp"

namespace vitrine {
namespace {

constexpr int kGroupSize = 8;  // local_size_x and _y of every entry/*.comp.glsl

GLenum imageFormat(TexelFormat format) {
    switch (format) {
        case TexelFormat::kRgba8:
            return GL_RGBA8;
        case TexelFormat::kRgba16f:
            return GL_RGBA16F;
        case TexelFormat::kRgba32f:
            return GL_RGBA32F;
        case TexelFormat::kRgba32ui:
            return GL_RGBA32UI;
    }
    return GL_RGBA8;
}

}  // namespace

PassRunner::PassRunner() {
    glGenFramebuffers(1, &framebuffer_);
    glGenVertexArrays(1, &vertexArray_);
}

PassRunner::~PassRunner() {
    glDeleteFramebuffers(1, &framebuffer_);
    glDeleteVertexArrays(1, &vertexArray_);
}

void PassRunner::run(const Program& program, const UniformBlock& block, const PassImages& images,
                     PixelRows rows) {
    assert(!images.outputs.empty());
    useProgram(program, block);
    bindInputs(program, images.inputs);
    bindInputs(program, images.buffers);
    bindInputs(program, images.arrays);
    bindInputs(program, images.pictures);
    program.isCompute() ? dispatch(program, images) : draw(program, images, rows);
    checkGl("running a pass");
}

void PassRunner::draw(const Program& program, const PassImages& images, PixelRows rows) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    std::vector<GLenum> buffers;
    for (const auto& [name, texture] : images.outputs) {
        const int location = program.outputLocation(name);
        if (location < 0) continue;
        if (buffers.size() <= static_cast<size_t>(location))
            buffers.resize(static_cast<size_t>(location) + 1, GL_NONE);
        const GLenum attachment = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(location);
        glFramebufferTexture2D(GL_FRAMEBUFFER, attachment, GL_TEXTURE_2D, texture->id(), 0);
        buffers[static_cast<size_t>(location)] = attachment;
    }
    glDrawBuffers(static_cast<GLsizei>(buffers.size()), buffers.data());
    const int width = images.outputs[0].second->width(),
              height = images.outputs[0].second->height();
    const int end = std::min(rows.end, height);
    // Not by the scissor: llvmpipe would compile every program once more for it.
    glViewport(0, rows.begin, width, std::max(0, end - rows.begin));
    glDisable(GL_BLEND);
    glDisable(GL_DEPTH_TEST);
    glBindVertexArray(vertexArray_);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    for (const GLenum attachment : buffers)
        if (attachment != GL_NONE)
            glFramebufferTexture2D(GL_FRAMEBUFFER, attachment, GL_TEXTURE_2D, 0, 0);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

void PassRunner::dispatch(const Program& program, const PassImages& images) {
    for (const auto& [name, texture] : images.outputs) {
        const int unit = program.outputLocation(name);
        if (unit < 0) continue;
        glBindImageTexture(static_cast<GLuint>(unit), texture->id(), 0, GL_FALSE, 0, GL_WRITE_ONLY,
                           imageFormat(texture->format()));
    }
    const auto groups = [](int size) {
        return static_cast<GLuint>((size + kGroupSize - 1) / kGroupSize);
    };
    const Texture& target = *images.outputs[0].second;
    glDispatchCompute(groups(target.width()), groups(target.height()), 1);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT |
                    GL_TEXTURE_UPDATE_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT);
}

}  // namespace vitrine
