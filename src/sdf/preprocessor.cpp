// SPDX-License-Identifier: MIT
#include "sdf/preprocessor.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <utility>

#include "base/text.hpp"
#include "sdf/constant.hpp"
#include "sdf/limits.hpp"
#include "sdf/macro.hpp"

namespace vitrine::glsl {

namespace {

using Line = std::span<const Token>;

/// One #if ... #endif that is open.
struct Conditional {
    Place place;
    bool outer = true;   // what surrounds it is active
    bool taken = false;  // one of its branches has been
    bool active = false;
    bool sawElse = false;
};

struct Refusal {
    std::string_view directive;
    std::string_view reason;
};

constexpr std::array<Refusal, 10> kRefusals = {{
    {"version",
     "the renderer chooses the version; for other programs, put it inside of #ifndef VITRINE"},
    {"extension", "a snippet has to run everywhere, without extensions"},
    {"include", "a snippet is one file: paste the text here; shaders/lib/sdf is there without it"},
    {"line", "the renderer counts the lines"},
    {"pragma", "the renderer sets them"},
    {"iUniform", "write: uniform float NAME; // slider[min, default, max] label"},
    {"preset", "presets belong in a scene file, as set = { NAME = value }"},
    {"endpreset", "presets belong in a scene file, as set = { NAME = value }"},
    {"info", "write it as a comment"},
    {"camera", "cameras belong in a scene file"},
}};

bool sameBody(const Macro& a, const Macro& b) {
    return a.parameters == b.parameters &&
           std::equal(a.body.begin(), a.body.end(), b.body.begin(), b.body.end(),
                      [](const Token& x, const Token& y) { return x.text == y.text; });
}

class Preprocessor {
  public:
    Preprocessor(LexedText text, Problems& problems)
        : text_(std::move(text)), problems_(problems), expander_(macros_, problems) {
        predefine("VITRINE", "1");
        predefine("__VERSION__", "300");
    }

    Preprocessed run() {
        const Tokens& tokens = text_.tokens;
        size_t at = 0;
        while (at + 1 < tokens.size() && !result_.abandoned) {
            if (tokens[at].startsLine && tokens[at].is("#")) {
                flush();
                const size_t first = at++;
                while (!tokens[at].startsLine && tokens[at].kind != TokenKind::kEnd) ++at;
                directive(tokens[first], Line(tokens).subspan(first + 1, at - first - 1));
            } else {
                if (active()) text(tokens[at]);
                ++at;
            }
        }
        flush();
        result_.tokens.push_back(tokens.back());
        for (const Conditional& open : conditionals_)
            problems_.error(open.place, "no #endif closes this");
        setActive(true, tokens.back().place.line + 1);
        keepActiveComments();
        return std::move(result_);
    }

  private:
    void predefine(const std::string& name, const std::string& value) {
        Token number;
        number.kind = TokenKind::kNumber;
        number.text = value;
        macros_[name] = {{}, {number}, {}};
    }

    [[nodiscard]] bool active() const {
        return conditionals_.empty() || conditionals_.back().active;
    }

    void text(const Token& token) {
        if (token.kind != TokenKind::kOther) {
            pending_.push_back(token);
            return;
        }
        const bool nul = token.text == std::string(1, '\0');
        const bool ascii = static_cast<unsigned char>(token.text[0]) < 0x80;
        problems_.error(token.place,
                        nul     ? "a NUL byte: this is not a text file"
                        : ascii ? "GLSL has no '" + printable(token.text) + "'"
                                : "'" + printable(token.text) +
                                      "' is not ASCII, which GLSL allows only in comments");
    }

    /// Expands the text since the last # line.
    void flush() {
        if (pending_.empty()) return;
        std::optional<Tokens> expanded = expander_.expand(pending_);
        pending_.clear();
        if (!expanded) {
            result_.abandoned = true;
            return;
        }
        result_.tokens.insert(result_.tokens.end(), expanded->begin(), expanded->end());
    }

    void directive(const Token& hash, Line line) {
        if (line.empty()) return;
        const std::string& name = line[0].text;
        const Line rest = line.subspan(1);
        if (name == "if" || name == "ifdef" || name == "ifndef") {
            const bool value = active() && condition(name, hash.place, rest);
            conditionals_.push_back({hash.place, active(), value, value, false});
            setActive(active(), hash.place.line);
        } else if (name == "elif" || name == "else" || name == "endif") {
            continueConditional(name, hash.place, rest);
        } else if (active()) {
            activeDirective(name, hash.place, rest);
        }
    }

    void continueConditional(const std::string& name, Place place, Line rest) {
        if (conditionals_.empty()) {
            problems_.error(place, "#" + name + " without #if");
            return;
        }
        Conditional& open = conditionals_.back();
        if (name == "endif") {
            conditionals_.pop_back();
        } else if (open.sawElse) {
            problems_.error(place, "#" + name + " after #else");
        } else {
            open.sawElse = name == "else";
            open.active =
                open.outer && !open.taken && (open.sawElse || condition("if", place, rest));
            open.taken = open.taken || open.active;
        }
        setActive(active(), place.line);
    }

    /// Remembers which lines are skipped: annotations in there must not count.
    void setActive(bool isActive, int line) {
        if (isActive == skippedFrom_.has_value()) {
            if (isActive)
                skipped_.emplace_back(*std::exchange(skippedFrom_, std::nullopt), line);
            else
                skippedFrom_ = line;
        }
    }

