// SPDX-License-Identifier: MIT
// A scene's document with the files that it includes merged in.
#pragma once

#include <toml++/toml.h>

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "base/error.hpp"

namespace vitrine {

inline constexpr int kMaxIncludeDepth = 16;
inline constexpr size_t kMaxIncludes = 64;

/// Reads files that a scene includes, and remembers them.
class IncludedFiles {
  public:
    /// Nothing outside of `folder`, the scene's, is read.
    explicit IncludedFiles(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// The document of the scene's own text and of all it includes. Nothing, with a diagnostic, if
    /// the text is no TOML.
    std::optional<toml::table> load(std::string_view text, const std::string& file,
                                    Diagnostics& diagnostics);

    /// The name of a file, as it is written at a place, relative to the scene's folder.
    [[nodiscard]] std::string fromSceneFolder(const std::string& name,
                                              const SourceLocation& where) const;
    /// The order in which files were read: 1 for the scene, 0 for what is none (`--set`).
    [[nodiscard]] int rank(const std::string& file) const;

  private:
    struct File {
        std::filesystem::path folder;  ///< from the scene's
        int rank = 0;
    };

    std::optional<toml::table> loadFile(std::string_view text, const std::string& file,
                                        const std::filesystem::path& fromScene, int depth,
                                        Diagnostics& diagnostics);
    void include(const toml::node& name, const std::filesystem::path& fromScene, int depth,
                 toml::table& into, const std::string& intoFile, Diagnostics& diagnostics);

    std::filesystem::path folder_;
    std::map<std::string, File> files_;           ///< by the name that messages give
    std::map<std::filesystem::path, bool> read_;  ///< by canonical path: still being read?
};

}  // namespace vitrine
