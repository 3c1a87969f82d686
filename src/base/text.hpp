// SPDX-License-Identifier: MIT
// Small helpers for words and messages.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace vitrine {

/// Number of insertions, deletions, substitutions and swaps of neighbours between two words
/// (Damerau-Levenshtein, optimal string alignment).
int editDistance(std::string_view a, std::string_view b);

/// The candidate nearest to `word`, or "" if none is near enough to be a likely slip.
std::string closestMatch(std::string_view word, const std::vector<std::string>& candidates);

/// " (did you mean 'X'?)", or "" if nothing is near.
std::string didYouMean(std::string_view word, const std::vector<std::string>& candidates);

std::string_view trim(std::string_view text);
/// Views into `text`, one a line, without the line ends ("\n" or "\r\n").
std::vector<std::string_view> splitLines(std::string_view text);
bool startsWith(std::string_view text, std::string_view prefix);
bool endsWith(std::string_view text, std::string_view suffix);

}  // namespace vitrine
