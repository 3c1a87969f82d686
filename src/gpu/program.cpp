// SPDX-License-Identifier: MIT
#include "gpu/program.hpp"

#include <epoxy/gl.h>

#include <utility>

namespace vitrine {
namespace {

void attach(unsigned program, GLenum type, const ShaderKey& key,
            const GeneratedIncludes& generated) {
    AssembledShader source = assembleShader(key, generated);
    const GLuint shader = glCreateShader(type);
    const char* text = source.text.c_str();
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    GLint compiled = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (compiled == 0) {
        GLint length = 0;
        glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
        std::string log(static_cast<size_t>(length), '\0');
        glGetShaderInfoLog(shader, length, nullptr, log.data());
        glDeleteShader(shader);
        throw ShaderError("cannot compile " + key.text(), log, std::move(source.places));
    }
    glAttachShader(program, shader);
    glDeleteShader(shader);
}

bool isSampler(GLenum type) {
    switch (type) {
        case GL_SAMPLER_2D:
        case GL_UNSIGNED_INT_SAMPLER_2D:
        case GL_SAMPLER_BUFFER:
        case GL_UNSIGNED_INT_SAMPLER_BUFFER:
            return true;
        default:
            return false;
    }
}

bool isImage(GLenum type) {
    return type == GL_IMAGE_2D || type == GL_UNSIGNED_INT_IMAGE_2D;
}

}  // namespace

Program Program::fragment(const ShaderKey& key, const GeneratedIncludes& generated) {
    Program program;
    program.id_ = glCreateProgram();
    ShaderKey vertex = key;
    vertex.entry = "fullscreen";
    vertex.stage = ShaderStage::kVertex;
    attach(program.id_, GL_VERTEX_SHADER, vertex, {});
    attach(program.id_, GL_FRAGMENT_SHADER, key, generated);
    program.link(key.text());
    return program;
}

Program Program::compute(const ShaderKey& key, const GeneratedIncludes& generated) {
    Program program;
    program.id_ = glCreateProgram();
    program.compute_ = true;
    attach(program.id_, GL_COMPUTE_SHADER, key, generated);
    program.link(key.text());
    return program;
}

void Program::link(const std::string& name) {
    glLinkProgram(id_);
    GLint linked = 0;
    glGetProgramiv(id_, GL_LINK_STATUS, &linked);
    if (linked == 0) {
        GLint length = 0;
        glGetProgramiv(id_, GL_INFO_LOG_LENGTH, &length);
        std::string log(static_cast<size_t>(length), '\0');
        glGetProgramInfoLog(id_, length, nullptr, log.data());
        throw ShaderError("cannot link " + name, log, {});
    }
    assignUnits();
    const GLuint block = glGetUniformBlockIndex(id_, "FrameBlock");
    if (block != GL_INVALID_INDEX) glUniformBlockBinding(id_, block, kFrameBlockBinding);
}

void Program::assignUnits() {
    GLint count = 0;
    glGetProgramiv(id_, GL_ACTIVE_UNIFORMS, &count);
    glUseProgram(id_);
    int samplers = 0, images = 0;
    for (GLint i = 0; i < count; ++i) {
        char name[128];
        GLint size = 0;
        GLenum type = 0;
        glGetActiveUniform(id_, static_cast<GLuint>(i), sizeof name, nullptr, &size, &type, name);
        const GLint location = glGetUniformLocation(id_, name);
        if (location < 0 || !(isSampler(type) || isImage(type))) continue;
        const int unit = isSampler(type) ? samplers++ : images++;
        glUniform1i(location, unit);
        units_[name] = unit;
    }
}

int Program::unit(const std::string& name) const {
    const auto found = units_.find(name);
    return found == units_.end() ? -1 : found->second;
}

int Program::outputLocation(const std::string& name) const {
    return compute_ ? unit(name) : glGetFragDataLocation(id_, name.c_str());
}

Program::~Program() {
    release();
}

Program::Program(Program&& other) noexcept {
    *this = std::move(other);
}

Program& Program::operator=(Program&& other) noexcept {
    if (this != &other) {
        release();
        id_ = std::exchange(other.id_, 0);
        compute_ = other.compute_;
        units_ = std::move(other.units_);
    }
    return *this;
}

void Program::release() {
    if (id_ != 0) glDeleteProgram(id_);
    id_ = 0;
}

}  // namespace vitrine
