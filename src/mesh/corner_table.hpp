// SPDX-License-Identifier: MIT
// Finds vertices again by the three indices an OBJ corner is made of. Open addressing with linear
// probing; at most half full.
#pragma once

#include <cstdint>
#include <vector>

namespace vitrine {

class CornerTable {
  public:
    static constexpr uint32_t kNone = 0xffffffffu;

    struct Key {
        uint32_t position, uv, normal;  // uv and normal may be kNone
        bool operator==(const Key&) const = default;
    };

    /// The number of the vertex with this key. New keys are numbered from 0 in order of arrival.
    uint32_t findOrAdd(const Key& key) {
        if ((keys_.size() + 1) * 2 > slots_.size()) grow();
        uint32_t& slot = slots_[slotOf(key)];
        if (slot == kNone) {
            slot = static_cast<uint32_t>(keys_.size());
            keys_.push_back(key);
        }
        return slot;
    }
    [[nodiscard]] size_t size() const { return keys_.size(); }

  private:
    /// The finalizer of MurmurHash3 (Appleby), once for two of the indices and once for the third.
    static uint64_t mix(uint64_t h) {
        h = (h ^ (h >> 33)) * 0xff51afd7ed558ccdull;
        h = (h ^ (h >> 33)) * 0xc4ceb9fe1a85ec53ull;
        return h ^ (h >> 33);
    }
    [[nodiscard]] size_t slotOf(const Key& key) const {
        const uint64_t pair = (uint64_t{key.position} << 32) | key.uv;
        size_t i = mix(mix(pair) + key.normal) & (slots_.size() - 1);
        while (slots_[i] != kNone && !(keys_[slots_[i]] == key)) i = (i + 1) & (slots_.size() - 1);
        return i;
    }
    void grow() {
        slots_.assign(slots_.empty() ? 1024 : slots_.size() * 2, kNone);
        for (uint32_t i = 0; i < keys_.size(); ++i) slots_[slotOf(keys_[i])] = i;
    }

    std::vector<Key> keys_;
    std::vector<uint32_t> slots_;  // a power of two of them
};

}  // namespace vitrine
