// SPDX-License-Identifier: MIT
#include "scene/document.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/text.hpp"

namespace vitrine {
namespace {

SourceLocation place(const toml::source_region& source) {
    const std::string file = source.path ? *source.path : std::string();
    // A value from the command line has no line worth naming.
    if (startsWith(file, "--set ")) return {file};
    return {file, static_cast<int>(source.begin.line), static_cast<int>(source.begin.column)};
}

void replace(std::string& text, std::string_view what, std::string_view with) {
    if (const size_t at = text.find(what); at != std::string::npos)
        text.replace(at, what.size(), with);
}

/// The library's message for people who have never heard of it.
std::string explainSyntax(std::string message, std::string_view text, toml::source_position at) {
    const std::vector<std::string_view> lines = splitLines(text);
    const bool atLineEnd =
        at.line >= 1 && at.line <= lines.size() && at.column > lines[at.line - 1].size();
    if (atLineEnd && message.find("unescaped control characters") != std::string::npos)
        return "the text has no closing quote";
    replace(message, "Error while parsing ", "");
    replace(message, "saw '\\n'", "found the end of the line");
    replace(message, " (TOML_MAX_NESTED_VALUES)", "");
    if (startsWith(message, "boolean: ")) message += "; text needs quotes";
    return message;
}

/// How many words of a key lead to its table: the section, and a name where there can be several
/// and one is given. "camera.orbit.KEY" is of the first camera, unless one is called so.
size_t countTableWords(const toml::table& document, const std::vector<std::string>& words) {
    if (words.size() == 2 || (!isListSection(words[0]) && !isNamedSection(words[0]))) return 1;
    if (words[0] != "camera" || words[1] != "orbit") return 2;
    const toml::array* cameras = document["camera"].as_array();
    const bool named = cameras != nullptr &&
                       std::any_of(cameras->begin(), cameras->end(), [](const toml::node& camera) {
                           return camera.is_table() && (*camera.as_table())["name"] == "orbit";
                       });
    return named ? 2 : 1;
}

/// The tables of a list section that a key means: those of the name in words[1], or all.
std::vector<toml::table*> findInList(toml::array& list, const std::vector<std::string>& words,
                                     size_t used, std::vector<std::string>& names) {
    std::vector<toml::table*> found;
    for (toml::node& entry : list) {
        toml::table* table = entry.as_table();
        if (table == nullptr) continue;
        names.push_back((*table)["name"].value_or(std::string()));
        if (used == 1 || names.back() == words[1]) found.push_back(table);
    }
    if (words[0] == "camera" && used == 1 && found.size() > 1) found.resize(1);
    return found;
}

/// The tables that the first words of a key name, or none after a diagnostic.
std::vector<toml::table*> findTargets(toml::table& document, const std::vector<std::string>& words,
                                      size_t used, const SourceLocation& where,
                                      Diagnostics& diagnostics) {
    const std::string& section = words[0];
    if (std::find(sectionNames().begin(), sectionNames().end(), section) == sectionNames().end()) {
        diagnostics.error(where, fmt::format("unknown section '{}'{}", section,
                                             didYouMean(section, sectionNames())));
        return {};
    }
    if (!isListSection(section) && !isNamedSection(section)) {
        if (!document.contains(section)) document.insert(section, toml::table{});
        toml::table* table = document[section].as_table();
        return table != nullptr ? std::vector<toml::table*>{table} : std::vector<toml::table*>{};
    }
    if (used == 1 && section != "camera" && section != "light") {
        diagnostics.error(where, fmt::format("say which {0}: {0}.NAME.{1}", section, words[1]));
        return {};
    }
    std::vector<std::string> names;
    std::vector<toml::table*> found;
    if (toml::array* list = document[section].as_array())
        found = findInList(*list, words, used, names);
    if (toml::table* group = document[section].as_table()) {
        for (const auto& [key, value] : *group) names.emplace_back(key.str());
        if (toml::table* table = (*group)[words[1]].as_table()) found.push_back(table);
    }
    if (found.empty())
        diagnostics.error(where, used == 1 ? fmt::format("the scene has no {}", section)
                                           : fmt::format("the scene has no {} '{}'{}", section,
                                                         words[1], didYouMean(words[1], names)));
    return found;
}

}  // namespace

const std::vector<std::string>& sectionNames() {
    static const std::vector<std::string> names{"scene",       "render",   "bvh",      "camera",
                                                "environment", "light",    "material", "shape",
                                                "node",        "animation"};
    return names;
}

bool isListSection(std::string_view section) {
    return section == "camera" || section == "light" || section == "node" || section == "animation";
}

bool isNamedSection(std::string_view section) {
    return section == "material" || section == "shape";
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

std::string printable(std::string text) {
    for (char& c : text)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
    return text;
}

SourceLocation placeOf(const toml::node& node) {
    const toml::table* table = node.as_table();
    // A table that `--set` made on its way to a key has no place, but that key has.
    if (node.source().begin.line == 0 && table != nullptr && !table->empty())
        return placeOf(table->begin()->second);
    return place(node.source());
}

SourceLocation placeOf(const toml::key& key, const toml::node& value) {
    const SourceLocation where = placeOf(value);
    return where.line == 0 ? where : place(key.source());
}

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
        const toml::source_position at = error.source().begin;
        diagnostics.error({file, static_cast<int>(at.line), static_cast<int>(at.column)},
                          explainSyntax(printable(std::string(error.description())), text, at));
        return {};
    }
}

