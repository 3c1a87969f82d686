// SPDX-License-Identifier: MIT
#include "gpu/mip_texture.hpp"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <utility>

#include "base/error.hpp"
#include "gpu/context.hpp"

namespace vitrine {

MipTexture::MipTexture(std::span<const Level> levels) {
    GLint maxSize = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &maxSize);
    if (levels.front().width > maxSize || levels.front().height > maxSize)
        throw MachineError(fmt::format("the sky has {}x{} texels; this driver allows {} a side",
                                       levels.front().width, levels.front().height, maxSize));
    glGenTextures(1, &id_);
    glBindTexture(GL_TEXTURE_2D, id_);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    for (size_t i = 0; i < levels.size(); ++i)
        glTexImage2D(GL_TEXTURE_2D, static_cast<GLint>(i), GL_RGBA16F, levels[i].width,
                     levels[i].height, 0, GL_RGBA, GL_HALF_FLOAT, levels[i].texels.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, static_cast<GLint>(levels.size()) - 1);
    checkGl("uploading the sky");
}

MipTexture::~MipTexture() {
    if (id_ != 0) glDeleteTextures(1, &id_);
}

MipTexture::MipTexture(MipTexture&& other) noexcept : id_(std::exchange(other.id_, 0)) {}

MipTexture& MipTexture::operator=(MipTexture&& other) noexcept {
    std::swap(id_, other.id_);
    return *this;
}

}  // namespace vitrine
