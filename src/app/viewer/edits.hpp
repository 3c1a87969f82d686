// SPDX-License-Identifier: MIT
// What has been changed by hand since the scene was read, as `--set` assignments, with undo.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace vitrine {

class Edits {
  public:
    /// Sets a key ("material.red.roughness") to a TOML value. Calls with the same `gesture` (one
    /// drag of one slider) are one step of undo; 0 is a step by itself.
    void set(const std::string& key, const std::string& value, int gesture = 0);
    /// A number that no gesture has had.
    int newGesture() { return ++gestures_; }
    /// Back to what the file says.
    void reset(const std::string& key);
    bool undo();
    bool redo();
    [[nodiscard]] bool canUndo() const { return !past_.empty(); }
    [[nodiscard]] bool canRedo() const { return !future_.empty(); }

    /// "key=value", in the order of the keys.
    [[nodiscard]] std::vector<std::string> assignments() const;
    [[nodiscard]] bool has(const std::string& key) const { return values_.count(key) != 0; }
    [[nodiscard]] bool empty() const { return values_.empty(); }
    /// Counts every change, undone ones too.
    [[nodiscard]] int version() const { return version_; }

    /// The values are in the file now: the list is empty, and undo starts anew.
    void clear();

  private:
    using Values = std::map<std::string, std::string>;
    void remember(int gesture);
    Values values_;
    std::vector<Values> past_, future_;
    int gesture_ = 0, gestures_ = 0;
    int version_ = 0;
};

}  // namespace vitrine
