// SPDX-License-Identifier: MIT
#include "sdf/annotation.hpp"

#include <algorithm>

#include "base/text.hpp"

namespace vitrine::glsl {

namespace {

bool isLetter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
bool isNameCharacter(char c) {
    return isLetter(c) || (c >= '0' && c <= '9') || c == '-';
}

/// Walks over one line of text and knows where it is in the file.
class Reader {
  public:
    Reader(std::string_view text, Place start) : text_(text), start_(start) {}

    [[nodiscard]] Place place() const {
        return {start_.line, start_.column + static_cast<int>(at_)};
    }
    [[nodiscard]] bool done() const { return at_ >= text_.size() || text_[at_] == '\n'; }
    [[nodiscard]] char current() const { return done() ? '\0' : text_[at_]; }
    void skip() { ++at_; }
    void skipSpace() {
        while (!done() && (current() == ' ' || current() == '\t' || current() == '\r')) skip();
    }
    template <class Predicate>
    std::string take(Predicate belongs) {
        std::string taken;
        for (; !done() && belongs(current()); skip()) taken += current();
        return taken;
    }
    [[nodiscard]] std::string_view rest() const {
        return done() ? std::string_view{} : text_.substr(at_, text_.find('\n', at_) - at_);
    }

  private:
    std::string_view text_;
    Place start_;
    size_t at_ = 0;
};

bool endsWord(char c) {
    return c == ',' || c == ']' || c == '(' || c == ')';
}

AnnotationValue readValue(Reader& reader) {
    AnnotationValue value;
    reader.skipSpace();
    value.place = reader.place();
    const auto word = [&] {
        return printable(trim(reader.take([](char c) { return !endsWord(c); })));
    };
    if (reader.current() != '(') {
        value.words.push_back(word());
        return value;
    }
    value.inParentheses = true;
    do {
        reader.skip();
        value.words.push_back(word());
    } while (reader.current() == ',');
    if (reader.current() == ')') reader.skip();
    reader.skipSpace();
    return value;
}

}  // namespace

std::optional<Annotation> findAnnotation(std::string_view text, Place place) {
    Reader reader(text, place);
    if (reader.current() == '!') reader.skip();
    reader.skipSpace();
    Annotation annotation;
    annotation.place = reader.place();
    annotation.name = reader.take(isLetter);
    if (annotation.name.empty() || reader.current() != '[') return {};
    do {
        reader.skip();
        annotation.values.push_back(readValue(reader));
    } while (reader.current() == ',');
    annotation.closed = reader.current() == ']';
    if (annotation.closed) reader.skip();
    // A block comment may go on: the label ends with its first line.
    annotation.label = printable(trim(reader.rest()));
    return annotation;
}

std::optional<std::string> findGroup(const Comment& comment) {
    const std::string_view text = trim(
        splitLines(comment.text).empty() ? std::string_view{} : splitLines(comment.text).front());
    const auto between = [](std::string_view s, std::string_view open, char close) {
        if (!startsWith(s, open) || s.find(close, open.size()) == std::string_view::npos)
            return std::string{};
        s.remove_prefix(open.size());
        return printable(trim(s.substr(0, s.find(close))));
    };
    for (const std::string& name :
         {between(text, "group[", ']'), between(text, "! <group name=\"", '"')})
        if (!name.empty()) return name;
    if (startsWith(text, "#group ")) return printable(trim(text.substr(7)));
    if (!comment.startsLine || !startsWith(text, "group ")) return {};
    const std::string_view name = trim(text.substr(6));
    if (name.empty() || !std::all_of(name.begin(), name.end(), isNameCharacter)) return {};
    return std::string(name);
}

}  // namespace vitrine::glsl
