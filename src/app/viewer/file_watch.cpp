// SPDX-License-Identifier: MIT
#include "app/viewer/file_watch.hpp"

namespace vitrine {

std::set<std::filesystem::path> FileWatch::changed() {
    std::set<std::filesystem::path> list;
    for (auto& [file, stamp] : stamps_) {
        const FileStamp now = stampOf(file);
        if (now == stamp) continue;
        stamp = now;
        list.insert(file);
    }
    return list;
}

}  // namespace vitrine
