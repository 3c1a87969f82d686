// SPDX-License-Identifier: MIT
#include "gpu/texture.hpp"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <utility>

#include "base/error.hpp"
#include "gpu/context.hpp"
#include "gpu/image_store.hpp"

namespace vitrine {
namespace {

struct FormatInfo {
    GLenum internal, external, type;
};

FormatInfo formatInfo(TexelFormat format) {
    switch (format) {
        case TexelFormat::kRgba8:
            return {GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE};
        case TexelFormat::kRgba16f:
            return {GL_RGBA16F, GL_RGBA, GL_HALF_FLOAT};
        case TexelFormat::kRgba32f:
            return {GL_RGBA32F, GL_RGBA, GL_FLOAT};
        case TexelFormat::kRgba32ui:
            return {GL_RGBA32UI, GL_RGBA_INTEGER, GL_UNSIGNED_INT};
    }
    return {};
}

/// llvmpipe compiles a program once more for a buffer whose size in bytes is a power of two, and
/// for one whose size has no bit set in its second byte, which it takes for a number of mipmaps. So
/// sizes are neither.
size_t usualSize(size_t bytes) {
    if ((bytes & 0xff00) == 0) bytes += 0x100;
    return std::has_single_bit(bytes) ? bytes + 16 : bytes;
}

template <class T>
std::vector<T> read(const Texture& texture, GLenum external, GLenum type) {
    std::vector<T> data(static_cast<size_t>(texture.width()) * texture.height() * 4);
    glBindTexture(GL_TEXTURE_2D, texture.id());
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glGetTexImage(GL_TEXTURE_2D, 0, external, type, data.data());
    checkGl("reading an image back");
    return data;
}

}  // namespace

Texture::Texture(int width, int height, TexelFormat format)
    : width_(width), height_(height), format_(format) {
    const FormatInfo info = formatInfo(format);
    glGenTextures(1, &id_);
    glBindTexture(GL_TEXTURE_2D, id_);
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(info.internal), width, height, 0,
                 info.external, info.type, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    checkGl("allocating an image");
}

Texture::~Texture() {
    release();
}

Texture::Texture(Texture&& other) noexcept {
    *this = std::move(other);
}

Texture& Texture::operator=(Texture&& other) noexcept {
    if (this != &other) {
        release();
        home_ = std::move(other.home_);
        id_ = std::exchange(other.id_, 0);
        width_ = other.width_;
        height_ = other.height_;
        format_ = other.format_;
    }
    return *this;
}

void Texture::release() {
    if (const std::shared_ptr<ImageStore> home = std::move(home_))
        home->giveBack(std::move(*this));
    else if (id_ != 0)
        glDeleteTextures(1, &id_);
    id_ = 0;
}

size_t Texture::bytes() const {
    const size_t texel = format_ == TexelFormat::kRgba8     ? 4
                         : format_ == TexelFormat::kRgba16f ? 8
                                                            : 16;
    return texel * static_cast<size_t>(width_) * static_cast<size_t>(height_);
}

std::vector<uint8_t> Texture::readBytes() const {
    assert(format_ == TexelFormat::kRgba8);
    return read<uint8_t>(*this, GL_RGBA, GL_UNSIGNED_BYTE);
}

std::vector<float> Texture::readFloats() const {
    assert(format_ == TexelFormat::kRgba32f || format_ == TexelFormat::kRgba16f);
    return read<float>(*this, GL_RGBA, GL_FLOAT);
}

std::vector<uint32_t> Texture::readUints() const {
    assert(format_ == TexelFormat::kRgba32ui);
    return read<uint32_t>(*this, GL_RGBA_INTEGER, GL_UNSIGNED_INT);
}

glm::uvec4 Texture::readUintsAt(int x, int y) const {
    assert(format_ == TexelFormat::kRgba32ui && x >= 0 && x < width_ && y >= 0 && y < height_);
    unsigned framebuffer = 0;
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, id_, 0);
    glm::uvec4 texel(0);
    glReadPixels(x, y, 1, 1, GL_RGBA_INTEGER, GL_UNSIGNED_INT, &texel.x);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    glDeleteFramebuffers(1, &framebuffer);
    checkGl("reading a texel back");
    return texel;
}

