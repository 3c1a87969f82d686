// SPDX-License-Identifier: MIT
#include "gltf/json_value.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace vitrine {
namespace {

/// The largest whole number that is exact in every reader of JSON; also keeps sums from wrapping.
constexpr uint64_t kMaxWhole = 1ull << 53;

std::string escaped(std::string_view key) {
    std::string result;
    for (const char c : key) {
        if (c == '~')
            result += "~0";
        else if (c == '/')
            result += "~1";
        else
            result += c;
    }
    return result;
}

}  // namespace

JsonValue JsonValue::member(std::string_view key) const {
    const nlohmann::json* found = nullptr;
    if (json_ != nullptr && json_->is_object()) {
        const auto& members = json_->get_ref<const nlohmann::json::object_t&>();
        if (const auto it = members.find(std::string(key)); it != members.end())
            found = &it->second;
    }
    return {found, pointer_ + '/' + escaped(key), *report_};
}

JsonValue JsonValue::element(size_t i) const {
    const bool isThere = json_ != nullptr && json_->is_array() && i < json_->size();
    return {isThere ? &(*json_)[i] : nullptr, pointer_ + '/' + std::to_string(i), *report_};
}

JsonValue JsonValue::object(std::string_view key) const {
    JsonValue value = member(key);
    if (value.exists() && !value.json_->is_object()) {
        value.error("must be an object");
        value.json_ = nullptr;
    }
    return value;
}

JsonValue JsonValue::array(std::string_view key) const {
    JsonValue value = member(key);
    if (value.exists() && !value.json_->is_array()) {
        value.error("must be an array");
        value.json_ = nullptr;
    }
    return value;
}

size_t JsonValue::size() const {
    return json_ != nullptr && json_->is_array() ? json_->size() : 0;
}

JsonValue JsonValue::objectAt(size_t i) const {
    JsonValue value = element(i);
    if (value.exists() && !value.json_->is_object()) {
        value.error("must be an object");
        value.json_ = nullptr;
    }
    return value;
}

std::optional<uint32_t> JsonValue::indexAt(size_t i, uint64_t count) const {
    return element(i).toIndex(count);
}

std::string JsonValue::textAt(size_t i) const {
    const JsonValue value = element(i);
    if (value.exists() && value.json_->is_string()) return value.json_->get<std::string>();
    value.error("must be a string");
    return {};
}

std::vector<std::string> JsonValue::keys() const {
    std::vector<std::string> result;
    if (json_ != nullptr && json_->is_object())
        for (const auto& [key, value] : json_->get_ref<const nlohmann::json::object_t&>())
            result.push_back(key);
    return result;
}

float JsonValue::number(std::string_view key, float fallback, float min, float max) const {
    const JsonValue value = member(key);
    return value.exists() ? value.toNumber(min, max).value_or(fallback) : fallback;
}

uint64_t JsonValue::whole(std::string_view key, uint64_t fallback) const {
    const JsonValue value = member(key);
    return value.exists() ? value.toWhole().value_or(fallback) : fallback;
}

std::optional<uint64_t> JsonValue::requiredWhole(std::string_view key) const {
    const JsonValue value = member(key);
    if (value.exists()) return value.toWhole();
    error(fmt::format("'{}' is missing", key));
    return {};
}

int JsonValue::index(std::string_view key, uint64_t count) const {
    const JsonValue value = member(key);
    if (!value.exists()) return -1;
    const auto found = value.toIndex(count);
    return found ? static_cast<int>(*found) : -1;
}

bool JsonValue::flag(std::string_view key, bool fallback) const {
    const JsonValue value = member(key);
    if (!value.exists()) return fallback;
    if (value.json_->is_boolean()) return value.json_->get<bool>();
    value.error("must be true or false");
    return fallback;
}

std::string JsonValue::text(std::string_view key) const {
    const JsonValue value = member(key);
    if (!value.exists()) return {};
    if (value.json_->is_string()) return value.json_->get<std::string>();
    value.error("must be a string");
    return {};
}

bool JsonValue::numbers(std::string_view key, float* to, size_t count, float min, float max) const {
    const JsonValue list = array(key);
    if (!list.exists()) return false;
    if (list.size() != count) {
        list.error(fmt::format("must have {} numbers, not {}", count, list.size()));
        return false;
    }
    for (size_t i = 0; i < count; ++i) {
        const auto value = list.element(i).toNumber(min, max);
        if (!value) return false;
        to[i] = *value;
    }
    return true;
}

void JsonValue::error(std::string_view key, const std::string& message) const {
    report_->error(member(key).pointer_, message);
}

void JsonValue::warning(std::string_view key, const std::string& message) const {
    report_->warning(member(key).pointer_, message);
}

std::optional<float> JsonValue::toNumber(float min, float max) const {
    if (!json_->is_number()) {
        error("must be a number");
        return {};
    }
    // A number such as 1e39 is infinite here.
    const auto value = static_cast<float>(json_->get<double>());
    if (value >= min && value <= max) return value;
    const float clamped = value < min ? min : max;
    warning(fmt::format("{} is not in the range {} to {}; taken as {}", value, min, max, clamped));
    return clamped;
}

std::optional<uint64_t> JsonValue::toWhole() const {
    if (json_->is_number_unsigned()) {
        if (const auto value = json_->get<uint64_t>(); value <= kMaxWhole) return value;
    } else if (json_->is_number_float()) {
        const auto value = json_->get<double>();
        if (value >= 0.0 && value <= double(kMaxWhole) && value == std::floor(value))
            return static_cast<uint64_t>(value);
    }
    error("must be a whole number from 0 to 2^53");
    return {};
}

std::optional<uint32_t> JsonValue::toIndex(uint64_t count) const {
    const auto value = toWhole();
    if (!value) return {};
    if (*value < count && *value <= uint64_t(std::numeric_limits<int>::max()))
        return static_cast<uint32_t>(*value);
    error(count == 0 ? fmt::format("{} is out of range: there are none", *value)
                     : fmt::format("{} is out of range: the last one is {}", *value, count - 1));
    return {};
}

}  // namespace vitrine
