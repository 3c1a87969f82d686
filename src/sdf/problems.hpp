// SPDX-License-Identifier: MIT
// Collects what is wrong with one snippet: knows its file, and stops telling after kMaxProblems.
#pragma once

#include <string>

#include "base/error.hpp"
#include "sdf/token.hpp"

namespace vitrine::glsl {

class Problems {
  public:
    Problems(Diagnostics& diagnostics, std::string file)
        : diagnostics_(diagnostics), file_(std::move(file)) {}

    void error(Place place, std::string message);
    void warning(Place place, std::string message);
    [[nodiscard]] bool failed() const { return errors_ > 0; }
    [[nodiscard]] SourceLocation at(Place place) const { return {file_, place.line, place.column}; }

  private:
    Diagnostics& diagnostics_;
    std::string file_;
    int errors_ = 0;
    int warnings_ = 0;
};

}  // namespace vitrine::glsl
