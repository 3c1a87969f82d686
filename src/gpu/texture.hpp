// SPDX-License-Identifier: MIT
// 2-D images that passes read and write, and buffers that shaders read texel by texel.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "base/math.hpp"

namespace vitrine {

class ImageStore;

enum class TexelFormat { kRgba8, kRgba16f, kRgba32f, kRgba32ui };

/// An immutable-size 2-D image, nearest filtering, no mipmaps. Row 0 is the bottom of the picture.
class Texture {
  public:
    Texture() = default;
    Texture(int width, int height, TexelFormat format);
    ~Texture();
    Texture(Texture&& other) noexcept;
    Texture& operator=(Texture&& other) noexcept;

    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }
    [[nodiscard]] TexelFormat format() const { return format_; }
    [[nodiscard]] unsigned id() const { return id_; }
    [[nodiscard]] bool valid() const { return id_ != 0; }
    [[nodiscard]] size_t bytes() const;

    /// Four values a texel, bottom row first. The type must fit the format.
    [[nodiscard]] std::vector<uint8_t> readBytes() const;
    [[nodiscard]] std::vector<float> readFloats() const;
    [[nodiscard]] std::vector<uint32_t> readUints() const;
    /// One texel; (0, 0) is at the lower left.
    [[nodiscard]] glm::uvec4 readUintsAt(int x, int y) const;
    /// Replaces all texels; `bytes` has the format's layout, bottom row first.
    void write(std::span<const std::byte> bytes);
    void clear();
    /// Replaces all texels by `from`, stretched to this size and smooth. Both are colours.
    void stretch(const Texture& from);
    /// From now on what lies between texels is mixed.
    void smooth();

  private:
    friend class ImageStore;
    void release();
    std::shared_ptr<ImageStore> home_;  ///< where it goes when it is not needed; else it is deleted
    unsigned id_ = 0;
    int width_ = 0, height_ = 0;
    TexelFormat format_ = TexelFormat::kRgba8;
};

/// A 32-bit float depth buffer.
class DepthImage {
  public:
    DepthImage() = default;
    DepthImage(int width, int height);
    ~DepthImage();
    DepthImage(DepthImage&& other) noexcept;
    DepthImage& operator=(DepthImage&& other) noexcept;
    [[nodiscard]] unsigned id() const { return id_; }

  private:
    unsigned id_ = 0;
};

/// Square RGBA8 images of one size, filtered bilinearly, without mipmaps. Row 0 is the first.
class TextureArray {
  public:
    TextureArray() = default;
    /// One texel of nothing if there are no layers. Throws MachineError if the driver cannot hold
    /// it.
    TextureArray(int size, std::span<const std::span<const uint8_t>> layers, bool srgb);
    ~TextureArray();
    TextureArray(TextureArray&& other) noexcept;
    TextureArray& operator=(TextureArray&& other) noexcept;
    [[nodiscard]] unsigned id() const { return id_; }

  private:
    unsigned id_ = 0;
};

/// A read-only array of RGBA32F or RGBA32UI texels (`samplerBuffer`, `usamplerBuffer`).
class TexelBuffer {
  public:
    TexelBuffer() = default;
    explicit TexelBuffer(TexelFormat format);
    ~TexelBuffer();
    TexelBuffer(TexelBuffer&& other) noexcept;
    TexelBuffer& operator=(TexelBuffer&& other) noexcept;

    /// Replaces the content; `bytes` is a whole number of 16-byte texels. Throws MachineError if
    /// it is more than the driver can address.
    /// `spare` texels more are allocated, for replaceEnd().
    void upload(std::span<const std::byte> bytes, size_t spare = 0);
    /// Replaces what follows the first `texels`; those stay as they are, on the GPU.
    void replaceEnd(size_t texels, std::span<const std::byte> bytes);
    [[nodiscard]] unsigned id() const { return texture_; }

  private:
    void release();
    void checkSize(size_t bytes) const;
    void attach();
    unsigned texture_ = 0, buffer_ = 0;
    size_t size_ = 0;  ///< allocated bytes
    TexelFormat format_ = TexelFormat::kRgba32f;
};

/// A std140 uniform block that is rewritten as a whole.
class UniformBlock {
  public:
    UniformBlock();
    ~UniformBlock();
    UniformBlock(const UniformBlock&) = delete;
    UniformBlock& operator=(const UniformBlock&) = delete;
    void upload(std::span<const std::byte> bytes);
    [[nodiscard]] unsigned id() const { return id_; }

  private:
    unsigned id_ = 0;
};

}  // namespace vitrine
