// SPDX-License-Identifier: MIT
#include "scene/document.hpp"

#include <fmt/format.h>

#include "base/text.hpp"

namespace vitrine {
namespace {

SourceLocation place(const toml::source_region& source) {
    const std::string file = source.path ? *source.path : std::string();
    // A value from the command line has no line worth naming.
    if (startsWith(file, "--set ")) return {file};
    return {file, static_cast<int>(source.begin.line), static_cast<int>(source.begin.column)};
}

bool isNamedSection(std::string_view section) {
    return section == "material" || section == "shape";
}

bool isListSection(std::string_view section) {
    return section == "camera" || section == "light" || section == "node";
}

std::vector<std::string> splitKey(std::string_view key) {
    std::vector<std::string> words;
    while (true) {
        const size_t dot = key.find('.');
        words.emplace_back(trim(key.substr(0, dot)));
        if (dot == std::string_view::npos) return words;
        key = key.substr(dot + 1);
    }
}

/// The value as TOML, or as a string if it is a bare word.
std::optional<toml::table> parseValue(const std::string& value, const std::string& file) {
    for (const std::string& text : {"value = " + value, fmt::format("value = '{}'", value)}) {
        try {
            return toml::parse(text, file);
        } catch (const toml::parse_error&) {
        }
    }
    return {};
}

/// The tables that the first words of a key name; `used` says how many words that took.
std::vector<toml::table*> findTargets(toml::table& document, const std::vector<std::string>& words,
                                      size_t& used, std::vector<std::string>& candidates) {
    const std::string& section = words[0];
    used = 1;
    if (isListSection(section)) {
        toml::array* list = document[section].as_array();
        if (list == nullptr) return {};
        std::vector<toml::table*> all, named;
        for (toml::node& entry : *list) {
            toml::table* table = entry.as_table();
            if (table == nullptr) continue;
            all.push_back(table);
            const std::string name = (*table)["name"].value_or(std::string());
            candidates.push_back(name);
            if (words.size() > 2 && name == words[1]) named.push_back(table);
        }
        if (words.size() > 2) {
            used = 2;
            return named;
        }
        if (section == "camera" && all.size() > 1) all.resize(1);
        return section == "node" ? std::vector<toml::table*>{} : all;
    }
    if (isNamedSection(section)) {
        toml::table* group = document[section].as_table();
        if (group == nullptr || words.size() < 3) return {};
        for (const auto& [key, value] : *group) candidates.emplace_back(key.str());
        used = 2;
        toml::table* table = (*group)[words[1]].as_table();
        return table != nullptr ? std::vector<toml::table*>{table} : std::vector<toml::table*>{};
    }
    if (!document.contains(section)) document.insert(section, toml::table{});
    toml::table* table = document[section].as_table();
    return table != nullptr ? std::vector<toml::table*>{table} : std::vector<toml::table*>{};
}

}  // namespace

SourceLocation placeOf(const toml::node& node) { return place(node.source()); }
SourceLocation placeOf(const toml::key& key) { return place(key.source()); }

std::optional<toml::table> parseDocument(std::string_view text, const std::string& file,
                                         Diagnostics& diagnostics) {
    if (text.size() > kMaxSceneBytes) {
        diagnostics.error({file}, fmt::format("the scene is larger than {} bytes", kMaxSceneBytes));
        return {};
    }
    int number = 0;
    for (const std::string_view line : splitLines(text)) {
        ++number;
        if (line.size() <= kMaxSceneLine) continue;
        diagnostics.error({file, number, static_cast<int>(kMaxSceneLine) + 1},
                          fmt::format("the line is longer than {} bytes", kMaxSceneLine));
        return {};
    }
    try {
        return toml::parse(text, file);
    } catch (const toml::parse_error& error) {
        diagnostics.error({file, static_cast<int>(error.source().begin.line),
                           static_cast<int>(error.source().begin.column)},
                          std::string(error.description()));
        return {};
    }
}

void applyOverride(toml::table& document, const std::string& assignment, Diagnostics& diagnostics) {
    const SourceLocation where{"--set " + assignment};
    const size_t equals = assignment.find('=');
    if (equals == std::string::npos || equals == 0 || assignment.size() > kMaxSceneLine) {
        diagnostics.error(where, "write it as key=value");
        return;
    }
    const std::vector<std::string> words = splitKey(std::string_view(assignment).substr(0, equals));
    if (words.size() < 2 || words.size() > 8) {
        diagnostics.error(where, "the key needs a section, as in render.exposure");
        return;
    }
    size_t used = 0;
    std::vector<std::string> candidates;
    const std::vector<toml::table*> targets = findTargets(document, words, used, candidates);
    if (targets.empty()) {
        const std::string& name = words[words.size() > 2 ? 1 : 0];
        diagnostics.error(where, fmt::format("the scene has no {} '{}'{}", words[0], name,
                                             didYouMean(name, candidates)));
        return;
    }
    for (toml::table* target : targets) {
        std::optional<toml::table> value = parseValue(assignment.substr(equals + 1), where.file);
        if (!value) {
            diagnostics.error(where, "the value is not understood");
            return;
        }
        for (size_t i = used; i + 1 < words.size(); ++i) {
            if (!target->contains(words[i])) target->insert(words[i], toml::table{});
            target = (*target)[words[i]].as_table();
            if (target == nullptr) {
                diagnostics.error(where, fmt::format("'{}' has no keys of its own", words[i]));
                return;
            }
        }
        // Moved, because a copy would forget where it came from.
        (*value)["value"].visit([&](auto& node) {
            target->insert_or_assign(words.back(), std::move(node));
        });
    }
}

}  // namespace vitrine
