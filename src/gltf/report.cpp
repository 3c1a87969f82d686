// SPDX-License-Identifier: MIT
#include "gltf/report.hpp"

#include "gltf/json_place.hpp"

namespace vitrine {
namespace {

constexpr size_t kMaxQuoted = 80;

std::string withPointer(std::string_view pointer, const std::string& message) {
    return pointer.empty() ? message : std::string(pointer) + ": " + message;
}

}  // namespace

SourceLocation Report::place(std::string_view pointer) const {
    if (json_.empty() || firstByte_ > 0 || pointer.empty()) return {file_};
    const JsonPlace place = findJsonPlace(json_, pointer);
    return {file_, place.line, place.column};
}

void Report::addError(SourceLocation where, const std::string& message) {
    hasErrors_ = true;
    if (left_.errors-- == 0) {
        diagnostics_.error({file_}, "too many errors; reading ends here");
        throw Flood{};
    }
    diagnostics_.error(std::move(where), message);
}

void Report::error(std::string_view pointer, const std::string& message) {
    addError(place(pointer), withPointer(pointer, message));
}

void Report::errorAtByte(size_t byte, const std::string& message) {
    if (firstByte_ > 0) {
        addError({file_}, message + " (at byte " + std::to_string(firstByte_ + byte) + ")");
        return;
    }
    const JsonPlace place = placeOfByte(json_, byte);
    addError({file_, place.line, place.column}, message);
}

void Report::warning(std::string_view pointer, const std::string& message) {
    if (left_.warnings < 0) return;
    if (left_.warnings-- == 0)
        diagnostics_.warning({file_}, "further warnings are not shown");
    else
        diagnostics_.warning(place(pointer), withPointer(pointer, message));
}

void Report::warnOnce(std::string_view pointer, const std::string& message) {
    if (once_.insert(message).second) warning(pointer, message);
}

std::string inQuotes(std::string_view text) {
    std::string result = "'";
    for (const char c : text.substr(0, kMaxQuoted))
        result += static_cast<unsigned char>(c) < 32 || c == 127 ? '?' : c;
    // A cut must not leave half of a UTF-8 character.
    if (text.size() > kMaxQuoted) {
        while ((static_cast<unsigned char>(text[result.size() - 1]) & 0xc0) == 0x80)
            result.pop_back();
        result += "...";
    }
    return result + "'";
}

}  // namespace vitrine
