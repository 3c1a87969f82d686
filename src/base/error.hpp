// SPDX-License-Identifier: MIT
// What can go wrong, and whose fault it is. Assertions are for our own bugs; bad input and a bad
// machine throw one of these. Only app/ turns them into an exit code.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine {

/// A place in a file the user wrote. Lines and columns count from 1; 0 means "the whole file".
struct SourceLocation {
    std::string file;
    int line = 0;
    int column = 0;

    /// "file:line:column", as far as they are known.
    [[nodiscard]] std::string text() const;
};

enum class Severity { kWarning, kError };

struct Diagnostic {
    Severity severity = Severity::kError;
    SourceLocation where;
    std::string message;

    /// "file:line:column: error: message"
    [[nodiscard]] std::string text() const;
};

/// Collects what is wrong with the input, so that one run reports all of it.
class Diagnostics {
  public:
    void error(SourceLocation where, std::string message);
    void warning(SourceLocation where, std::string message);
    void add(Diagnostic diagnostic) { list_.push_back(std::move(diagnostic)); }
    void append(const Diagnostics& other);

    [[nodiscard]] bool hasErrors() const;
    [[nodiscard]] const std::vector<Diagnostic>& list() const { return list_; }
    /// One diagnostic a line.
    [[nodiscard]] std::string text() const;
    /// Throws InputError with all of the list if there is an error in it.
    void throwIfErrors() const;

  private:
    std::vector<Diagnostic> list_;
};

/// The input is at fault (exit code 1).
class InputError : public std::runtime_error {
  public:
    explicit InputError(Diagnostics diagnostics);
    InputError(SourceLocation where, std::string message);
    [[nodiscard]] const Diagnostics& diagnostics() const { return diagnostics_; }

  private:
    Diagnostics diagnostics_;
};

/// The command line is at fault (exit code 2).
class UsageError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The machine is at fault: no GL, disk full, file not writable (exit code 3).
class MachineError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace vitrine
