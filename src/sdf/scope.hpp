// SPDX-License-Identifier: MIT
// What the names of a snippet mean at one point of its text.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sdf/token.hpp"

namespace vitrine::glsl {

struct Symbol {
    enum class Kind { kVariable, kFunction, kStruct, kParameter, kBuiltin };
    Kind kind = Kind::kVariable;
    Place place;
    /// Of a parameter, into Snippet::parameters.
    int index = 0;
    /// Floats in a struct.
    int size = 1;
    /// Of a const int whose value can be told; for the length of arrays.
    std::optional<int64_t> value;
};

class Scopes {
  public:
    Scopes() : levels_(1) {}

    void push() { levels_.emplace_back(); }
    void pop() { levels_.pop_back(); }
    [[nodiscard]] bool global() const { return levels_.size() == 1; }
    void declare(const std::string& name, Symbol symbol) { levels_.back()[name] = symbol; }
    void declareGlobal(const std::string& name, Symbol symbol) { levels_.front()[name] = symbol; }
    [[nodiscard]] const Symbol* find(const std::string& name) const {
        for (auto level = levels_.rbegin(); level != levels_.rend(); ++level)
            if (const auto found = level->find(name); found != level->end()) return &found->second;
        return nullptr;
    }

    [[nodiscard]] const Symbol* findGlobal(const std::string& name) const {
        const auto found = levels_.front().find(name);
        return found == levels_.front().end() ? nullptr : &found->second;
    }

    /// All names that can be used at this point.
    [[nodiscard]] std::vector<std::string> names() const {
        std::vector<std::string> result;
        for (const auto& level : levels_)
            for (const auto& [name, symbol] : level) result.push_back(name);
        return result;
    }

  private:
    std::vector<std::map<std::string, Symbol>> levels_;
};

}  // namespace vitrine::glsl
