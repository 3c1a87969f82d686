// SPDX-License-Identifier: MIT
// Typed values out of the document, with a sentence and a place when they do not fit.
#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "base/text.hpp"
#include "scene/document.hpp"
#include "scene/options.hpp"

namespace vitrine {

/// Each returns false, after a diagnostic, if the node does not hold such a value. Numbers must be
/// finite and in the range; `what` names the option in messages.
bool readNumber(const toml::node& node, const std::string& what, Range range, double& out,
                Diagnostics& diagnostics);
bool readVector(const toml::node& node, const std::string& what, Range range, glm::vec3& out,
                Diagnostics& diagnostics);
/// [r, g, b] linear, or "#rrggbb" in sRGB.
bool readColor(const toml::node& node, const std::string& what, Range range, Color& out,
               Diagnostics& diagnostics);
bool readText(const toml::node& node, const std::string& what, std::string& out,
              Diagnostics& diagnostics);
/// A number, a truth value, a vector or a colour for the parameter of a snippet; `out` has its
/// name.
bool readParameter(const toml::node& node, const std::string& what, ParameterValue& out,
                   Diagnostics& diagnostics);
/// `{ name = value, ... }` of these.
void readParameters(const toml::node& node, const std::string& what,
                    std::vector<ParameterValue>& out, Diagnostics& diagnostics);

/// Tries to read `node` into the member of `object` that `option` names.
template <class T>
void readOption(const toml::node& node, const Option<T>& option, T& object,
                Diagnostics& diagnostics) {
    const std::string& key = option.key;
    const auto read = [&](auto member) {
        using M = decltype(member);
        if constexpr (std::is_same_v<M, float T::*>) {
            double value = 0;
            if (readNumber(node, key, option.range, value, diagnostics))
                object.*member = static_cast<float>(value);
        } else if constexpr (std::is_same_v<M, int T::*>) {
            double value = 0;
            if (!readNumber(node, key, option.range, value, diagnostics)) return;
            if (value != static_cast<int>(value))
                diagnostics.error(placeOf(node), fmt::format("{} must be a whole number", key));
            else
                object.*member = static_cast<int>(value);
        } else if constexpr (std::is_same_v<M, bool T::*>) {
            if (const auto value = node.value_exact<bool>())
                object.*member = *value;
            else
                diagnostics.error(placeOf(node), fmt::format("{} must be true or false", key));
        } else if constexpr (std::is_same_v<M, glm::vec3 T::*>) {
            readVector(node, key, option.range, object.*member, diagnostics);
        } else if constexpr (std::is_same_v<M, Color T::*>) {
            readColor(node, key, option.range, object.*member, diagnostics);
        } else if constexpr (std::is_same_v<M, std::string T::*>) {
            readText(node, key, object.*member, diagnostics);
        } else if constexpr (std::is_same_v<M, Reference T::*>) {
            if (readText(node, key, (object.*member).name, diagnostics))
                (object.*member).where = placeOf(node);
        } else if constexpr (std::is_same_v<M, FileMember<T>>) {
            Reference& file = object.*member.member;
            if (readText(node, key, file.name, diagnostics)) file.where = placeOf(node);
        } else if constexpr (std::is_same_v<M, TextureMember<T>>) {
            Reference& file = (object.*member.member).file;
            if (readText(node, key, file.name, diagnostics)) file.where = placeOf(node);
        } else if constexpr (std::is_same_v<M, ScaleMember<T>>) {
            double value = 0;
            if (node.is_array() && node.as_array()->size() == 3)
                readVector(node, key, option.range, object.*member.member, diagnostics);
            else if (!node.is_number())
                diagnostics.error(
                    placeOf(node),
                    fmt::format("{} must be one number, or three as in [1, 2, 1]", key));
            else if (readNumber(node, key, option.range, value, diagnostics))
                object.*member.member = glm::vec3(static_cast<float>(value));
        } else {
            std::string word;
            if (!readText(node, key, word, diagnostics)) return;
            for (size_t i = 0; i < member.words.size(); ++i)
                if (member.words[i] == word) return member.set(object, static_cast<int>(i));
            diagnostics.error(placeOf(node), fmt::format("{} must be one of '{}', not '{}'{}", key,
                                                         fmt::join(member.words, "', '"), word,
                                                         didYouMean(word, member.words)));
        }
    };
    std::visit(read, option.member);
}

/// Reads every key of `table` that the options name. A key that is neither there nor in
/// `otherKeys`, which the caller reads itself, is an error.
template <class T>
void readTable(const toml::table& table, const std::string& section, const OptionTable<T>& options,
               const std::vector<std::string>& otherKeys, T& object, Diagnostics& diagnostics) {
    for (const auto& [key, node] : table) {
        const std::string name(key.str());
        const Option<T>* known = nullptr;
        for (const Option<T>& option : options)
            if (option.key == name) known = &option;
        if (known != nullptr) {
            readOption(node, *known, object, diagnostics);
            continue;
        }
        std::vector<std::string> keys = otherKeys;
        if (std::find(keys.begin(), keys.end(), name) != keys.end()) continue;
        for (const Option<T>& option : options) keys.push_back(option.key);
        diagnostics.error(placeOf(key, node), fmt::format("unknown key '{}' in {}{}", name, section,
                                                          didYouMean(name, keys)));
    }
}

}  // namespace vitrine
