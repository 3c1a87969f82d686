// SPDX-License-Identifier: MIT
#include "gpu/sampler_slots.hpp"

#include <epoxy/gl.h>

#include <string>
namespace vitrine {
namespace {

constexpr int kSlots = 16;

unsigned compile(GLenum type, const std::string& text) {
    const unsigned shader = glCreateShader(type);
    const std::string whole = "#version 410 core\n" + text;
    const char* source = whole.c_str();
    glShaderSource(shader, 1, &source, nullptr);
    glCompileShader(shader);
    return shader;
}

/// Reads as many images as there are places.
unsigned makeProgram() {
    std::string text = "out vec4 color;\n", sum = "vec4(0)";
    for (int i = 0; i < kSlots; ++i) {
        const std::string name = "image" + std::to_string(i);
        text += "uniform sampler2D " + name + ";\n";
        sum += " + texelFetch(" + name + ", ivec2(0), 0)";
    }
    const unsigned program = glCreateProgram();
    for (const unsigned shader :
         {compile(GL_VERTEX_SHADER, "void main() { gl_Position = vec4(0, 0, 0, 1); }"),
          compile(GL_FRAGMENT_SHADER, text + "void main() { color = " + sum + "; }")}) {
        glAttachShader(program, shader);
        glDeleteShader(shader);
    }
    glLinkProgram(program);
    glUseProgram(program);
    for (int i = 0; i < kSlots; ++i)
        glUniform1i(glGetUniformLocation(program, ("image" + std::to_string(i)).c_str()), i);
    return program;
}

}  // namespace

SamplerSlots::SamplerSlots() : program_(makeProgram()) {
    glGenFramebuffers(1, &framebuffer_);
    glGenVertexArrays(1, &vertexArray_);
}

SamplerSlots::~SamplerSlots() {
    glDeleteVertexArrays(1, &vertexArray_);
    glDeleteFramebuffers(1, &framebuffer_);
    glDeleteProgram(program_);
}

void SamplerSlots::fill() {
    for (unsigned i = 0; i < kSlots; ++i) {
        glActiveTexture(GL_TEXTURE0 + i);
        glBindTexture(GL_TEXTURE_2D, image_.id());
    }
    glActiveTexture(GL_TEXTURE0);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target_.id(), 0);
    const GLenum buffer = GL_COLOR_ATTACHMENT0;
    glDrawBuffers(1, &buffer);
    glViewport(0, 0, 1, 1);
    glDisable(GL_BLEND);
    glDisable(GL_DEPTH_TEST);
    glUseProgram(program_);
    glBindVertexArray(vertexArray_);
    glDrawArrays(GL_POINTS, 0, 1);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glBindVertexArray(0);
    glUseProgram(0);
}

}  // namespace vitrine
