// SPDX-License-Identifier: MIT
// Every word of an expression is known before any compiler sees it: a name that nobody declared
// would otherwise mean whatever the renderer calls by that name.
#include <algorithm>

#include "base/text.hpp"
#include "sdf/parser.hpp"
#include "sdf/words.hpp"

namespace vitrine::glsl {

using Role = SnippetPiece::Role;

/// A word that is used, not declared.
void Parser::name() {
    const Token word = token();
    const Symbol* symbol = scopes_.find(word.text);
    const bool isCall = tokens_[at_ + 1].is("(");
    const Builtin* builtin = nullptr;
    if (!symbol || symbol->kind == Symbol::Kind::kBuiltin)
        builtin = findBuiltin(snippet_.kind, word.text);
    if ((builtin || (symbol && symbol->kind == Symbol::Kind::kParameter)) && scopes_.global()) {
        problems_.error(word.place, "'" + word.text +
                                        "' changes, and the initial value of a global "
                                        "variable must be constant");
    }
    if (builtin) {
        builtinVariable(word, *builtin);
    } else if (symbol && symbol->kind == Symbol::Kind::kParameter) {
        put(Role::kParameter, word, word.text, symbol->index);
        ++at_;
    } else if (isCall && (!symbol || symbol->kind == Symbol::Kind::kFunction) &&
               builtinTypeSize(word.text) == 0) {
        call(word, symbol);
    } else if (symbol) {
        put(Role::kName, word, word.text);
        ++at_;
    } else {
        if (!isReserved(word.text) || !reasonAgainst(word.text).empty())
            reportUnknown(word, isCall);
        copy();
    }
}

void Parser::builtinVariable(const Token& word, const Builtin& builtin) {
    snippet_.usesTime = snippet_.usesTime || builtin.key == "time";
    put(Role::kBuiltin, word, std::string(builtin.key));
    if (!builtin.components.empty()) {
        Token like = word;
        like.spaceBefore = like.startsLine = false;
        put(Role::kText, like, std::string(builtin.components));
    }
    ++at_;
}

size_t Parser::countArguments(size_t open) const {
    const size_t close = partner_[open];
    if (open + 1 == close || (open + 2 == close && tokens_[open + 1].is("void"))) return 0;
    size_t count = 1;
    for (size_t comma = find(",", open + 1, close); comma < close; ++count)
        comma = find(",", comma + 1, close);
    return count;
}

/// A snippet may add an overload to a function of GLSL or of the library, so the number of
/// arguments decides whose function is meant.
void Parser::call(const Token& name, const Symbol* symbol) {
    const size_t count = countArguments(at_ + 1);
    size_t callee = 0;
    int candidates = 0;
    for (size_t i = 0; symbol && i < functions_.size(); ++i) {
        if (functions_[i].name != name.text || functions_[i].arguments.size() != count) continue;
        callee = i;
        ++candidates;
    }
    if (candidates == 0) foreignCall(name, count);
    put(candidates > 0 ? Role::kName : Role::kText, name, name.text);
    // With several of that many arguments their types decide, which only a compiler can tell; it
    // also finds recursion among them.
    if (candidates == 1 && !scopes_.global())
        functions_[current_].calls.push_back({callee, name.place});
    ++at_;
}

/// A call of what the snippet itself does not define.
void Parser::foreignCall(const Token& name, size_t count) {
    if (isBuiltinFunction(name.text)) return;
    const LibraryFunction* function = library_.find(name.text);
    if (!function) return reportUnknown(name, true);
    if (function->argumentCount != count)
        problems_.error(name.place,
                        "'" + name.text + "' takes " + std::to_string(function->argumentCount) +
                            (function->argumentCount == 1 ? " argument" : " arguments") + ", not " +
                            std::to_string(count) + ": " + function->signature);
    snippet_.libraryFunctions.insert(name.text);
    if (!scopes_.global()) functions_[current_].libraryCalls.insert(name.text);
}

/// Once a name: one misspelling is one mistake.
void Parser::reportUnknown(const Token& word, bool isCall) {
    if (!reported_.insert(word.text).second) return;
    const std::string quoted = "'" + printable(word.text) + "'";
    if (const std::string_view reason = reasonAgainst(word.text); !reason.empty())
        return problems_.error(word.place, quoted + " cannot be used: " + std::string(reason));
    const std::string_view here = isCall ? Library::nameHere(word.text) : std::string_view{};
    if (!here.empty())
        return problems_.error(word.place, "no function " + quoted + "; the library has " +
                                               library_.find(here)->signature);
    std::vector<std::string> candidates = scopes_.names();
    if (isCall) {
        const std::vector<std::string>& builtins = builtinFunctions();
        candidates.insert(candidates.end(), builtins.begin(), builtins.end());
        for (const LibraryFunction& f : library_.functions()) candidates.push_back(f.name);
    } else {
        const std::vector<std::string> builtins = builtinNames(snippet_.kind);
        candidates.insert(candidates.end(), builtins.begin(), builtins.end());
    }
    const std::string what = isCall ? "no function " + quoted : quoted + " is not declared";
    if (scopes_.find(word.text) != nullptr)
        problems_.error(word.place, what + " takes that many arguments");
    else
        // One letter is near every other.
        problems_.error(word.place,
                        what + (word.text.size() > 1 ? didYouMean(word.text, candidates) : ""));
}

}  // namespace vitrine::glsl
