// SPDX-License-Identifier: MIT
#include "base/error.hpp"

#include <algorithm>
#include <utility>

namespace vitrine {

std::string SourceLocation::text() const {
    std::string result = file;
    if (line > 0) result += ':' + std::to_string(line);
    if (line > 0 && column > 0) result += ':' + std::to_string(column);
    return result;
}

std::string Diagnostic::text() const {
    const std::string place = where.text();
    return (place.empty() ? "" : place + ": ") +
           (severity == Severity::kError ? "error: " : "warning: ") + message;
}

void Diagnostics::error(SourceLocation where, std::string message) {
    list_.push_back({Severity::kError, std::move(where), std::move(message)});
}

void Diagnostics::warning(SourceLocation where, std::string message) {
    list_.push_back({Severity::kWarning, std::move(where), std::move(message)});
}

void Diagnostics::append(const Diagnostics& other) {
    list_.insert(list_.end(), other.list_.begin(), other.list_.end());
}

bool Diagnostics::hasErrors() const {
    return std::any_of(list_.begin(), list_.end(),
                       [](const Diagnostic& d) { return d.severity == Severity::kError; });
}

std::string Diagnostics::text() const {
    std::string result;
    for (const Diagnostic& d : list_) {
        if (!result.empty()) result += '\n';
        result += d.text();
    }
    return result;
}

void Diagnostics::throwIfErrors() const {
    if (hasErrors()) throw InputError(*this);
}

InputError::InputError(Diagnostics diagnostics)
    : std::runtime_error(diagnostics.text()), diagnostics_(std::move(diagnostics)) {}

namespace {
Diagnostics single(SourceLocation where, std::string message) {
    Diagnostics d;
    d.error(std::move(where), std::move(message));
    return d;
}
}  // namespace

InputError::InputError(SourceLocation where, std::string message)
    : InputError(single(std::move(where), std::move(message))) {}

}  // namespace vitrine
