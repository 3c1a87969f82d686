// SPDX-License-Identifier: MIT
// Precedence climbing: one function for all binary operators, driven by a table.
#include "sdf/constant.hpp"

#include <array>
#include <charconv>

#include "sdf/limits.hpp"

namespace vitrine::glsl {

namespace {

using Value = std::optional<int64_t>;

struct BinaryOperator {
    std::string_view text;
    int precedence;
    Value (*apply)(int64_t, int64_t);
};

Value add(int64_t a, int64_t b) {
    int64_t r = 0;
    return __builtin_add_overflow(a, b, &r) ? Value{} : r;
}
Value subtract(int64_t a, int64_t b) {
    int64_t r = 0;
    return __builtin_sub_overflow(a, b, &r) ? Value{} : r;
}
Value multiply(int64_t a, int64_t b) {
    int64_t r = 0;
    return __builtin_mul_overflow(a, b, &r) ? Value{} : r;
}
// The smallest integer divided by -1 overflows too.
Value divide(int64_t a, int64_t b) {
    if (b == 0) return {};
    return b == -1 ? subtract(0, a) : a / b;
}
Value remainder(int64_t a, int64_t b) {
    if (b == 0) return {};
    return b == -1 ? 0 : a % b;
}
Value shiftLeft(int64_t a, int64_t b) {
    return b < 0 || b > 31 ? Value{} : multiply(a, 1LL << b);
}

constexpr std::array<BinaryOperator, 18> kOperators = {{
    {"||", 1, [](int64_t a, int64_t b) -> Value { return a != 0 || b != 0; }},
    {"&&", 2, [](int64_t a, int64_t b) -> Value { return a != 0 && b != 0; }},
    {"|", 3, [](int64_t a, int64_t b) -> Value { return a | b; }},
    {"^", 4, [](int64_t a, int64_t b) -> Value { return a ^ b; }},
    {"&", 5, [](int64_t a, int64_t b) -> Value { return a & b; }},
    {"==", 6, [](int64_t a, int64_t b) -> Value { return a == b; }},
    {"!=", 6, [](int64_t a, int64_t b) -> Value { return a != b; }},
    {"<", 7, [](int64_t a, int64_t b) -> Value { return a < b; }},
    {">", 7, [](int64_t a, int64_t b) -> Value { return a > b; }},
    {"<=", 7, [](int64_t a, int64_t b) -> Value { return a <= b; }},
    {">=", 7, [](int64_t a, int64_t b) -> Value { return a >= b; }},
    {"<<", 8, shiftLeft},
    {">>", 8, [](int64_t a, int64_t b) -> Value { return b < 0 || b > 63 ? Value{} : a >> b; }},
    {"+", 9, add},
    {"-", 9, subtract},
    {"*", 10, multiply},
    {"/", 10, divide},
    {"%", 10, remainder},
}};

class Evaluator {
  public:
    Evaluator(std::span<const Token> tokens, const NameValue& valueOf)
        : tokens_(tokens), valueOf_(valueOf) {}

    Value whole() {
        const Value value = binary(1);
        return at_ == tokens_.size() ? value : Value{};
    }

  private:
    [[nodiscard]] const Token& current() const {
        static const Token end;
        return at_ < tokens_.size() ? tokens_[at_] : end;
    }

    const BinaryOperator* currentOperator() const {
        for (const BinaryOperator& candidate : kOperators)
            if (current().is(candidate.text)) return &candidate;
        return nullptr;
    }

    Value binary(int minimumPrecedence) {
        Value left = unary();
        while (left) {
            const BinaryOperator* op = currentOperator();
            if (!op || op->precedence < minimumPrecedence) break;
            ++at_;
            const Value right = binary(op->precedence + 1);
            left = right ? op->apply(*left, *right) : Value{};
        }
        return left;
    }

    Value unary() {
        if (++depth_ > kMaxNesting) return {};
        const Value value = unaryWithin();
        --depth_;
        return value;
    }

    Value unaryWithin() {
        const Token token = current();
        ++at_;
        if (token.is("(")) {
            const Value value = binary(1);
            if (!current().is(")")) return {};
            ++at_;
            return value;
        }
        if (token.is("+")) return unary();
        if (token.is("-") || token.is("!") || token.is("~")) {
            const Value value = unary();
            if (!value) return {};
            if (token.is("-")) return subtract(0, *value);
            return token.is("!") ? int64_t{*value == 0} : ~*value;
        }
        if (token.kind == TokenKind::kNumber) return integerLiteral(token.text);
        if (token.isWord()) return valueOf_(token);
        return {};
    }

    std::span<const Token> tokens_;
    const NameValue& valueOf_;
    size_t at_ = 0;
    int depth_ = 0;
};

}  // namespace

std::optional<int64_t> integerLiteral(std::string_view text) {
    if (!text.empty() && (text.back() == 'u' || text.back() == 'U')) text.remove_suffix(1);
    int base = 10;
    if (text.size() > 2 && text[0] == '0' && (text[1] == 'x' || text[1] == 'X')) {
        base = 16;
        text.remove_prefix(2);
    } else if (text.size() > 1 && text[0] == '0') {
        base = 8;
    }
    int64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
    if (text.empty() || error != std::errc{} || end != text.data() + text.size()) return {};
    return value;
}

std::optional<int64_t> evaluateConstant(std::span<const Token> tokens, const NameValue& valueOf) {
    return Evaluator(tokens, valueOf).whole();
}

}  // namespace vitrine::glsl
