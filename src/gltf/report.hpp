// SPDX-License-Identifier: MIT
// Errors and warnings about a glTF file, by JSON pointer (RFC 6901).
#pragma once

#include <set>
#include <stdexcept>
#include <string>
#include <string_view>

#include "base/error.hpp"

namespace vitrine {

class Report {
  public:
    /// Thrown when one more error would be too many.
    struct Flood {};

    Report(std::string file, Diagnostics& diagnostics, int maxMessages)
        : file_(std::move(file)), diagnostics_(diagnostics), left_{maxMessages, maxMessages} {}

    /// The JSON text, which lines are looked up in if it is all of the file, and the byte of the
    /// file where it begins. It must outlive the report.
    void setJson(std::string_view json, size_t firstByte) {
        json_ = json;
        firstByte_ = firstByte;
    }

    void error(std::string_view pointer, const std::string& message);
    void warning(std::string_view pointer, const std::string& message);
    /// An error at a byte of the JSON text.
    void errorAtByte(size_t byte, const std::string& message);
    /// Only the first time this message comes.
    void warnOnce(std::string_view pointer, const std::string& message);

    [[nodiscard]] bool hasErrors() const { return hasErrors_; }
    [[nodiscard]] const std::string& file() const { return file_; }
    [[nodiscard]] SourceLocation place(std::string_view pointer) const;

  private:
    void addError(SourceLocation where, const std::string& message);

    std::string file_;
    std::string_view json_;
    size_t firstByte_ = 0;
    Diagnostics& diagnostics_;
    struct {
        int errors, warnings;
    } left_;
    bool hasErrors_ = false;
    std::set<std::string> once_;
};

/// A word of the file for a message: in quotes, cut short, without control characters.
std::string inQuotes(std::string_view text);

}  // namespace vitrine
