// SPDX-License-Identifier: MIT
#include "gpu/raster_pass.hpp"

#include <epoxy/gl.h>

#include "gpu/context.hpp"

namespace vitrine {

RasterRunner::RasterRunner() {
    glGenFramebuffers(1, &framebuffer_);
    glGenVertexArrays(1, &vertexArray_);
    glGenBuffers(1, &indices_);
}

RasterRunner::~RasterRunner() {
    glDeleteFramebuffers(1, &framebuffer_);
    glDeleteVertexArrays(1, &vertexArray_);
    glDeleteBuffers(1, &indices_);
}

void RasterRunner::setIndices(std::span<const uint32_t> indices) {
    glBindVertexArray(vertexArray_);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size_bytes()),
                 indices.data(), GL_STATIC_DRAW);
    checkGl("uploading the order of triangles");
}

void RasterRunner::run(const Program& program, const UniformBlock& block,
                       const RasterImages& images, uint32_t clearTo,
                       std::span<const RasterDraw> draws) {
    useProgram(program, block);
    bindInputs(program, images.buffers);
    bindInputs(program, images.arrays);

    const Texture& target = *images.output.second;
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target.id(), 0);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, images.depth->id(),
                           0);
    const GLenum attachment = GL_COLOR_ATTACHMENT0;
    glDrawBuffers(1, &attachment);
    glViewport(0, 0, target.width(), target.height());
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_GREATER);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    glDisable(GL_CULL_FACE);
    const uint32_t clear[4] = {clearTo, clearTo, clearTo, clearTo};
    const float farAway = 0;
    glClearBufferuiv(GL_COLOR, 0, clear);
    glClearBufferfv(GL_DEPTH, 0, &farAway);

    glBindVertexArray(vertexArray_);
    const GLint matrix = glGetUniformLocation(program.id(), "clipFromObject");
    const GLint instance = glGetUniformLocation(program.id(), "drawnInstance");
    const GLint first = glGetUniformLocation(program.id(), "firstTriangle");
    std::vector<GLsizei> counts;
    std::vector<const void*> offsets;
    for (const RasterDraw& draw : draws) {
        glUniformMatrix4fv(matrix, 1, GL_FALSE, &draw.clipFromObject[0][0]);
        glUniform1i(instance, draw.instance);
        glUniform1i(first, draw.firstTriangle);
        draw.culled ? glEnable(GL_CULL_FACE) : glDisable(GL_CULL_FACE);
        glFrontFace(draw.mirrored ? GL_CW : GL_CCW);
        counts.clear();
        offsets.clear();
        for (const RasterRange& range : draw.ranges) {
            counts.push_back(static_cast<GLsizei>(range.count));
            offsets.push_back(static_cast<const char*>(nullptr) + range.first * sizeof(uint32_t));
        }
        glMultiDrawElements(GL_TRIANGLES, counts.data(), GL_UNSIGNED_INT, offsets.data(),
                            static_cast<GLsizei>(counts.size()));
    }
    glDisable(GL_CULL_FACE);
    glDisable(GL_DEPTH_TEST);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, 0, 0);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, 0, 0);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    checkGl("rasterising");
}

}  // namespace vitrine
