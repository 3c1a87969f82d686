// SPDX-License-Identifier: MIT
#include "gltf/json_place.hpp"

#include <algorithm>
#include <charconv>
#include <string>

namespace vitrine {
namespace {

class Scanner {
  public:
    explicit Scanner(std::string_view json) : json_(json) {}

    [[nodiscard]] size_t at() const { return at_; }

    void skipSpace() {
        while (at_ < json_.size() && std::string_view(" \t\r\n").find(json_[at_]) != kNone) ++at_;
    }

    /// True if the member or element named by `token` was found; it begins at at() then.
    bool enter(std::string_view token) {
        const char open = peek();
        if (open != '{' && open != '[') return false;
        size_t index = 0;
        const bool isArray = open == '[';
        if (isArray && std::from_chars(token.begin(), token.end(), index).ec != std::errc()) {
            return false;
        }
        ++at_;
        for (size_t i = 0;; ++i) {
            skipSpace();
            if (peek() == '}' || peek() == ']' || peek() == '\0') return false;
            bool isWanted = isArray && i == index;
            if (!isArray) {
                const std::string_view key = string();
                isWanted = key == token;
                skipSpace();
                ++at_;  // the colon
                skipSpace();
            }
            if (isWanted) return true;
            skipValue();
            skipSpace();
            if (peek() == ',') ++at_;
        }
    }

  private:
    static constexpr size_t kNone = std::string_view::npos;

    [[nodiscard]] char peek() const { return at_ < json_.size() ? json_[at_] : '\0'; }

    /// The text between the quotes, escapes as they are: no key that Vitrine knows has any.
    std::string_view string() {
        const size_t begin = ++at_;
        while (at_ < json_.size() && json_[at_] != '"') at_ += json_[at_] == '\\' ? 2 : 1;
        at_ = std::min(at_, json_.size());
        const std::string_view text = json_.substr(begin, at_ - begin);
        if (at_ < json_.size()) ++at_;
        return text;
    }

    void skipValue() {
        int depth = 0;
        do {
            const char c = peek();
            if (c == '"') {
                string();
            } else {
                if (c == '{' || c == '[') ++depth;
                if (c == '}' || c == ']') --depth;
                ++at_;
            }
            // Outside of brackets a number or a word ends where something else begins.
            if (depth == 0 && std::string_view(",]} \t\r\n").find(peek()) != kNone) return;
        } while (at_ < json_.size());
    }

    std::string_view json_;
    size_t at_ = 0;
};

std::string unescaped(std::string_view token) {
    std::string result;
    for (size_t i = 0; i < token.size(); ++i) {
        if (token[i] == '~' && i + 1 < token.size())
            result += token[++i] == '1' ? '/' : '~';
        else
            result += token[i];
    }
    return result;
}

}  // namespace

JsonPlace findJsonPlace(std::string_view json, std::string_view pointer) {
    Scanner scanner(json);
    scanner.skipSpace();
    size_t found = scanner.at();
    while (!pointer.empty()) {
        pointer.remove_prefix(1);
        const std::string_view token = pointer.substr(0, pointer.find('/'));
        pointer.remove_prefix(token.size());
        if (!scanner.enter(unescaped(token))) break;
        found = scanner.at();
    }
    return placeOfByte(json, found);
}

JsonPlace placeOfByte(std::string_view text, size_t byte) {
    const std::string_view before = text.substr(0, byte);
    const size_t lineStart = before.rfind('\n') + 1;  // npos + 1 is 0
    return {static_cast<int>(std::count(before.begin(), before.end(), '\n')) + 1,
            static_cast<int>(before.size() - lineStart) + 1};
}

}  // namespace vitrine
