// SPDX-License-Identifier: MIT
// The TOML text of a scene as a tree that still knows its lines, with `--set` merged in.
#pragma once

#include <toml++/toml.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"

namespace vitrine {

/// Caps that keep hostile text away from the TOML library: it crashes on very long dotted keys.
inline constexpr uint64_t kMaxSceneBytes = 1u << 20;
inline constexpr size_t kMaxSceneLine = 4096;

/// [scene], [[camera]] and so on.
const std::vector<std::string>& sectionNames();

/// [[camera]]: several, in order.
bool isListSection(std::string_view section);
/// [material.NAME]
bool isNamedSection(std::string_view section);

/// The words between the dots of a `--set` key, without blanks around them.
std::vector<std::string> splitKey(std::string_view key);

/// For a message: names and values may hold line ends and worse.
std::string printable(std::string text);

SourceLocation placeOf(const toml::node& node);
/// Of a key and its value: the key's, unless it came from the command line.
SourceLocation placeOf(const toml::key& key, const toml::node& value);

/// Nothing, with a diagnostic, if the text is not TOML.
std::optional<toml::table> parseDocument(std::string_view text, const std::string& file,
                                         Diagnostics& diagnostics);

/// The value of a `--set` under the key "value", or as text if it is no TOML.
std::optional<toml::table> parseValue(const std::string& value, const std::string& file);

/// Merges one `--set KEY=VALUE`. KEY is "section.key" for the sections there is one of (render,
/// environment, scene), "section.NAME.key" for the others; "camera.key" means the first camera and
/// "light.key" every light. VALUE is a TOML value; anything else is taken for text.
void applyOverride(toml::table& document, const std::string& assignment, Diagnostics& diagnostics);

/// The words of an assignment's key, and its value as TOML (quoted if it is text without quotes).
std::vector<std::string> overrideWords(const std::string& assignment);
std::string overrideValue(const std::string& assignment);

/// The first table that an assignment changes: words[used] is the first word that is looked up in
/// it. Nothing if the document has no such table yet.
struct Target {
    toml::table* table;
    std::vector<std::string> words;
    size_t used;
};
std::optional<Target> findTarget(toml::table& document, const std::string& assignment);

}  // namespace vitrine
