// SPDX-License-Identifier: MIT
#include <algorithm>

#include "sdf/limits.hpp"
#include "sdf/parser.hpp"
#include "sdf/words.hpp"

namespace vitrine::glsl {

using Role = SnippetPiece::Role;

void Parser::statements(size_t end, int depth) {
    while (at_ < end) statement(end, depth);
}

void Parser::statement(size_t end, int depth) {
    if (depth > kMaxNesting) {
        problems_.error(token().place, "more than " + std::to_string(kMaxNesting) +
                                           " statements inside of each other");
        at_ = end;
        return;
    }
    if (at_ >= end) return unexpected("a statement");
    if (is("{")) {
        const size_t close = partner_[at_];
        scopes_.push();
        copy();
        statements(close, depth + 1);
        copy();
        scopes_.pop();
    } else if (is("if")) {
        ifStatement(end, depth);
    } else if (is("for")) {
        forStatement(end, depth);
    } else if (is("while")) {
        whileStatement(end, depth);
    } else if (is("do")) {
        doStatement(end, depth);
    } else if (is("switch")) {
        copy();
        parenthesised();
        if (is("{"))
            statement(end, depth + 1);
        else
            unexpected("'{'");
    } else if (is("case") || is("default")) {
        caseLabel(end);
    } else if (is("else")) {
        problems_.error(token().place, "'else' without 'if'");
        ++at_;
    } else if (is("precision")) {
        at_ = std::min(find(";", at_, end) + 1, end);
    } else {
        simpleStatement(end);
    }
}

/// The branch of an if or the body of a loop: what it declares ends with it, braces or not.
void Parser::scopedStatement(size_t end, int depth) {
    scopes_.push();
    statement(end, depth + 1);
    scopes_.pop();
}

/// A declaration, a jump or an expression, up to its semicolon.
void Parser::simpleStatement(size_t end) {
    const size_t stop = find(";", at_, end);
    if (stop == end) {
        problems_.error(tokens_[end - 1].place, "a ';' is missing behind this");
        at_ = end;
        return;
    }
    if (startsDeclaration(at_)) {
        const Type type = typeSpecifier();
        if (at_ < stop) declarators(type, stop);
    } else {
        if (is("return") || is("break") || is("continue")) copy();
        expression(stop);
    }
    at_ = stop;
    copy();
}

void Parser::parenthesised() {
    if (!is("(")) return unexpected("'('");
    const size_t close = partner_[at_];
    copy();
    expression(close);
    copy();
}

/// A chain of else-ifs is one loop here, not a recursion: users write long ones.
void Parser::ifStatement(size_t end, int depth) {
    while (true) {
        copy();
        parenthesised();
        scopedStatement(end, depth);
        if (at_ >= end || !is("else")) return;
        copy();
        if (at_ < end && is("if")) continue;
        return scopedStatement(end, depth);
    }
}

void Parser::forStatement(size_t end, int depth) {
    const Token loop = token();
    copy();
    if (!is("(")) return unexpected("'('");
    const size_t close = partner_[at_];
    copy();
    scopes_.push();
    const size_t first = find(";", at_, close);
    const size_t second = first == close ? close : find(";", first + 1, close);
    if (second == close || find(";", second + 1, close) != close) {
        problems_.error(loop.place, "a loop is written: for (start; condition; step)");
        at_ = close;
    } else {
        simpleStatement(close);
        guardedCondition(second);
        copy();
        expression(close);
    }
    copy();
    scopedStatement(end, depth);
    scopes_.pop();
}

void Parser::whileStatement(size_t end, int depth) {
    copy();
    if (!is("(")) return unexpected("'('");
    const size_t close = partner_[at_];
    copy();
    scopes_.push();
    guardedCondition(close);
    copy();
    scopedStatement(end, depth);
    scopes_.pop();
}

void Parser::doStatement(size_t end, int depth) {
    copy();
    scopedStatement(end, depth);
    if (at_ >= end || !is("while")) return unexpected("'while' of the 'do'");
    copy();
    if (!is("(")) return unexpected("'('");
    const size_t close = partner_[at_];
    copy();
    guardedCondition(close);
    copy();
    if (at_ >= end || !is(";")) return unexpected("';'");
    copy();
}

/// "condition" becomes "guard && (condition)": the guard counts even where the user's own condition
/// would already end the loop, and stands where "continue" cannot pass it by.
void Parser::guardedCondition(size_t close) {
    const bool declares = startsDeclaration(at_);
    Token name;
    if (declares) {
        typeSpecifier();
        name = token();
        if (at_ < close && name.isWord()) {
            checkName(name);
            put(Role::kName, name, name.text);
            ++at_;
            expect("=", "'=' and a value");
        } else {
            unexpected("a name");
        }
    }
    const Token like = token();
    const auto insert = [&](Role role, const char* text, bool space) {
        Token inserted = like;
        inserted.spaceBefore = space;
        inserted.startsLine = false;
        put(role, inserted, text);
    };
    insert(Role::kGuard, "", like.spaceBefore);
    if (at_ < close) {
        insert(Role::kText, "&&", true);
        insert(Role::kText, "(", true);
        const size_t first = snippet_.pieces.size();
        expression(close);
        if (first < snippet_.pieces.size()) snippet_.pieces[first].spaceBefore = false;
        insert(Role::kText, ")", false);
        snippet_.pieces.back().line = tokens_[close - 1].place.line;
    }
    if (declares) scopes_.declare(name.text, {Symbol::Kind::kVariable, name.place, 0, 1, {}});
    at_ = close;
}

void Parser::caseLabel(size_t end) {
    copy();
    size_t colon = at_;
    for (int questions = 0; colon < end; colon = std::max(partner_[colon], colon) + 1) {
        if (tokens_[colon].is("?")) ++questions;
        if (tokens_[colon].is(":") && questions-- == 0) break;
    }
    if (colon >= end) {
        problems_.error(tokens_[at_ - 1].place, "no ':' ends this label");
        at_ = end;
        return;
    }
    expression(colon);
    copy();
}

/// Passes an expression on. Statements cannot hide in here: no loop escapes its guard.
void Parser::expression(size_t end) {
    while (at_ < end) {
        if (is(";")) {
            problems_.error(token().place, "a ';' inside of an expression");
            at_ = end;
        } else if (token().isWord() && isStatementWord(token().text) && !is("discard")) {
            problems_.error(token().place,
                            "'" + token().text + "' inside of an expression; is a ';' missing?");
            at_ = end;
        } else if (token().isWord() && !tokens_[at_ - 1].is(".")) {
            name();
        } else {
            copy();
        }
    }
}

}  // namespace vitrine::glsl
