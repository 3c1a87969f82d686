// SPDX-License-Identifier: MIT
#include "gpu/sampler_slots.hpp"

#include <epoxy/gl.h>

#include <string>

#include "gpu/texture.hpp"

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

void fillSamplerSlots() {
    const unsigned program = makeProgram();
    const Texture image(1, 1, TexelFormat::kRgba8), target(1, 1, TexelFormat::kRgba8);
    for (unsigned i = 0; i < kSlots; ++i) {
        glActiveTexture(GL_TEXTURE0 + i);
        glBindTexture(GL_TEXTURE_2D, image.id());
    }
    glActiveTexture(GL_TEXTURE0);
    unsigned framebuffer = 0, vertexArray = 0;
    glGenFramebuffers(1, &framebuffer);
    glGenVertexArrays(1, &vertexArray);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target.id(), 0);
    glViewport(0, 0, 1, 1);
    glBindVertexArray(vertexArray);
    glDrawArrays(GL_POINTS, 0, 1);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glBindVertexArray(0);
    glUseProgram(0);
    glDeleteVertexArrays(1, &vertexArray);
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteProgram(program);
}

}  // namespace vitrine