    void keepActiveComments() {
        for (Comment& comment : text_.comments) {
            const int line = comment.place.line;
            const bool skip = std::any_of(skipped_.begin(), skipped_.end(), [&](const auto& range) {
                return line > range.first && line < range.second;
            });
            if (!skip) result_.comments.push_back(std::move(comment));
        }
    }

    bool condition(const std::string& directive, Place place, Line rest) {
        if (directive != "if") {
            if (rest.empty() || !rest[0].isWord()) {
                problems_.error(place, "#" + directive + " needs a name");
                return false;
            }
            return macros_.contains(rest[0].text) == (directive == "ifdef");
        }
        const std::optional<Tokens> expanded = expander_.expand(withoutDefined(rest));
        if (!expanded) {
            result_.abandoned = true;
            return false;
        }
        const auto undefined = [&](const Token& name) {
            problems_.warning(name.place, "'" + name.text + "' is not defined and counts as 0");
            return std::optional<int64_t>(0);
        };
        const std::optional<int64_t> value = evaluateConstant(*expanded, undefined);
        if (!value) problems_.error(place, "the condition is no integer expression");
        return value.value_or(0) != 0;
    }

    /// "defined X" and "defined(X)" become 1 or 0 before X is expanded.
    Tokens withoutDefined(Line line) const {
        Tokens result;
        for (size_t i = 0; i < line.size(); ++i) {
            result.push_back(line[i]);
            if (!line[i].is("defined")) continue;
            const bool brackets = i + 3 < line.size() && line[i + 1].is("(") && line[i + 3].is(")");
            const size_t name = i + (brackets ? 2 : 1);
            if (name >= line.size() || !line[name].isWord()) continue;
            result.back().kind = TokenKind::kNumber;
            result.back().text = macros_.contains(line[name].text) ? "1" : "0";
            i = name + (brackets ? 1 : 0);
        }
        return result;
    }

    void activeDirective(const std::string& name, Place place, Line rest) {
        if (name == "define") {
            define(place, rest);
        } else if (name == "undef") {
            if (rest.empty() || !rest[0].isWord())
                problems_.error(place, "#undef needs a name");
            else
                macros_.erase(rest[0].text);
        } else if (name == "group") {
            result_.groups.push_back({place.line, joined(rest)});
        } else if (name == "error") {
            problems_.error(place, "#error " + joined(rest));
        } else {
            refuse(name, place);
        }
    }

    void refuse(const std::string& name, Place place) {
        const std::string quoted = "#" + printable(name);
        for (const Refusal& refusal : kRefusals) {
            if (refusal.directive != name) continue;
            problems_.error(place, quoted + " is not for snippets: " + std::string(refusal.reason));
            return;
        }
        static const std::vector<std::string> kKnown = {
            "define", "undef", "if", "ifdef", "ifndef", "elif", "else", "endif", "group"};
        problems_.error(place, "unknown directive " + quoted + didYouMean(name, kKnown));
    }

    static std::string joined(Line line) {
        std::string result;
        for (const Token& token : line) {
            if (!result.empty() && token.spaceBefore) result += ' ';
            result += token.text;
        }
        return printable(result);
    }

    void define(Place place, Line rest) {
        if (rest.empty() || !rest[0].isWord()) {
            problems_.error(place, "#define needs a name");
            return;
        }
        const Token& name = rest[0];
        if (name.text == "defined" || startsWith(name.text, "GL_") ||
            startsWith(name.text, "gl_") || name.text.find("__") != std::string::npos) {
            problems_.error(name.place, "the name '" + printable(name.text) + "' is reserved");
            return;
        }
        Macro macro{{}, {}, name.place};
        size_t at = 1;
        if (at < rest.size() && rest[at].is("(") && !rest[at].spaceBefore &&
            !macroParameters(rest, at, macro))
            return;
        for (; at < rest.size(); ++at) {
            if (rest[at].is("#") || rest[at].is("##")) {
                problems_.error(rest[at].place, "GLSL has no '" + rest[at].text + "' in macros");
                return;
            }
            if (rest[at].kind == TokenKind::kOther) {
                text(rest[at]);
                return;
            }
            macro.body.push_back(rest[at]);
        }
        const auto [known, isNew] = macros_.emplace(name.text, macro);
        if (!isNew && !sameBody(known->second, macro))
            problems_.error(name.place, "macro '" + name.text + "' is already defined on line " +
                                            std::to_string(known->second.place.line) +
                                            "; #undef it first");
    }

    /// Reads "(a, b)" at `at` and moves behind it.
    bool macroParameters(Line rest, size_t& at, Macro& macro) {
        macro.parameters.emplace();
        ++at;
        if (at < rest.size() && rest[at].is(")")) {
            ++at;
            return true;
        }
        for (bool last = false; !last; at += 2) {
            if (at + 1 >= rest.size() || !rest[at].isWord() ||
                !(rest[at + 1].is(",") || rest[at + 1].is(")"))) {
                problems_.error(rest[std::min(at, rest.size() - 1)].place,
                                "the parameters of a macro are names, as in #define F(a, b)");
                return false;
            }
            macro.parameters->push_back(rest[at].text);
            last = rest[at + 1].is(")");
        }
        return true;
    }

    LexedText text_;
    Problems& problems_;
    Macros macros_;
    Expander expander_;
    Preprocessed result_;
    Tokens pending_;
    std::vector<Conditional> conditionals_;
    std::vector<std::pair<int, int>> skipped_;  // lines between the two, both exclusive
    std::optional<int> skippedFrom_;
};

}  // namespace

Preprocessed preprocess(LexedText text, Problems& problems) {
    return Preprocessor(std::move(text), problems).run();
}

}  // namespace vitrine::glsl
