// SPDX-License-Identifier: MIT
// The scene that the window shows: its file, what has been changed by hand, and the files that it
// depends on. Keeps the last good state whatever becomes of the files. Draws nothing.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/session/session.hpp"
#include "app/viewer/edits.hpp"
#include "app/viewer/file_watch.hpp"
#include "import/model_library.hpp"

namespace vitrine {

class OpenScene {
  public:
    /// What a call of follow() has found.
    enum class Change {
        kNone,
        kNumbers,  ///< moment() gives other numbers for the same meshes, textures and snippets
        kAll,      ///< loaded() is another scene
    };

    /// Throws InputError if the scene cannot be shown. `context` measures fields, is current and
    /// outlives this.
    OpenScene(const Context& context, std::string file, std::vector<std::string> overrides);

    /// Shows another file from now on, without edits and without the command line's assignments.
    /// Returns what is wrong if it cannot be read; then all stays as it was.
    [[nodiscard]] Diagnostics open(std::string file);

    /// Looks at the edits, and at the files if `files`.
    Change follow(bool files);

    [[nodiscard]] const LoadedScene& loaded() const { return *loaded_; }
    [[nodiscard]] const std::string& file() const { return file_; }
    /// The files read for the last attempt to load.
    [[nodiscard]] const std::set<std::filesystem::path>& files() const { return files_; }
    /// The scene at a time, packed for Frame::update(). Throws InputError.
    [[nodiscard]] PackedMoment moment(float time);
    /// The scene of the last moment().
    [[nodiscard]] const Scene& posed() const { return posed_; }
    /// Where the last key of the animations is, s; 0: nothing moves by itself.
    [[nodiscard]] float duration() const;

    /// `--set` assignments: of the command line, then of the edits.
    [[nodiscard]] std::vector<std::string> overrides() const;
    /// Whether the file is a scene, which can take the edits.
    [[nodiscard]] bool canSave() const;
    /// Writes the edits into the file. Returns a sentence about it.
    std::string save();
    /// Writes the scene with the edits into another file of the same folder, and goes on with that
    /// one: file() tells whether it was possible. Of a model or a field the scene that is put
    /// around it. Returns a sentence about it.
    std::string saveAs(const std::string& file);

    /// What is wrong with the files as they are now; empty: nothing.
    [[nodiscard]] const Diagnostics& problems() const { return problems_; }
    void report(const InputError& error) { problems_ = error.diagnostics(); }

    Edits edits;

  private:
    bool load();
    bool takeNumbers();
    [[nodiscard]] std::string editedText(Diagnostics& diagnostics) const;

    std::string file_;
    std::vector<std::string> given_;
    FieldProber prober_;
    FileWatch watch_;
    std::set<std::filesystem::path> files_;
    std::unique_ptr<LoadedScene> loaded_;
    ModelLibrary models_;
    Scene posed_;
    Diagnostics problems_;
    int editsTaken_ = 0;
    std::vector<std::string> taken_;  ///< assignments in `loaded_`
};

/// Whether a file is a scene, a model or a field, by its name.
bool canOpen(const std::string& file);

/// Whether these assignments change numbers only, so that nothing has to be read or built again.
bool changesOnlyNumbers(const std::vector<std::string>& before,
                        const std::vector<std::string>& after);

}  // namespace vitrine
