// SPDX-License-Identifier: MIT
// A value of a glTF file together with its JSON pointer. Reading from it never throws and never
// trusts: what is absent gives the fallback, what is wrong gives an error in the report and the
// fallback, so that one run reports all that is wrong.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/math.hpp"
#include "gltf/report.hpp"

namespace vitrine {

class JsonValue {
  public:
    static constexpr float kInfinity = std::numeric_limits<float>::infinity();
    static constexpr float kMaxFloat = std::numeric_limits<float>::max();

    /// `json` is null if the value is absent.
    JsonValue(const nlohmann::json* json, std::string pointer, Report& report)
        : json_(json), pointer_(std::move(pointer)), report_(&report) {}

    [[nodiscard]] bool exists() const { return json_ != nullptr; }
    [[nodiscard]] const std::string& pointer() const { return pointer_; }

    /// A member that must be an object, or an array, if it is there.
    [[nodiscard]] JsonValue object(std::string_view key) const;
    [[nodiscard]] JsonValue array(std::string_view key) const;
    /// Elements of an array; 0 if this is not one.
    [[nodiscard]] size_t size() const;
    /// An element that must be an object; absent if it is not.
    [[nodiscard]] JsonValue objectAt(size_t i) const;
    /// An element that must be an index below `count`.
    [[nodiscard]] std::optional<uint32_t> indexAt(size_t i, uint64_t count) const;
    /// An element that must be a string.
    [[nodiscard]] std::string textAt(size_t i) const;
    /// The names of an object's members.
    [[nodiscard]] std::vector<std::string> keys() const;
    [[nodiscard]] bool has(std::string_view key) const { return member(key).exists(); }

    /// A member that is a number. One outside of [min, max] is clamped, with a warning; without
    /// a range that means: made finite.
    [[nodiscard]] float number(std::string_view key, float fallback, float min = -kMaxFloat,
                               float max = kMaxFloat) const;
    /// A member that is a whole number of at least 0.
    [[nodiscard]] uint64_t whole(std::string_view key, uint64_t fallback) const;
    /// The same, but absence is an error.
    [[nodiscard]] std::optional<uint64_t> requiredWhole(std::string_view key) const;
    /// A member that is an index below `count`; kNoIndex (-1) if it is absent or wrong.
    [[nodiscard]] int index(std::string_view key, uint64_t count) const;
    [[nodiscard]] bool flag(std::string_view key, bool fallback) const;
    [[nodiscard]] std::string text(std::string_view key) const;

    template <int n>
    [[nodiscard]] glm::vec<n, float> vector(std::string_view key, glm::vec<n, float> fallback,
                                            float min = -kMaxFloat, float max = kMaxFloat) const {
        std::array<float, n> values{};
        if (numbers(key, values.data(), n, min, max))
            for (int i = 0; i < n; ++i) fallback[i] = values[i];
        return fallback;
    }
    /// Fills `to` with the numbers of an array of length `count`. False if it is absent or wrong.
    bool numbers(std::string_view key, float* to, size_t count, float min = -kMaxFloat,
                 float max = kMaxFloat) const;

    void error(const std::string& message) const { report_->error(pointer_, message); }
    void error(std::string_view key, const std::string& message) const;
    void warning(const std::string& message) const { report_->warning(pointer_, message); }
    void warning(std::string_view key, const std::string& message) const;
    void warnOnce(const std::string& message) const { report_->warnOnce(pointer_, message); }

  private:
    [[nodiscard]] JsonValue member(std::string_view key) const;
    [[nodiscard]] JsonValue element(size_t i) const;
    [[nodiscard]] std::optional<float> toNumber(float min, float max) const;
    [[nodiscard]] std::optional<uint64_t> toWhole() const;
    [[nodiscard]] std::optional<uint32_t> toIndex(uint64_t count) const;

    const nlohmann::json* json_;
    std::string pointer_;
    Report* report_;
};

}  // namespace vitrine