std::optional<toml::table> parseValue(const std::string& value, const std::string& file) {
    for (const std::string& text : {"value = " + value, fmt::format("value = '''{}'''", value)}) {
        try {
            return toml::parse(text, file);
        } catch (const toml::parse_error&) {
        }
    }
    return {};
}

void applyOverride(toml::table& document, const std::string& assignment, Diagnostics& diagnostics) {
    const SourceLocation where{"--set " + assignment};
    const size_t equals = assignment.find('=');
    if (equals == std::string::npos || equals == 0 || assignment.size() > kMaxSceneLine) {
        diagnostics.error(where, "write it as key=value");
        return;
    }
    const std::vector<std::string> words = splitKey(std::string_view(assignment).substr(0, equals));
    const bool emptyWord = std::find(words.begin(), words.end(), "") != words.end();
    if (emptyWord || words.size() < 2 || words.size() > 8) {
        diagnostics.error(where, "the key needs a section, as in render.exposure");
        return;
    }
    const size_t used = countTableWords(document, words);
    const std::vector<toml::table*> targets =
        findTargets(document, words, used, where, diagnostics);
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
        (*value)["value"].visit(
            [&](auto& node) { target->insert_or_assign(words.back(), std::move(node)); });
    }
}

std::vector<std::string> overrideWords(const std::string& assignment) {
    return splitKey(std::string_view(assignment).substr(0, assignment.find('=')));
}

std::string overrideValue(const std::string& assignment) {
    const std::string value(trim(std::string_view(assignment).substr(assignment.find('=') + 1)));
    try {
        (void)toml::parse("value = " + value);
        return value;
    } catch (const toml::parse_error&) {
        std::string quoted;
        for (const char c : value) {
            if (c == '"' || c == '\\') quoted += '\\';
            quoted += c;
        }
        return '"' + quoted + '"';
    }
}

std::optional<Target> findTarget(toml::table& document, const std::string& assignment) {
    const std::vector<std::string> words = overrideWords(assignment);
    const bool single = !isListSection(words[0]) && !isNamedSection(words[0]);
    if (single && !document.contains(words[0])) return {};
    const size_t used = countTableWords(document, words);
    Diagnostics ignored;
    const std::vector<toml::table*> tables = findTargets(document, words, used, {}, ignored);
    if (tables.empty()) return {};
    return Target{tables[0], words, used};
}

}  // namespace vitrine
