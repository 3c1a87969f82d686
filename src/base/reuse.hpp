// SPDX-License-Identifier: MIT
// What was made from files, kept for as long as those files are as they were.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "base/file.hpp"

namespace vitrine {

template <class T>
class Reuse {
  public:
    /// What `make` gave for this key before, if no file that it read then has changed; else what it
    /// gives now. Null is not kept. Whoever records what is read (ReadRecord) learns of the files
    /// either way.
    std::shared_ptr<const T> get(const std::string& key,
                                 const std::function<std::shared_ptr<const T>()>& make) {
        const auto known = entries_.find(key);
        if (known != entries_.end() && isAsItWas(known->second.files)) {
            ReadRecord::note(known->second.files);
            known->second.used = true;
            return known->second.value;
        }
        Entry entry;
        {
            const ReadRecord record;
            entry.value = make();
            entry.files = record.files();
        }
        ++made_;
        const std::shared_ptr<const T> value = entry.value;
        if (value == nullptr)
            entries_.erase(key);
        else
            entries_.insert_or_assign(key, std::move(entry));
        return value;
    }
    /// As if it had never been made.
    void forget(const std::string& key) { entries_.erase(key); }
    /// Forgets what nobody has asked for since the last call.
    void sweep() {
        std::erase_if(entries_, [](const auto& entry) { return !entry.second.used; });
        for (auto& [key, entry] : entries_) entry.used = false;
    }
    /// How often something was made.
    [[nodiscard]] int made() const { return made_; }

  private:
    struct Entry {
        std::shared_ptr<const T> value;
        FileStamps files;
        bool used = true;
    };
    static bool isAsItWas(const FileStamps& files) {
        for (const auto& [file, stamp] : files)
            if (stampOf(file) != stamp) return false;
        return true;
    }
    std::map<std::string, Entry> entries_;
    int made_ = 0;
};

}  // namespace vitrine
