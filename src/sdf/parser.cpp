// SPDX-License-Identifier: MIT
#include "sdf/parser.hpp"

#include <algorithm>
#include <optional>
#include <span>
#include <utility>

#include "base/text.hpp"
#include "sdf/constant.hpp"
#include "sdf/limits.hpp"
#include "sdf/words.hpp"

namespace vitrine::glsl {

using Role = SnippetPiece::Role;

Parser::Parser(const Tokens& tokens, const std::vector<size_t>& partner, UniformNotes& notes,
               const Library& library, Snippet& snippet, Problems& problems)
    : tokens_(tokens),
      partner_(partner),
      notes_(notes),
      library_(library),
      snippet_(snippet),
      problems_(problems) {}

void Parser::run() {
    checkWords();
    while (token().kind != TokenKind::kEnd) globalDeclaration();
    notes_.reportUnclaimed(problems_);
    size_t defined = 0;
    for (const Function& function : functions_) defined += function.defined ? 1 : 0;
    if (defined > kMaxFunctions)
        problems_.error({1, 1}, std::to_string(defined) + " functions; at most " +
                                    std::to_string(kMaxFunctions) +
                                    " are compiled in bearable time");
}

/// The next `text` that is not inside of brackets; `end` if there is none.
size_t Parser::find(std::string_view text, size_t from, size_t end) const {
    for (size_t i = from; i < end; i = std::max(partner_[i], i) + 1)
        if (tokens_[i].is(text)) return i;
    return end;
}

void Parser::copy() {
    put(Role::kText, token(), token().text);
    ++at_;
}

void Parser::put(Role role, const Token& like, std::string text, int index) {
    snippet_.pieces.push_back({role, std::move(text), index, like.place.line, like.place.column,
                               like.spaceBefore || like.startsLine});
}

void Parser::expect(std::string_view text, const char* purpose) {
    if (is(text))
        copy();
    else
        unexpected(purpose);
}

void Parser::unexpected(const char* wanted) {
    const std::string found = token().kind == TokenKind::kEnd ? "the end of the file"
                                                              : "'" + printable(token().text) + "'";
    problems_.error(token().place, "expected " + std::string(wanted) + ", found " + found);
}

/// What no word may look like, wherever it stands.
void Parser::checkWords() {
    for (const Token& word : tokens_) {
        if (!word.isWord()) continue;
        const bool reserved = word.text.find("__") != std::string::npos;
        if (!reserved && word.text.size() <= kMaxNameLength) continue;
        if (!reported_.insert(word.text).second) continue;
        problems_.error(word.place, reserved ? "'" + printable(word.text) +
                                                   "': two underscores in a "
                                                   "row are reserved in GLSL"
                                             : "a name of " + std::to_string(word.text.size()) +
                                                   " characters; at most " +
                                                   std::to_string(kMaxNameLength) + " are allowed");
    }
}

/// For a name that is being declared.
void Parser::checkName(const Token& name) {
    if (isReserved(name.text))
        problems_.error(name.place, "'" + name.text + "' is a word of GLSL and cannot be a name");
    if (startsWith(name.text, "gl_"))
        problems_.error(name.place,
                        "'" + printable(name.text) + "': names that begin with gl_ are reserved");
}

/// No expression holds two words in a row, so "T name" and "T[3] name" are declarations.
bool Parser::startsDeclaration(size_t at) const {
    const auto word = [&](size_t i) {
        return i < tokens_.size() && tokens_[i].isWord() && !isStatementWord(tokens_[i].text);
    };
    if (!word(at)) return false;
    if (isQualifier(tokens_[at].text) || tokens_[at].is("struct")) return true;
    size_t next = at + 1;
    while (next < tokens_.size() && tokens_[next].is("[")) next = partner_[next] + 1;
    return word(next);
}

/// Qualifiers, the name of a type or a struct, and "[n]".
Parser::Type Parser::typeSpecifier() {
    Type type;
    for (; token().isWord() && isQualifier(token().text); copy())
        type.isConst = type.isConst || is("const");
    if (is("struct")) {
        structSpecifier(type);
    } else if (!token().isWord() || isStatementWord(token().text)) {
        unexpected("a type");
        if (token().isWord()) ++at_;
    } else {
        type.text = token().text;
        const Symbol* symbol = scopes_.find(type.text);
        const bool own = symbol && symbol->kind == Symbol::Kind::kStruct;
        type.size = own ? symbol->size : std::max(1, builtinTypeSize(type.text));
        put(own ? Role::kName : Role::kText, token(), token().text);
        ++at_;
    }
    if (is("[")) arrayLength(type);
    return type;
}

void Parser::structSpecifier(Type& type) {
    copy();
    if (!token().isWord()) return unexpected("the name of the struct");
    const Token name = token();
    checkName(name);
    put(Role::kName, name, name.text);
    ++at_;
    if (!is("{")) return unexpected("'{'");
    const size_t close = partner_[at_];
    copy();
    int size = 0;
    while (at_ < close) {
        Type field = typeSpecifier();
        const size_t stop = find(";", at_, close);
        while (at_ < stop && token().isWord()) {
            checkName(token());
            Type own = field;
            copy();
            if (is("[")) arrayLength(own);
            size = std::min(size + own.size * std::max(1, own.arrayLength), kMaxArrayFloats + 1);
            if (is(",")) copy();
        }
        if (at_ == stop && stop < close) {
            copy();
            continue;
        }
        unexpected("a field such as 'float x;'");
        at_ = close;
    }
    copy();
    type.text = name.text;
    type.size = std::max(1, size);
    declareVariable(name, {Symbol::Kind::kStruct, name.place, 0, type.size, {}});
}

/// "[n]", where n must be a number that can be told here: a compiler would spend minutes on 2^28.
void Parser::arrayLength(Type& type) {
    const Token open = token();
    const size_t close = partner_[at_];
    if (type.isArray) problems_.error(open.place, "arrays of arrays do not exist in WebGL2");
    type.isArray = true;
    copy();
    if (at_ < close) {
        const auto valueOf = [&](const Token& name) {
            const Symbol* symbol = scopes_.find(name.text);
            return symbol ? symbol->value : std::nullopt;
        };
        const auto length = evaluateConstant(std::span(tokens_).subspan(at_, close - at_), valueOf);
        if (!length)
            problems_.error(token().place,
                            "the length of an array must be a whole number or made of const ints");
        else if (*length < 1 || *length > kMaxArrayLength)
            problems_.error(token().place, "an array of " + std::to_string(*length) +
                                               "; the length lies between 1 and " +
                                               std::to_string(kMaxArrayLength));
        else
            type.arrayLength = static_cast<int>(*length);
        expression(close);
    }
    copy();
    if (is("[")) {
        problems_.error(token().place, "arrays of arrays do not exist in WebGL2");
        while (is("[")) at_ = partner_[at_] + 1;
    }
}

void Parser::countArray(const Type& type, Place place) {
    constexpr int kLargestBuiltin = 16;
    if (type.arrayLength == 0 && type.size <= kLargestBuiltin) return;
    const bool wasWithin = arrayFloats_ <= kMaxArrayFloats;
    arrayFloats_ =
        std::min(arrayFloats_ + type.size * std::max(1, type.arrayLength), kMaxArrayFloats + 1);
    if (wasWithin && arrayFloats_ > kMaxArrayFloats)
        problems_.error(place, "more than " + std::to_string(kMaxArrayFloats) +
                                   " numbers in arrays: no compiler would survive it");
}

/// "a, b[2], c = 1;" with the semicolon at `stop`.
void Parser::declarators(const Type& type, size_t stop) {
    for (bool more = true; more;) {
        if (!token().isWord() || at_ >= stop) {
            unexpected("a name");
            break;
        }
        const Token name = token();
        checkName(name);
        put(Role::kName, name, name.text);
        ++at_;
        Type own = type;
        if (is("[")) arrayLength(own);
        Symbol symbol{Symbol::Kind::kVariable, name.place, 0, 1, {}};
        if (is("=")) {
            copy();
            const size_t end = find(",", at_, stop);
            if (own.isConst && own.text == "int" && !own.isArray) {
                const auto valueOf = [&](const Token& word) {
                    const Symbol* known = scopes_.find(word.text);
                    return known ? known->value : std::nullopt;
                };
                symbol.value =
                    evaluateConstant(std::span(tokens_).subspan(at_, end - at_), valueOf);
            }
            expression(end);
        }
        // Only now: the initial value still means the outer variable of that name.
        declareVariable(name, symbol);
        countArray(own, name.place);
        more = at_ < stop && is(",");
        if (more)
            copy();
        else if (at_ < stop)
            unexpected("',' or ';'");
    }
    at_ = stop;
}

void Parser::declareVariable(const Token& name, Symbol symbol) {
    const Symbol* known = scopes_.global() ? scopes_.find(name.text) : nullptr;
    if (known)
        problems_.error(name.place, "'" + name.text + "' is already declared on line " +
                                        std::to_string(known->place.line));
    scopes_.declare(name.text, symbol);
}

}  // namespace vitrine::glsl
