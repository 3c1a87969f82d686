// SPDX-License-Identifier: MIT
// Finds what a snippet declares and what each of its names means, and bounds its loops.
//
// This is no GLSL compiler: it follows declarations, statements and scopes exactly, because names
// and loops depend on them, and passes expressions on token by token. What it lets through and the
// language does not is found by the GLSL compiler, on the same line.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "sdf/kinds.hpp"
#include "sdf/library.hpp"
#include "sdf/problems.hpp"
#include "sdf/scope.hpp"
#include "sdf/snippet.hpp"
#include "sdf/token.hpp"
#include "sdf/uniform_notes.hpp"

namespace vitrine::glsl {

class Parser {
  public:
    /// `partner` as from matchBrackets. Fills the parameters and pieces of `snippet`.
    Parser(const Tokens& tokens, const std::vector<size_t>& partner, UniformNotes& notes,
           const Library& library, Snippet& snippet, Problems& problems);

    void run();
    [[nodiscard]] const std::vector<Function>& functions() const { return functions_; }

  private:
    struct Type {
        std::string text;
        int size = 1;         // floats
        int arrayLength = 0;  // 0: no array, or one whose initial value gives the length
        bool isArray = false;
        bool isConst = false;
    };

    // parser.cpp: walking, names, types
    [[nodiscard]] const Token& token() const { return tokens_[at_]; }
    [[nodiscard]] bool is(std::string_view text) const { return tokens_[at_].is(text); }
    [[nodiscard]] size_t find(std::string_view text, size_t from, size_t end) const;
    void copy();
    void put(SnippetPiece::Role role, const Token& like, std::string text, int index = 0);
    void expect(std::string_view text, const char* purpose);
    void unexpected(const char* wanted);
    void checkWords();
    void checkName(const Token& name);
    [[nodiscard]] bool startsDeclaration(size_t at) const;
    Type typeSpecifier();
    void structSpecifier(Type& type);
    void arrayLength(Type& type);
    void countArray(const Type& type, Place place);
    void declarators(const Type& type, size_t stop);
    void declareVariable(const Token& name, Symbol symbol);

    // parser_global.cpp: what stands outside of functions
    void uniform();
    bool uniformNote(size_t stop);
    void parameter(const Token& typeName, const Token& name, Place end);
    void skipDeclaration();
    void globalDeclaration();
    void function(const Type& returnType, size_t firstPiece);
    std::vector<Argument> arguments(size_t close);
    size_t declareFunction(const Token& name, const Type& returnType, std::vector<Argument> list);

    // parser_statement.cpp: what stands inside
    void statements(size_t end, int depth);
    void statement(size_t end, int depth);
    void scopedStatement(size_t end, int depth);
    void simpleStatement(size_t end);
    void parenthesised();
    void ifStatement(size_t end, int depth);
    void forStatement(size_t end, int depth);
    void whileStatement(size_t end, int depth);
    void doStatement(size_t end, int depth);
    void guardedCondition(size_t close);
    void caseLabel(size_t end);
    void expression(size_t end);

    // parser_name.cpp: what a word in an expression means
    void name();
    void builtinVariable(const Token& word, const Builtin& builtin);
    void call(const Token& name, const Symbol* symbol);
    void foreignCall(const Token& name, size_t count);
    [[nodiscard]] size_t countArguments(size_t open) const;
    void reportUnknown(const Token& word, bool isCall);

    const Tokens& tokens_;
    const std::vector<size_t>& partner_;
    UniformNotes& notes_;
    const Library& library_;
    Snippet& snippet_;
    Problems& problems_;
    size_t at_ = 0;
    Scopes scopes_;
    std::vector<Function> functions_;
    size_t current_ = 0;  // the function whose body is read
    int arrayFloats_ = 0;
    std::set<std::string> reported_;
};

}  // namespace vitrine::glsl