void Texture::write(std::span<const std::byte> bytes) {
    const FormatInfo info = formatInfo(format_);
    assert(bytes.size() % (static_cast<size_t>(width_) * height_) == 0);
    glBindTexture(GL_TEXTURE_2D, id_);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width_, height_, info.external, info.type,
                    bytes.data());
    checkGl("uploading an image");
}

void Texture::stretch(const Texture& from) {
    std::array<GLuint, 2> framebuffers{};
    glGenFramebuffers(2, framebuffers.data());
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffers[0]);
    glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, from.id_, 0);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffers[1]);
    glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, id_, 0);
    glBlitFramebuffer(0, 0, from.width_, from.height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT,
                      GL_LINEAR);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDeleteFramebuffers(2, framebuffers.data());
}

void Texture::smooth() {
    glBindTexture(GL_TEXTURE_2D, id_);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
}

void Texture::clear() {
    unsigned framebuffer = 0;
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, id_, 0);
    const float zero[4] = {};
    const uint32_t zeroUint[4] = {};
    if (format_ == TexelFormat::kRgba32ui)
        glClearBufferuiv(GL_COLOR, 0, zeroUint);
    else
        glClearBufferfv(GL_COLOR, 0, zero);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDeleteFramebuffers(1, &framebuffer);
}

DepthImage::DepthImage(int width, int height) {
    glGenTextures(1, &id_);
    glBindTexture(GL_TEXTURE_2D, id_);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT32F, width, height, 0, GL_DEPTH_COMPONENT,
                 GL_FLOAT, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    checkGl("allocating a depth image");
}

DepthImage::~DepthImage() {
    if (id_ != 0) glDeleteTextures(1, &id_);
}

DepthImage::DepthImage(DepthImage&& other) noexcept : id_(std::exchange(other.id_, 0)) {}

DepthImage& DepthImage::operator=(DepthImage&& other) noexcept {
    std::swap(id_, other.id_);
    return *this;
}

TextureArray::TextureArray(int size, std::span<const std::span<const uint8_t>> layers, bool srgb) {
    const auto count = std::max(static_cast<GLsizei>(layers.size()), 1);
    GLint maxSize = 0, maxLayers = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &maxSize);
    glGetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &maxLayers);
    if (size > maxSize || count > maxLayers)
        throw MachineError(
            fmt::format("the textures need {} pages of {}x{}; this driver allows {} of {}x{}",
                        count, size, size, maxLayers, maxSize, maxSize));
    glGenTextures(1, &id_);
    glBindTexture(GL_TEXTURE_2D_ARRAY, id_);
    const int side = layers.empty() ? 1 : size;
    glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, srgb ? GL_SRGB8_ALPHA8 : GL_RGBA8, side, side, count, 0,
                 GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    checkGl("allocating textures");
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    for (size_t i = 0; i < layers.size(); ++i)
        glTexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, 0, 0, static_cast<GLint>(i), side, side, 1, GL_RGBA,
                        GL_UNSIGNED_BYTE, layers[i].data());
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, 0);
    checkGl("uploading textures");
}

TextureArray::~TextureArray() {
    if (id_ != 0) glDeleteTextures(1, &id_);
}

TextureArray::TextureArray(TextureArray&& other) noexcept : id_(std::exchange(other.id_, 0)) {}

TextureArray& TextureArray::operator=(TextureArray&& other) noexcept {
    std::swap(id_, other.id_);
    return *this;
}

TexelBuffer::TexelBuffer(TexelFormat format) : format_(format) {
    glGenBuffers(1, &buffer_);
    glGenTextures(1, &texture_);
}

