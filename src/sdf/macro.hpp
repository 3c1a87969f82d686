// SPDX-License-Identifier: MIT
// #define: the table of macros and their expansion, as in C but without # and ##.
//
// Macros are expanded here and never reach a compiler. Loops, scopes and calls hidden in them are
// then seen by the parser, the names of two snippets cannot meet, and eight nested macros that
// would make 8^9 tokens end at a budget instead of inside a compiler that nothing can stop.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "sdf/problems.hpp"
#include "sdf/token.hpp"

namespace vitrine::glsl {

struct Macro {
    /// Nothing if it is used without parentheses.
    std::optional<std::vector<std::string>> parameters;
    Tokens body;
    Place place;
};

using Macros = std::map<std::string, Macro, std::less<>>;

class Expander {
  public:
    Expander(const Macros& macros, Problems& problems) : macros_(macros), problems_(problems) {}

    /// `input` with all macros expanded. Tokens from an expansion stand on the line of the
    /// outermost macro's name. Nothing if the budget is used up, which is reported, once.
    std::optional<Tokens> expand(const Tokens& input);

  private:
    struct Frame {
        Tokens tokens;
        size_t next = 0;
        std::string macro;  // disabled while its expansion is read
    };
    using Stack = std::vector<Frame>;

    Tokens expandWithin(Tokens input, int depth);
    void settle(Stack& stack);
    bool next(Stack& stack, Token& token);
    bool invoke(Stack& stack, const Macro& macro, const Token& name, int depth);
    std::optional<std::vector<Tokens>> arguments(Stack& stack, const Macro& macro,
                                                 const Token& name);
    bool spend(size_t tokens);
    void exhaust();
    [[nodiscard]] Token moved(Token token, bool ownPlace) const;

    const Macros& macros_;
    Problems& problems_;
    std::set<std::string, std::less<>> disabled_;
    size_t spent_ = 0;
    bool exhausted_ = false;
    bool gap_ = false;  // an expansion has just ended: the next token must not stick to it
    Token outermost_;
};

}  // namespace vitrine::glsl
