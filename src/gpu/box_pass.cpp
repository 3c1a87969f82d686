// SPDX-License-Identifier: MIT
#include "gpu/box_pass.hpp"

#include <epoxy/gl.h>

#include <algorithm>
#include <vector>

#include "base/math.hpp"
#include "gpu/bindings.hpp"
#include "gpu/context.hpp"

namespace vitrine {
namespace {

constexpr GLsizei kStripVertices = 14;  // of a cube

/// How many boxes the program takes at once.
size_t batchSize(const Program& program) {
    const char* name = "clipFromBox[0]";
    GLuint index = GL_INVALID_INDEX;
    glGetUniformIndices(program.id(), 1, &name, &index);
    GLint size = 0;
    glGetActiveUniformsiv(program.id(), 1, &index, GL_UNIFORM_SIZE, &size);
    return static_cast<size_t>(size);
}

void prepareTarget(BoxTarget target, uint32_t clearTo) {
    if (target == BoxTarget::kSum) {
        glDisable(GL_DEPTH_TEST);
        glEnable(GL_BLEND);
        glBlendFunc(GL_ONE, GL_ONE);
        glBlendEquationSeparate(GL_FUNC_ADD, GL_MAX);
        return;
    }
    glDisable(GL_BLEND);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_GREATER);
    glDepthMask(GL_TRUE);
    if (target == BoxTarget::kNearest) return;
    const uint32_t clear[4] = {clearTo, clearTo, clearTo, clearTo};
    const float farAway = 0;
    glClearBufferuiv(GL_COLOR, 0, clear);
    glClearBufferfv(GL_DEPTH, 0, &farAway);
}

}  // namespace

BoxRunner::BoxRunner() {
    glGenFramebuffers(1, &framebuffer_);
    glGenVertexArrays(1, &vertexArray_);
}

BoxRunner::~BoxRunner() {
    glDeleteFramebuffers(1, &framebuffer_);
    glDeleteVertexArrays(1, &vertexArray_);
}

void BoxRunner::run(const Program& program, const UniformBlock& block, const RasterImages& images,
                    BoxTarget target, uint32_t clearTo, std::span<const BoxDraw> draws,
                    PixelRows rows) {
    useProgram(program, block);
    bindInputs(program, images.buffers);
    bindInputs(program, images.arrays);
    const Texture& output = *images.output.second;
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, output.id(), 0);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D,
                           images.depth != nullptr ? images.depth->id() : 0, 0);
    const GLenum attachment = GL_COLOR_ATTACHMENT0;
    glDrawBuffers(1, &attachment);
    glViewport(0, 0, output.width(), output.height());
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, rows.begin, output.width(),
              std::max(0, std::min(rows.end, output.height()) - rows.begin));
    prepareTarget(target, clearTo);
    glEnable(GL_CULL_FACE);
    glCullFace(GL_FRONT);
    glFrontFace(GL_CCW);
    glBindVertexArray(vertexArray_);

    const GLint matrices = glGetUniformLocation(program.id(), "clipFromBox");
    const GLint instances = glGetUniformLocation(program.id(), "boxInstance");
    std::vector<glm::mat4> batchMatrices;
    std::vector<GLint> batchInstances;
    const size_t batch = batchSize(program);
    for (size_t first = 0; first < draws.size(); first += batch) {
        batchMatrices.clear();
        batchInstances.clear();
        for (const BoxDraw& draw : draws.subspan(first, std::min(batch, draws.size() - first))) {
            batchMatrices.push_back(draw.clipFromBox);
            batchInstances.push_back(draw.instance);
        }
        const auto count = static_cast<GLsizei>(batchMatrices.size());
        glUniformMatrix4fv(matrices, count, GL_FALSE, &batchMatrices[0][0][0]);
        glUniform1iv(instances, count, batchInstances.data());
        glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, kStripVertices, count);
    }
    glDisable(GL_SCISSOR_TEST);
    glCullFace(GL_BACK);
    glDisable(GL_CULL_FACE);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    glBlendEquation(GL_FUNC_ADD);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, 0, 0);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, 0, 0);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    checkGl("drawing boxes");
}

}  // namespace vitrine
