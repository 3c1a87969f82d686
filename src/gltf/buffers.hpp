// SPDX-License-Identifier: MIT
// The bytes of a glTF file: buffers, which are files or parts of one, and bufferViews, which are
// ranges of buffers.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gltf/read_context.hpp"

namespace vitrine {

struct BufferView {
    bool isValid = false;  ///< else an error has been reported
    std::string_view bytes;
    uint64_t offset = 0;  ///< in its buffer
    uint32_t stride = 0;  ///< bytes from one element to the next; 0: they follow each other
};

class Buffers {
  public:
    /// Reads all of them. `binary` is the chunk of a .glb, which must outlive this.
    Buffers(ReadContext& context, std::optional<std::string_view> binary);

    /// A valid view that a member of `object` names, or null; it is required.
    [[nodiscard]] const BufferView* findView(const JsonValue& object) const;

  private:
    std::optional<std::string_view> readBuffer(ReadContext& context, const JsonValue& buffer,
                                               std::optional<std::string_view> binary);
    BufferView readView(const JsonValue& view) const;

    std::vector<std::string> files_;
    std::vector<std::optional<std::string_view>> buffers_;  // nothing: an error has been reported
    std::vector<BufferView> views_;
};

}  // namespace vitrine
