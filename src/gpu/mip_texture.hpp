// SPDX-License-Identifier: MIT
// A 2-D picture of half floats with smaller versions of it, filtered between texels and versions.
#pragma once

#include <cstdint>
#include <span>

namespace vitrine {

/// Repeats from left to right and ends above and below, as a picture of all directions does. Row 0
/// is the first, at v = 0.
class MipTexture {
  public:
    /// RGBA16F. Sides are halved, and rounded down, from each level to the next until both are 1.
    struct Level {
        int width = 0, height = 0;
        std::span<const uint16_t> texels;
    };

    MipTexture() = default;
    /// Throws MachineError if the driver cannot hold it.
    explicit MipTexture(std::span<const Level> levels);
    ~MipTexture();
    MipTexture(MipTexture&& other) noexcept;
    MipTexture& operator=(MipTexture&& other) noexcept;
    [[nodiscard]] unsigned id() const { return id_; }

  private:
    unsigned id_ = 0;
};

}  // namespace vitrine
