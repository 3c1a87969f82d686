// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <utility>

#include "base/text.hpp"
#include "sdf/limits.hpp"
#include "sdf/parser.hpp"
#include "sdf/words.hpp"

namespace vitrine::glsl {

using Role = SnippetPiece::Role;

namespace {

constexpr std::array<std::pair<std::string_view, ParameterType>, 6> kUniformTypes = {{
    {"float", ParameterType::kFloat},
    {"int", ParameterType::kInt},
    {"bool", ParameterType::kBool},
    {"vec2", ParameterType::kVec2},
    {"vec3", ParameterType::kVec3},
    {"vec4", ParameterType::kVec4},
}};

}  // namespace

void Parser::globalDeclaration() {
    const Token& first = token();
    if (first.is(";")) {
        ++at_;
    } else if (first.is("precision")) {
        skipDeclaration();
    } else if (first.is("uniform")) {
        uniform();
    } else if (first.isWord() && (isShaderInterface(first.text) || first.is("in") ||
                                  first.is("out") || first.is("inout"))) {
        problems_.error(first.place, "'" + first.text +
                                         "' belongs to a whole shader; a snippet has functions, "
                                         "constants and uniforms of its own");
        skipDeclaration();
    } else if (startsDeclaration(at_)) {
        const size_t firstPiece = snippet_.pieces.size();
        const Type type = typeSpecifier();
        const bool named = token().isWord();
        if (named && at_ + 1 < tokens_.size() && tokens_[at_ + 1].is("("))
            return function(type, firstPiece);
        const size_t stop = find(";", at_, tokens_.size() - 1);
        if (stop + 1 == tokens_.size()) {
            problems_.error(first.place, "no ';' ends this declaration");
            at_ = stop;
            return;
        }
        if (at_ < stop) declarators(type, stop);
        copy();
    } else {
        unexpected("a function, a constant or a uniform");
        skipDeclaration();
    }
}

/// To behind the next semicolon or block.
void Parser::skipDeclaration() {
    while (token().kind != TokenKind::kEnd) {
        const bool block = is("{");
        const bool last = is(";");
        at_ = std::max(partner_[at_], at_) + 1;
        if (block && is(";")) ++at_;
        if (block || last) return;
    }
}

/// "uniform float a, b;": nothing of it is emitted.
void Parser::uniform() {
    const Token keyword = token();
    const size_t stop = find(";", at_, tokens_.size() - 1);
    if (stop + 1 == tokens_.size()) {
        problems_.error(keyword.place, "no ';' ends this uniform");
        at_ = stop;
        return;
    }
    const bool hasNote = uniformNote(stop);
    ++at_;
    while (token().isWord() && isQualifier(token().text)) ++at_;
    const Token typeName = token();
    if (at_ < stop) ++at_;
    while (true) {
        const Token name = token();
        if (!typeName.isWord() || !name.isWord()) {
            problems_.error(
                keyword.place,
                "expected a uniform such as: uniform float r; // slider[0.0, 0.5, 1.0]");
            break;
        }
        ++at_;
        if (is("[")) {
            problems_.error(token().place, "a uniform cannot be an array here");
            break;
        }
        if (is("=")) {
            problems_.error(token().place, "the default of a uniform stands behind it: uniform " +
                                               typeName.text + " " + name.text +
                                               "; // slider[min, default, max]");
            break;
        }
        if (at_ < stop && !is(",")) {
            unexpected("',' or ';'");
            break;
        }
        parameter(typeName, name, token().place);
        if (at_ == stop) break;
        ++at_;
    }
    at_ = stop + 1;
    while (hasNote && token().kind != TokenKind::kEnd &&
           token().place.line == tokens_[stop].place.line)
        ++at_;
}

/// Fragmentarium's "uniform float r; slider[0, 1, 2]": an annotation that is no comment.
bool Parser::uniformNote(size_t stop) {
    const Token& first = tokens_[stop + 1];
    const Place end = tokens_[stop].place;
    if (!first.isWord() || first.place.line != end.line || !tokens_[stop + 2].is("[") ||
        tokens_[stop + 2].spaceBefore || isReserved(first.text) || scopes_.find(first.text) ||
        annotationSuggestion(first.text).empty())
        return false;
    const std::vector<std::string_view> lines = splitLines(snippet_.source);
    std::string_view line = lines[static_cast<size_t>(end.line) - 1];
    line = line.substr(std::min(line.size(), static_cast<size_t>(first.place.column) - 1));
    line = line.substr(0, line.find("//"));
    auto annotation = findAnnotation(line, first.place);
    if (annotation) notes_.add(std::move(*annotation));
    return annotation.has_value();
}

void Parser::parameter(const Token& typeName, const Token& name, Place end) {
    const Annotation* annotation = notes_.claim(end);
    const auto type = std::find_if(kUniformTypes.begin(), kUniformTypes.end(),
                                   [&](const auto& t) { return t.first == typeName.text; });
    checkName(name);
    const int index = static_cast<int>(snippet_.parameters.size());
    Symbol symbol{Symbol::Kind::kParameter, name.place, index, 1, {}};
    const Builtin* builtin = findBuiltin(snippet_.kind, name.text);
    if (builtin && !annotation) {
        // Only for programs that know no built-in time; but it must be what they mean.
        if (builtin->type != typeName.text)
            problems_.error(typeName.place,
                            "'" + name.text + "' is built in as a " + std::string(builtin->type));
        symbol.kind = Symbol::Kind::kBuiltin;
        return declareVariable(name, symbol);
    }
    if (type == kUniformTypes.end()) {
        const bool sampler = typeName.text.find("sampler") != std::string::npos;
        problems_.error(typeName.place,
                        sampler ? "snippets have no textures"
                                : "a uniform is a float, int, bool, vec2, vec3 or vec4, not a '" +
                                      printable(typeName.text) + "'");
        return declareVariable(name, symbol);
    }
    declareVariable(name, symbol);
    if (static_cast<int>(snippet_.parameters.size()) == kMaxParameters)
        problems_.error(name.place, "more than " + std::to_string(kMaxParameters) + " uniforms");
    Parameter parameter;
    parameter.name = parameter.label = name.text;
    parameter.type = type->second;
    parameter.group = notes_.group(name.place.line);
    parameter.where = problems_.at(name.place);
    if (parameter.type == ParameterType::kInt) parameter.maximum = glm::vec4(10.0f);
    if (annotation && isControl(annotation->name))
        applyControl(*annotation, parameter, problems_);
    else if (annotation)
        problems_.error(annotation->place, "unknown annotation '" + annotation->name + "'" +
                                               annotationSuggestion(annotation->name));
    else if (parameter.type == ParameterType::kBool)
        parameter.ranged = true;
    else
        problems_.warning(name.place, "'" + name.text + "' has no range; write behind it: " +
                                          "// slider[min, default, max] label");
    snippet_.parameters.push_back(std::move(parameter));
}

void Parser::function(const Type& returnType, size_t firstPiece) {
    const Token name = token();
    checkName(name);
    put(Role::kName, name, name.text);
    ++at_;
    const size_t close = partner_[at_];
    copy();
    scopes_.push();
    std::vector<Argument> list = arguments(close);
    at_ = close;
    copy();
    current_ = declareFunction(name, returnType, std::move(list));
    if (is("{")) {
        if (functions_[current_].defined)
            problems_.error(name.place, "'" + name.text + "' already has a body, on line " +
                                            std::to_string(functions_[current_].place.line));
        functions_[current_].defined = true;
        functions_[current_].place = name.place;
        const size_t end = partner_[at_];
        copy();
        statements(end, 1);
        copy();
        functions_[current_].firstPiece = firstPiece;
        functions_[current_].lastPiece = snippet_.pieces.size();
    } else if (is(";")) {
        copy();
    } else {
        unexpected("'{' and the body of the function");
        skipDeclaration();
    }
    scopes_.pop();
}

/// The parameters of a function, which are declared in the innermost scope.
std::vector<Argument> Parser::arguments(size_t close) {
    std::vector<Argument> list;
    if (at_ + 1 == close && is("void")) {
        copy();
        return list;
    }
    while (at_ < close) {
        Argument argument;
        for (size_t i = at_; i < close && isQualifier(tokens_[i].text); ++i)
            if (tokens_[i].is("out") || tokens_[i].is("inout"))
                argument.direction = tokens_[i].text;
        Type type = typeSpecifier();
        if (at_ < close && token().isWord()) {
            const Token name = token();
            checkName(name);
            put(Role::kName, name, name.text);
            ++at_;
            if (is("[")) arrayLength(type);
            declareVariable(name, {Symbol::Kind::kVariable, name.place, 0, 1, {}});
        } else {
            // Mesa wants a name in every definition. None of a user's begins with a digit.
            Token like = token();
            like.spaceBefore = true;
            put(Role::kName, like, "0p" + std::to_string(list.size()));
        }
        countArray(type, token().place);
        argument.type = type.text + (type.isArray ? "[]" : "");
        list.push_back(std::move(argument));
        if (at_ < close && !is(",")) {
            unexpected("',' or ')'");
            break;
        }
        if (at_ < close) copy();
    }
    return list;
}

size_t Parser::declareFunction(const Token& name, const Type& returnType,
                               std::vector<Argument> list) {
    const Symbol* known = scopes_.findGlobal(name.text);
    if (known && known->kind != Symbol::Kind::kFunction)
        problems_.error(name.place, "'" + name.text + "' is already declared on line " +
                                        std::to_string(known->place.line));
    if (!known && snippet_.libraryFunctions.contains(name.text))
        problems_.error(name.place, "'" + name.text +
                                        "' was called above, where it still meant the function of "
                                        "the library; declare it before its first call");
    scopes_.declareGlobal(name.text, {Symbol::Kind::kFunction, name.place, 0, 1, {}});
    for (size_t i = 0; i < functions_.size(); ++i)
        if (functions_[i].name == name.text && functions_[i].arguments == list) return i;
    functions_.push_back(
        {name.text, returnType.text, std::move(list), name.place, false, {}, {}, 0, 0});
    return functions_.size() - 1;
}

}  // namespace vitrine::glsl