TexelBuffer::~TexelBuffer() {
    release();
}

TexelBuffer::TexelBuffer(TexelBuffer&& other) noexcept {
    *this = std::move(other);
}

TexelBuffer& TexelBuffer::operator=(TexelBuffer&& other) noexcept {
    if (this != &other) {
        release();
        texture_ = std::exchange(other.texture_, 0);
        buffer_ = std::exchange(other.buffer_, 0);
        size_ = std::exchange(other.size_, 0);
        format_ = other.format_;
    }
    return *this;
}

void TexelBuffer::release() {
    if (texture_ != 0) glDeleteTextures(1, &texture_);
    if (buffer_ != 0) glDeleteBuffers(1, &buffer_);
    texture_ = buffer_ = 0;
}

void TexelBuffer::checkSize(size_t bytes) const {
    GLint limit = 0;
    glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &limit);
    if (bytes / 16 > static_cast<size_t>(limit))
        throw MachineError(fmt::format(
            "the scene needs a buffer of {} texels; this driver allows {}", bytes / 16, limit));
}

void TexelBuffer::attach() {
    glBindTexture(GL_TEXTURE_BUFFER, texture_);
    glTexBuffer(GL_TEXTURE_BUFFER, formatInfo(format_).internal, buffer_);
    checkGl("uploading the scene");
}

void TexelBuffer::upload(std::span<const std::byte> bytes, size_t spare) {
    static constexpr std::byte kOneTexel[16] = {};
    if (bytes.empty()) bytes = kOneTexel;  // a buffer texture of size 0 is incomplete
    assert(bytes.size() % 16 == 0);
    size_ = usualSize(bytes.size() + spare * 16);
    checkSize(size_);
    glBindBuffer(GL_TEXTURE_BUFFER, buffer_);
    glBufferData(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(size_),
                 size_ == bytes.size() ? bytes.data() : nullptr, GL_STATIC_DRAW);
    if (size_ != bytes.size())
        glBufferSubData(GL_TEXTURE_BUFFER, 0, static_cast<GLsizeiptr>(bytes.size()), bytes.data());
    checkGl("uploading the scene");
    attach();
}

void TexelBuffer::replaceEnd(size_t texels, std::span<const std::byte> bytes) {
    assert(bytes.size() % 16 == 0);
    const size_t kept = texels * 16, needed = kept + bytes.size();
    if (needed > size_) {
        // Ends differ a little in length.
        const size_t roomy = usualSize((needed + bytes.size() / 4) / 16 * 16);
        checkSize(roomy);
        unsigned larger = 0;
        glGenBuffers(1, &larger);
        glBindBuffer(GL_COPY_WRITE_BUFFER, larger);
        glBufferData(GL_COPY_WRITE_BUFFER, static_cast<GLsizeiptr>(roomy), nullptr, GL_STATIC_DRAW);
        glBindBuffer(GL_COPY_READ_BUFFER, buffer_);
        glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, 0,
                            static_cast<GLsizeiptr>(kept));
        glDeleteBuffers(1, &buffer_);
        buffer_ = larger;
        size_ = roomy;
        attach();
    }
    glBindBuffer(GL_TEXTURE_BUFFER, buffer_);
    glBufferSubData(GL_TEXTURE_BUFFER, static_cast<GLintptr>(kept),
                    static_cast<GLsizeiptr>(bytes.size()), bytes.data());
    checkGl("uploading the scene");
}

UniformBlock::UniformBlock() {
    glGenBuffers(1, &id_);
}

UniformBlock::~UniformBlock() {
    glDeleteBuffers(1, &id_);
}

void UniformBlock::upload(std::span<const std::byte> bytes) {
    glBindBuffer(GL_UNIFORM_BUFFER, id_);
    glBufferData(GL_UNIFORM_BUFFER, static_cast<GLsizeiptr>(bytes.size()), bytes.data(),
                 GL_DYNAMIC_DRAW);
}

}  // namespace vitrine
