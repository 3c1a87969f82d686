// SPDX-License-Identifier: MIT
#include "sdf/compile_log.hpp"

#include <charconv>
#include <utility>

#include "base/text.hpp"
#include "sdf/lexer.hpp"

namespace vitrine {

namespace {

/// Takes things off the front of a text; all or nothing.
class Scanner {
  public:
    explicit Scanner(std::string_view text) : rest_(trim(text)) {}

    bool take(std::string_view text) {
        if (!startsWith(rest_, text)) return false;
        rest_.remove_prefix(text.size());
        return true;
    }
    bool take(int& number) {
        const auto [end, error] =
            std::from_chars(rest_.data(), rest_.data() + rest_.size(), number);
        if (error != std::errc{} || number < 0) return false;
        rest_.remove_prefix(static_cast<size_t>(end - rest_.data()));
        return true;
    }
    void skipSpace() { rest_ = trim(rest_); }
    bool takeSeverity(Severity& severity) {
        for (const char* word : {"error", "ERROR", "fatal error"})
            if (take(word)) return severity = Severity::kError, true;
        for (const char* word : {"warning", "WARNING"})
            if (take(word)) return severity = Severity::kWarning, true;
        return false;
    }
    [[nodiscard]] std::string rest() const { return std::string(trim(rest_)); }

  private:
    std::string_view rest_;
};

/// "0:12(7): error: text" and "0(12) : error C1008: text"
bool placeFirst(std::string_view line, CompileMessage& message) {
    Scanner scanner(line);
    if (!scanner.take(message.source)) return false;
    if (scanner.take(":")) {
        if (!scanner.take(message.line)) return false;
        if (scanner.take("(") && !(scanner.take(message.column) && scanner.take(")"))) return false;
    } else if (!(scanner.take("(") && scanner.take(message.line) && scanner.take(")"))) {
        return false;
    }
    scanner.skipSpace();
    if (!scanner.take(":")) return false;
    scanner.skipSpace();
    if (!scanner.takeSeverity(message.severity)) return false;
    // NVIDIA's message number.
    scanner.skipSpace();
    int number = 0;
    Scanner numbered = scanner;
    if (numbered.take("C") && numbered.take(number)) scanner = numbered;
    if (!scanner.take(":")) return false;
    message.message = scanner.rest();
    return true;
}

/// "ERROR: 0:12: text"
bool severityFirst(std::string_view line, CompileMessage& message) {
    Scanner scanner(line);
    if (!scanner.takeSeverity(message.severity) || !scanner.take(":")) return false;
    scanner.skipSpace();
    if (!scanner.take(message.source) || !scanner.take(":") || !scanner.take(message.line) ||
        !scanner.take(":"))
        return false;
    message.message = scanner.rest();
    return true;
}

bool isWordPart(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

/// The name that a user knows: without the prefix of whichever snippet it belongs to.
std::string userName(std::string_view word, std::span<const SnippetInProgram> snippets) {
    for (const SnippetInProgram& part : snippets) {
        const std::string& prefix = part.options->prefix;
        if (!startsWith(word, prefix) || word.size() == prefix.size()) continue;
        word.remove_prefix(prefix.size());
        if (startsWith(word, "0_")) word.remove_prefix(1);
        break;
    }
    return std::string(word);
}

/// The message in the user's names, and all words of it.
std::pair<std::string, std::vector<std::string>> inUserNames(
    std::string_view message, std::span<const SnippetInProgram> snippets) {
    std::pair<std::string, std::vector<std::string>> result;
    for (size_t i = 0; i < message.size();) {
        size_t end = i;
        while (end < message.size() && isWordPart(message[end])) ++end;
        if (end == i) {
            result.first += message[i++];
            continue;
        }
        result.second.push_back(userName(message.substr(i, end - i), snippets));
        result.first += result.second.back();
        i = end;
    }
    return result;
}

/// Where on `line` the first of the `words` stands that is there at all; if none is, where the
/// line's text begins; 0 on an empty line.
int columnOf(const Snippet& snippet, int line, const std::vector<std::string>& words) {
    const glsl::LexedText lexed = glsl::lex(snippet.source);
    int first = 0;
    for (const std::string& word : words) {
        for (const glsl::Token& token : lexed.tokens) {
            if (token.place.line != line || token.kind == glsl::TokenKind::kEnd) continue;
            if (first == 0) first = token.place.column;
            if (token.isWord() && token.text == word) return token.place.column;
        }
    }
    return first;
}

}  // namespace

std::vector<CompileMessage> parseCompileLog(std::string_view log) {
    std::vector<CompileMessage> messages;
    for (const std::string_view line : splitLines(log)) {
        for (const auto parse : {placeFirst, severityFirst}) {
            CompileMessage message;
            if (!parse(line, message)) continue;
            messages.push_back(std::move(message));
            break;
        }
    }
    return messages;
}

std::optional<SnippetLine> mapToSnippet(int line, std::span<const int> lineBases) {
    for (size_t i = 0; i < lineBases.size(); ++i)
        if (line > lineBases[i] && line - lineBases[i] < kLinesPerSnippet)
            return SnippetLine{static_cast<int>(i), line - lineBases[i]};
    return {};
}

std::optional<Diagnostic> explainMessage(const CompileMessage& message,
                                         std::span<const SnippetInProgram> snippets) {
    std::vector<int> bases;
    for (const SnippetInProgram& part : snippets) bases.push_back(part.options->lineBase);
    const auto at = mapToSnippet(message.line, bases);
    if (!at) return {};
    const SnippetInProgram& part = snippets[static_cast<size_t>(at->snippet)];
    const auto [text, words] = inUserNames(message.message, snippets);
    const int column = message.column > 0
                           ? originalColumn(*part.snippet, *part.options, at->line, message.column)
                           : columnOf(*part.snippet, at->line, words);
    return Diagnostic{message.severity, {part.snippet->file, at->line, column}, text};
}

}  // namespace vitrine
