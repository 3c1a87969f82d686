// SPDX-License-Identifier: MIT
#include "scene/include.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "base/file.hpp"
#include "base/text.hpp"
#include "scene/document.hpp"

namespace vitrine {
namespace fs = std::filesystem;
namespace {

/// Moved, because a copy would forget where it came from.
void moveInto(toml::table& table, const toml::key& key, toml::node& node) {
    node.visit([&](auto& value) { table.insert_or_assign(key, std::move(value)); });
}

void mergeNamed(toml::table& into, toml::table& from, const std::string& section,
                Diagnostics& diagnostics) {
    for (auto&& [key, node] : from) {
        const auto known = into.find(key.str());
        if (known == into.end())
            moveInto(into, key, node);
        else
            diagnostics.error(placeOf(key, node),
                              fmt::format("two {}s are named '{}'; the other is at {}", section,
                                          printable(std::string(key.str())),
                                          placeOf(known->first, known->second).text()));
    }
}

/// The including file decides; two that it includes may not contradict each other.
void mergeSettings(toml::table& into, toml::table& from, const std::string& intoFile,
                   Diagnostics& diagnostics) {
    for (auto&& [key, node] : from) {
        const auto known = into.find(key.str());
        if (known == into.end())
            moveInto(into, key, node);
        else if (const SourceLocation other = placeOf(known->first, known->second);
                 other.file != intoFile)
            diagnostics.error(placeOf(key, node),
                              fmt::format("{} is given already, at {}",
                                          printable(std::string(key.str())), other.text()));
    }
}

/// What has the wrong type is complained about where it stays.
void merge(toml::table& into, toml::table& from, const std::string& intoFile,
           Diagnostics& diagnostics) {
    for (auto&& [key, node] : from) {
        const std::string section(key.str());
        if (section == "scene") continue;
        toml::node* own = into.get(section);
        if (own == nullptr) {
            moveInto(into, key, node);
        } else if (isListSection(section) && own->is_array() && node.is_array()) {
            for (toml::node& entry : *node.as_array())
                entry.visit([&](auto& value) { own->as_array()->push_back(std::move(value)); });
        } else if (isNamedSection(section) && own->is_table() && node.is_table()) {
            mergeNamed(*own->as_table(), *node.as_table(), section, diagnostics);
        } else if (section == "render" && own->is_table() && node.is_table()) {
            mergeSettings(*own->as_table(), *node.as_table(), intoFile, diagnostics);
        } else if (section == "environment") {
            if (const SourceLocation other = placeOf(*own); other.file != intoFile)
                diagnostics.error(
                    placeOf(key, node),
                    fmt::format("there is an environment already, at {}", other.text()));
        }
    }
}

}  // namespace

std::optional<toml::table> IncludedFiles::load(std::string_view text, const std::string& file,
                                               Diagnostics& diagnostics) {
    std::error_code error;
    read_[fs::weakly_canonical(file, error)] = true;
    return loadFile(text, file, {}, 0, diagnostics);
}

std::optional<toml::table> IncludedFiles::loadFile(std::string_view text, const std::string& file,
                                                   const fs::path& fromScene, int depth,
                                                   Diagnostics& diagnostics) {
    files_[file] = {fromScene, static_cast<int>(files_.size()) + 1};
    std::optional<toml::table> document = parseDocument(text, file, diagnostics);
    if (!document) return {};
    const toml::node* names = (*document)["scene"]["include"].node();
    if (names == nullptr) return document;
    const toml::array* list = names->as_array();
    if (list == nullptr) {
        diagnostics.error(placeOf(*names), "include must be a list, as in [\"parts/hall.toml\"]");
        return document;
    }
    for (const toml::node& name : *list)
        include(name, fromScene, depth + 1, *document, file, diagnostics);
    return document;
}

void IncludedFiles::include(const toml::node& name, const fs::path& fromScene, int depth,
                            toml::table& into, const std::string& intoFile,
                            Diagnostics& diagnostics) {
    const SourceLocation where = placeOf(name);
    const auto text = name.value_exact<std::string>();
    const auto refuse = [&](const std::string& why) {
        diagnostics.error(where, text ? fmt::format("'{}': {}", printable(*text), why) : why);
    };
    if (!text) return refuse("an included file is a name in quotes");
    if (!endsWith(*text, ".toml")) return refuse("an included file is a scene (.toml)");
    if (depth > kMaxIncludeDepth)
        return refuse(fmt::format("files include each other more than {} deep", kMaxIncludeDepth));
    if (files_.size() > kMaxIncludes)
        return refuse(fmt::format("more than {} files are included", kMaxIncludes));
    std::string content;
    const std::string relative = (fromScene / *text).lexically_normal().generic_string();
    fs::path path;
    try {
        path = resolveInside(folder_, relative);
        content = readFile(path, kMaxSceneBytes);
    } catch (const std::invalid_argument& e) {
        return refuse(e.what());
    } catch (const InputError& e) {
        for (const Diagnostic& d : e.diagnostics().list()) refuse(d.message);
        return;
    }
    std::error_code error;
    const auto [known, isNew] = read_.emplace(fs::weakly_canonical(path, error), true);
    if (!isNew) {
        if (known->second) refuse("this file includes itself");
        return;  // twice is once
    }
    auto document =
        loadFile(content, path.string(), fs::path(relative).parent_path(), depth, diagnostics);
    known->second = false;
    if (document) merge(into, *document, intoFile, diagnostics);
}

std::string IncludedFiles::fromSceneFolder(const std::string& name,
                                           const SourceLocation& where) const {
    const auto file = files_.find(where.file);
    if (file == files_.end() || file->second.folder.empty()) return name;
    return (file->second.folder / name).lexically_normal().generic_string();
}

int IncludedFiles::rank(const std::string& file) const {
    const auto found = files_.find(file);
    return found == files_.end() ? 0 : found->second.rank;
}

}  // namespace vitrine
