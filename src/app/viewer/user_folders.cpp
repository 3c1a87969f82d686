// SPDX-License-Identifier: MIT
#include "app/viewer/user_folders.hpp"

#include <cstdlib>
#include <system_error>

#include "base/error.hpp"
#include "base/file.hpp"

namespace vitrine {
namespace {

namespace fs = std::filesystem;

/// What a variable names; relative paths do not count.
fs::path folderOf(const char* variable) {
    const char* text = std::getenv(variable);
    const fs::path path = text != nullptr ? text : "";
    return path.is_absolute() ? path : fs::path();
}

fs::path folder(const char* variable, const char* below) {
    if (const fs::path path = folderOf(variable); !path.empty()) return path / "vitrine";
    const fs::path home = folderOf("HOME");
    return home.empty() ? fs::path() : home / below / "vitrine";
}

}  // namespace

fs::path stateFolder() {
    return folder("XDG_STATE_HOME", ".local/state");
}

fs::path cacheFolder() {
    return folder("XDG_CACHE_HOME", ".cache");
}

bool keepFile(const fs::path& file, std::string_view bytes) {
    std::error_code error;
    fs::create_directories(file.parent_path(), error);
    if (error) return false;
    try {
        writeFileAtomically(file, bytes);
        return true;
    } catch (const MachineError&) {
        return false;
    }
}

}  // namespace vitrine
