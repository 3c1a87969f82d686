// SPDX-License-Identifier: MIT
#include "scene/edit_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/text.hpp"
#include "scene/document.hpp"

namespace vitrine {
namespace {

/// A place between two characters of a text; columns count code points from 1.
class Cursor {
  public:
    explicit Cursor(std::string_view text) : text_(text) {
        starts_.push_back(0);
        for (size_t i = 0; i < text.size(); ++i)
            if (text[i] == '\n') starts_.push_back(i + 1);
    }
    [[nodiscard]] size_t offset(toml::source_position at) const {
        size_t i = starts_[std::min<size_t>(at.line, starts_.size()) - 1];
        for (unsigned column = 1; column < at.column && i < text_.size(); ++column) {
            ++i;
            while (i < text_.size() && (static_cast<unsigned char>(text_[i]) & 0xc0) == 0x80) ++i;
        }
        return i;
    }
    /// Behind the end of the line that holds `at`.
    [[nodiscard]] size_t lineEnd(size_t at) const {
        const size_t end = text_.find('\n', at);
        return end == std::string_view::npos ? text_.size() : end + 1;
    }
    [[nodiscard]] size_t lineStart(size_t at) const {
        const size_t before = at == 0 ? std::string_view::npos : text_.rfind('\n', at - 1);
        return before == std::string_view::npos ? 0 : before + 1;
    }

  private:
    std::string_view text_;
    std::vector<size_t> starts_;
};

bool isListOfTables(const toml::node& node) {
    return node.is_array() && node.as_array()->is_array_of_tables();
}

/// Whether a value stands on lines of its table's own, and not under a header of its own.
bool isInline(const toml::node& value) {
    if (const toml::table* table = value.as_table()) return table->is_inline();
    if (!isListOfTables(value)) return true;
    const toml::array& list = *value.as_array();
    return list.empty() || list[0].as_table()->is_inline();
}

/// The last value written in a table itself; null if there is none.
const toml::node* lastValue(const toml::table& table) {
    const toml::node* last = nullptr;
    for (const auto& [key, value] : table) {
        if (!isInline(value) || value.source().begin.line == 0) continue;
        if (last == nullptr || last->source().end < value.source().end) last = &value;
    }
    return last;
}

std::string keyText(const std::string& key) {
    const bool bare = std::all_of(key.begin(), key.end(), [](unsigned char c) {
        return std::isalnum(c) != 0 || c == '_' || c == '-';
    });
    return bare && !key.empty() ? key : fmt::format("\"{}\"", key);
}

struct Splice {
    size_t begin, end;
    std::string with;
};

/// Where `words` (of which `used` led to `table`) has its value, and what to put there.
Splice spliceFor(const std::string& text, const toml::table& table,
                 const std::vector<std::string>& words, size_t used, const std::string& value) {
    const Cursor cursor(text);
    const toml::table* at = &table;
    while (used + 1 < words.size()) {
        const toml::node* next = at->get(words[used]);
        if (next == nullptr || !next->is_table()) break;
        at = next->as_table();
        ++used;
    }
    if (used + 1 == words.size())
        if (const toml::node* old = at->get(words[used]))
            return {cursor.offset(old->source().begin), cursor.offset(old->source().end), value};
    // A table that is not there yet is written inline: { a = { b = value } }.
    std::string assignment = value;
    for (size_t i = words.size(); i-- > used + 1;)
        assignment = fmt::format("{{ {} = {} }}", keyText(words[i]), assignment);
    assignment = fmt::format("{} = {}", keyText(words[used]), assignment);

    const toml::node* last = lastValue(*at);
    if (at->is_inline()) {
        if (last == nullptr) {
            const size_t brace = cursor.offset(at->source().begin) + 1;
            return {brace, cursor.offset(at->source().end) - 1, fmt::format(" {} ", assignment)};
        }
        const size_t end = cursor.offset(last->source().end);
        return {end, end, ", " + assignment};
    }
    const size_t near = cursor.offset(last != nullptr ? last->source().end : at->source().end);
    const size_t end = cursor.lineEnd(near);
    std::string indent;
    if (last != nullptr) {
        const std::string_view line =
            std::string_view(text).substr(cursor.lineStart(cursor.offset(last->source().begin)));
        indent = line.substr(0, std::min(line.find_first_not_of(" \t"), line.size()));
    }
    const bool ended = end > 0 && text[end - 1] == '\n';
    return {end, end, fmt::format("{}{}{}\n", ended ? "" : "\n", indent, assignment)};
}

/// Text with one assignment in it; empty if that is not possible.
std::string edited(const std::string& text, const std::string& file, const std::string& assignment,
                   Diagnostics& diagnostics) {
    Diagnostics problems;
    std::optional<toml::table> document = parseDocument(text, file, problems);
    std::optional<toml::table> wanted = parseDocument(text, file, problems);
    if (!document || !wanted) {
        diagnostics.append(problems);
        return {};
    }
    applyOverride(*wanted, assignment, problems);
    if (problems.hasErrors()) {
        diagnostics.append(problems);
        return {};
    }
    if (*document == *wanted) return text;
    const std::optional<Target> target = findTarget(*document, assignment);
    std::string result = text;
    if (!target) {
        const std::vector<std::string> words = overrideWords(assignment);
        const bool ended = text.empty() || text.back() == '\n';
        result += fmt::format("{}\n[{}]\n{} = {}\n", ended ? "" : "\n", keyText(words[0]),
                              keyText(words[1]), overrideValue(assignment));
    } else {
        const Splice splice =
            spliceFor(text, *target->table, target->words, target->used, overrideValue(assignment));
        result.replace(splice.begin, splice.end - splice.begin, splice.with);
    }
    const std::optional<toml::table> got = parseDocument(result, file, problems);
    if (got && *got == *wanted) return result;
    diagnostics.error({file}, fmt::format("'{}' cannot be written into the file", assignment));
    return {};
}

}  // namespace

std::string editSceneText(std::string_view text, const std::string& file,
                          const std::vector<std::string>& assignments, Diagnostics& diagnostics) {
    std::string result(text);
    for (const std::string& assignment : assignments) {
        std::string next = edited(result, file, assignment, diagnostics);
        if (!next.empty()) result = std::move(next);
    }
    return result;
}

}  // namespace vitrine
