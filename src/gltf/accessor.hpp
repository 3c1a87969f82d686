// SPDX-License-Identifier: MIT
// Accessors: arrays of numbers in a buffer, of several types, with gaps or with single elements
// replaced. All that can be wrong with one is found before anything is read from it.
// Source: glTF 2.0 Specification, sections 3.6.2 and 5.1.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "gltf/buffers.hpp"

namespace vitrine {

/// The numbers are those of the file, which are OpenGL's.
enum class ComponentType : uint16_t {
    kByte = 5120,
    kUnsignedByte = 5121,
    kShort = 5122,
    kUnsignedShort = 5123,
    kUnsignedInt = 5125,
    kFloat = 5126,
};

struct Accessor {
    /// Elements that replace others.
    struct Sparse {
        uint32_t count = 0;
        std::vector<uint32_t> indices;  ///< growing
        const char* values = nullptr;
    };

    bool isValid = false;        ///< else an error has been reported
    const char* data = nullptr;  ///< null: all are zero
    uint32_t stride = 0;
    uint32_t count = 0;
    ComponentType type = ComponentType::kFloat;
    int components = 1;
    bool isMatrix = false;
    bool isNormalized = false;
    bool isInterleaved = false;  ///< by a byteStride
    Sparse sparse;

    /// Elements [first, first + length) as floats, `n` numbers each; those that the accessor lacks
    /// are taken from `fill`. The range must be inside.
    template <int n>
    [[nodiscard]] std::vector<glm::vec<n, float>> read(uint32_t first, uint32_t length,
                                                       glm::vec<n, float> fill = {}) const {
        std::vector<glm::vec<n, float>> result(length, fill);
        if (length > 0) readInto(first, length, n, &result[0][0]);
        return result;
    }
    /// All elements as whole numbers, without sign; the type must be one of those.
    [[nodiscard]] std::vector<uint32_t> readWhole() const;

  private:
    void readInto(uint32_t first, uint32_t length, int n, float* to) const;
};

class Accessors {
  public:
    Accessors(ReadContext& context, const Buffers& buffers);

    /// The accessor that a member of `object` names; null if it is absent or wrong, which has been
    /// reported then.
    [[nodiscard]] const Accessor* find(const JsonValue& object, std::string_view key) const;

  private:
    std::vector<Accessor> accessors_;
};

}  // namespace vitrine
