// SPDX-License-Identifier: MIT
#include "sdf/problems.hpp"

#include <utility>

#include "sdf/limits.hpp"

namespace vitrine::glsl {

void Problems::error(Place place, std::string message) {
    ++errors_;
    if (errors_ <= kMaxProblems) diagnostics_.error(at(place), std::move(message));
    if (errors_ == kMaxProblems) diagnostics_.error(at(place), "more errors follow, not shown");
}

void Problems::warning(Place place, std::string message) {
    ++warnings_;
    if (warnings_ <= kMaxProblems) diagnostics_.warning(at(place), std::move(message));
}

}  // namespace vitrine::glsl
