// SPDX-License-Identifier: MIT
// Expansion by a stack of token lists: what a macro expands to is read before what follows it, and
// the macro is disabled until its list is used up (ISO C 6.10.3.4).
#include "sdf/macro.hpp"

#include <algorithm>
#include <utility>

#include "sdf/limits.hpp"

namespace vitrine::glsl {

std::optional<Tokens> Expander::expand(const Tokens& input) {
    Tokens output = expandWithin(input, 0);
    if (exhausted_) return {};
    return output;
}

Tokens Expander::expandWithin(Tokens input, int depth) {
    Tokens output;
    if (depth > kMaxMacroDepth) {
        exhaust();
        return output;
    }
    Stack stack;
    stack.push_back({std::move(input), 0, {}});
    Token token;
    while (!exhausted_ && next(stack, token)) {
        const auto macro =
            token.isWord() && !token.painted ? macros_.find(token.text) : macros_.end();
        if (depth == 0 && stack.size() == 1) outermost_ = token;
        if (macro == macros_.end() || !invoke(stack, macro->second, token, depth))
            output.push_back(std::move(token));
    }
    for (const Frame& frame : stack) disabled_.erase(frame.macro);
    return output;
}

/// Leaves the lists that are used up, except for the input itself.
void Expander::settle(Stack& stack) {
    while (stack.size() > 1 && stack.back().next == stack.back().tokens.size()) {
        disabled_.erase(stack.back().macro);
        stack.pop_back();
        gap_ = true;
    }
}

bool Expander::next(Stack& stack, Token& token) {
    settle(stack);
    Frame& frame = stack.back();
    if (frame.next == frame.tokens.size()) return false;
    token = frame.tokens[frame.next++];
    token.spaceBefore = token.spaceBefore || gap_;
    gap_ = false;
    if (token.isWord() && disabled_.contains(token.text)) token.painted = true;
    return true;
}

/// False if `name` is no call of the macro: it takes arguments, and none follow.
bool Expander::invoke(Stack& stack, const Macro& macro, const Token& name, int depth) {
    std::vector<Tokens> values;
    if (macro.parameters) {
        settle(stack);
        const Frame& frame = stack.back();
        if (frame.next == frame.tokens.size() || !frame.tokens[frame.next].is("(")) return false;
        std::optional<std::vector<Tokens>> found = arguments(stack, macro, name);
        if (!found) return true;
        for (Tokens& value : *found) values.push_back(expandWithin(std::move(value), depth + 1));
    }
    Frame expansion{{}, 0, name.text};
    if (!spend(1)) return true;
    bool gap = true;  // what is put together here must not become one sign, "- -x" not "--x"
    const auto append = [&](const Token& token, bool ownPlace) {
        expansion.tokens.push_back(moved(token, ownPlace));
        expansion.tokens.back().spaceBefore = token.spaceBefore || gap;
        gap = false;
    };
    for (const Token& part : macro.body) {
        size_t index = values.size();
        if (part.isWord() && macro.parameters) {
            const auto at =
                std::find(macro.parameters->begin(), macro.parameters->end(), part.text);
            index = static_cast<size_t>(at - macro.parameters->begin());
        }
        const bool isArgument = index < values.size();
        if (!spend(isArgument ? values[index].size() : 1)) return true;
        if (!isArgument) {
            append(part, false);
            continue;
        }
        gap = true;
        for (const Token& token : values[index]) append(token, true);
        gap = true;
    }
    disabled_.insert(name.text);
    stack.push_back(std::move(expansion));
    return true;
}

std::optional<std::vector<Tokens>> Expander::arguments(Stack& stack, const Macro& macro,
                                                       const Token& name) {
    std::vector<Tokens> values(1);
    Token token;
    next(stack, token);
    for (int open = 1; open > 0;) {
        if (!next(stack, token)) {
            problems_.error(moved(name, true).place,
                            "the call of macro '" + name.text + "' has no closing ')'");
            return {};
        }
        if (token.is("(")) ++open;
        if (token.is(")")) --open;
        if (open == 1 && token.is(","))
            values.emplace_back();
        else if (open > 0)
            values.back().push_back(token);
    }
    const size_t wanted = macro.parameters->size();
    if (wanted == 0 && values.size() == 1 && values[0].empty()) values.clear();
    if (values.size() == wanted) return values;
    problems_.error(moved(name, true).place,
                    "macro '" + name.text + "' takes " + std::to_string(wanted) +
                        (wanted == 1 ? " argument, not " : " arguments, not ") +
                        std::to_string(values.size()));
    return {};
}

bool Expander::spend(size_t tokens) {
    spent_ += tokens;
    if (spent_ > kMaxExpansion) exhaust();
    return !exhausted_;
}

void Expander::exhaust() {
    if (!exhausted_)
        problems_.error(outermost_.place, "expanding the macro '" + outermost_.text +
                                              "' makes more than " + std::to_string(kMaxExpansion) +
                                              " tokens: no compiler would survive it");
    exhausted_ = true;
}

Token Expander::moved(Token token, bool ownPlace) const {
    if (!ownPlace || token.place.line != outermost_.place.line) token.place = outermost_.place;
    return token;
}

}  // namespace vitrine::glsl
