// SPDX-License-Identifier: MIT
#include "sdf/brackets.hpp"

#include "sdf/limits.hpp"

namespace vitrine::glsl {

std::optional<std::vector<size_t>> matchBrackets(const Tokens& tokens, Problems& problems) {
    std::vector<size_t> partner(tokens.size());
    std::vector<size_t> open;
    for (size_t i = 0; i < tokens.size(); ++i) {
        partner[i] = i;
        const Token& token = tokens[i];
        if (token.is("(") || token.is("[") || token.is("{")) {
            open.push_back(i);
            if (static_cast<int>(open.size()) <= kMaxNesting) continue;
            problems.error(token.place, "more than " + std::to_string(kMaxNesting) +
                                            " brackets inside of each other");
            return {};
        }
        if (!(token.is(")") || token.is("]") || token.is("}"))) continue;
        if (open.empty()) {
            problems.error(token.place,
                           "nothing is open that this '" + token.text + "' could close");
            return {};
        }
        const Token& opener = tokens[open.back()];
        const char closer = opener.text == "(" ? ')' : opener.text == "[" ? ']' : '}';
        if (token.text[0] != closer) {
            problems.error(token.place, "'" + token.text + "' cannot close the '" + opener.text +
                                            "' of line " + std::to_string(opener.place.line));
            return {};
        }
        partner[i] = open.back();
        partner[open.back()] = i;
        open.pop_back();
    }
    for (const size_t i : open) {
        problems.error(tokens[i].place, "nothing closes this '" + tokens[i].text + "'");
        return {};
    }
    return partner;
}

}  // namespace vitrine::glsl
