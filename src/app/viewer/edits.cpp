// SPDX-License-Identifier: MIT
#include "app/viewer/edits.hpp"

#include <utility>

namespace vitrine {
namespace {

constexpr size_t kMostSteps = 1000;

}  // namespace

void Edits::remember(int gesture) {
    ++version_;
    future_.clear();
    const bool goesOn = gesture != 0 && gesture == gesture_;
    gesture_ = gesture;
    if (goesOn) return;
    past_.push_back(values_);
    if (past_.size() > kMostSteps) past_.erase(past_.begin());
}

void Edits::set(const std::string& key, const std::string& value, int gesture) {
    const auto known = values_.find(key);
    if (known != values_.end() && known->second == value) return;
    remember(gesture);
    values_[key] = value;
}

void Edits::reset(const std::string& key) {
    if (!has(key)) return;
    remember(0);
    values_.erase(key);
}

bool Edits::undo() {
    if (past_.empty()) return false;
    future_.push_back(std::exchange(values_, past_.back()));
    past_.pop_back();
    gesture_ = 0;
    ++version_;
    return true;
}

bool Edits::redo() {
    if (future_.empty()) return false;
    past_.push_back(std::exchange(values_, future_.back()));
    future_.pop_back();
    gesture_ = 0;
    ++version_;
    return true;
}

std::vector<std::string> Edits::assignments() const {
    std::vector<std::string> list;
    for (const auto& [key, value] : values_) list.push_back(key + "=" + value);
    return list;
}

void Edits::clear() {
    values_.clear();
    past_.clear();
    future_.clear();
    gesture_ = 0;
    ++version_;
}

}  // namespace vitrine
