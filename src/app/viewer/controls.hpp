// SPDX-License-Identifier: MIT
// One control an option: the kind of control follows from the option's type and range. Private to
// the panel.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

#include "app/viewer/edits.hpp"
#include "scene/options.hpp"
#include "sdf/snippet.hpp"

namespace vitrine {

/// Draws the rows of tables and sends what is changed to the edits.
class Controls {
  public:
    Controls(Edits& edits, std::string filter) : edits_(edits), filter_(std::move(filter)) {}

    /// The options of an object; `path` is the part of their keys before the last dot.
    template <class T>
    void options(const std::string& path, const OptionTable<T>& table, const T& object) {
        for (const Option<T>& option : table) {
            if (!matches(path, option.key, option.help)) continue;
            const std::string key = path + "." + option.key;
            begin(key, option.key, option.help);
            std::visit([&](const auto& member) { draw(key, option.range, member, object); },
                       option.member);
            end(key);
        }
    }

    /// Whether options() would draw any row.
    template <class T>
    [[nodiscard]] bool finds(const std::string& path, const OptionTable<T>& table) const {
        return std::any_of(table.begin(), table.end(),
                           [&](const auto& o) { return matches(path, o.key, o.help); });
    }
    /// Whether parameters() would.
    [[nodiscard]] bool finds(const std::string& path, const Snippet& snippet) const;

    /// The parameters of a snippet with the values that the scene gives.
    void parameters(const std::string& path, const Snippet& snippet,
                    const std::vector<ParameterValue>& given);

    /// Whether a search for the filter finds this row.
    [[nodiscard]] bool matches(std::string_view path, std::string_view key,
                               std::string_view help) const;
    [[nodiscard]] bool searching() const { return !filter_.empty(); }

  private:
    void begin(const std::string& key, const std::string& label, const std::string& help);
    /// Ends a row; a changed one with a button that takes the change back.
    void end(const std::string& key);
    void send(const std::string& key, const std::string& value);

    void number(const std::string& key, Range range, float value);
    void number(const std::string& key, Range range, int value);
    void vector(const std::string& key, Range range, const float* values, int count);
    void color(const std::string& key, glm::vec3 value, bool bright);
    void flag(const std::string& key, bool value);
    void choice(const std::string& key, const std::vector<std::string>& words, int value);
    void text(const std::string& key, const std::string& value);

    template <class T>
    void draw(const std::string& key, Range range, float T::*m, const T& object) {
        number(key, range, object.*m);
    }
    template <class T>
    void draw(const std::string& key, Range range, int T::*m, const T& object) {
        number(key, range, object.*m);
    }
    template <class T>
    void draw(const std::string& key, Range, bool T::*m, const T& object) {
        flag(key, object.*m);
    }
    template <class T>
    void draw(const std::string& key, Range range, glm::vec3 T::*m, const T& object) {
        vector(key, range, &(object.*m).x, 3);
    }
    template <class T>
    void draw(const std::string& key, Range range, Color T::*m, const T& object) {
        color(key, (object.*m).rgb, range.maximum > 1);
    }
    template <class T>
    void draw(const std::string& key, Range, std::string T::*m, const T& object) {
        text(key, object.*m);
    }
    template <class T>
    void draw(const std::string& key, Range, Reference T::*m, const T& object) {
        text(key, (object.*m).name);
    }
    template <class T>
    void draw(const std::string& key, Range range, const ScaleMember<T>& m, const T& object) {
        vector(key, range, &(object.*m.member).x, 3);
    }
    template <class T>
    void draw(const std::string& key, Range, const TextureMember<T>& m, const T& object) {
        text(key, (object.*m.member).file.name);
    }
    template <class T>
    void draw(const std::string& key, Range, const FileMember<T>& m, const T& object) {
        text(key, (object.*m.member).name);
    }
    template <class T>
    void draw(const std::string& key, Range, const ChoiceMember<T>& m, const T& object) {
        choice(key, m.words, m.get(object));
    }

    Edits& edits_;
    std::string filter_;
};

}  // namespace vitrine
