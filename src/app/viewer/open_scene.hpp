// SPDX-License-Identifier: MIT
// The scene that the window shows: its file, what has been changed by hand, and the files that it
// depends on. Keeps the last good state whatever becomes of the files. Draws nothing, and waits for
// nothing: who has it is told when something must be read, and reads it (load.hpp).
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/viewer/edits.hpp"
#include "app/viewer/file_watch.hpp"
#include "app/viewer/load.hpp"
#include "app/viewer/timeline.hpp"

namespace vitrine {

class OpenScene {
  public:
    /// What a call of follow() has found.
    enum class Change {
        kNone,
        kNumbers,   ///< moment() gives other numbers for the same meshes, textures and snippets
        kMustRead,  ///< more than numbers, or the files: carry out request()
    };

    /// Nothing is there until the first take().
    OpenScene(std::string file, std::vector<std::string> overrides)
        : file_(std::move(file)), given_(std::move(overrides)) {}

    /// Looks at the edits, and at the files if `files`.
    Change follow(bool files);
    /// What is to be read: the file with the edits as they are now. From now on only what comes
    /// after it is a change.
    [[nodiscard]] LoadRequest request();
    /// The same for another file, without edits and without the command line's assignments.
    [[nodiscard]] static LoadRequest requestFor(const std::string& otherFile);
    /// A request has not been answered.
    [[nodiscard]] bool isWaiting() const { return waiting_.has_value(); }
    /// Takes what was read for a request. With `problems` of its snippets, or of its own, the scene
    /// before stays; and if it was for another file, all stays as it was. Returns whether there is
    /// another scene now.
    bool take(LoadResult result, const Diagnostics& problems);

    [[nodiscard]] const LoadedScene& loaded() const { return *loaded_; }
    /// The same, for other threads, which leave LoadedScene::scene alone.
    [[nodiscard]] std::shared_ptr<const LoadedScene> shared() const { return loaded_; }
    [[nodiscard]] const std::string& file() const { return file_; }
    /// The scene at a time, packed for Frame::update(). Throws InputError.
    [[nodiscard]] PackedMoment moment(float time);
    /// The same as the file and the command line say, without the edits; but for pictures of the
    /// surroundings, which are those of loaded().
    [[nodiscard]] PackedMoment momentWithoutEdits(float time);
    /// The scene of the last momentWithoutEdits().
    [[nodiscard]] const Scene& posedWithoutEdits() const { return plain_ ? plainPosed_ : posed_; }
    /// The scene of the last moment().
    [[nodiscard]] const Scene& posed() const { return posed_; }
    /// What there is to play, seen with one of the cameras: the ways of the others do not count.
    [[nodiscard]] TimeSpan timeSpan(size_t camera) const;
    /// Whether a camera goes by itself, and whether nothing else does.
    [[nodiscard]] bool moves(size_t camera) const;
    [[nodiscard]] bool movesAlone(size_t camera) const;

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
    bool takeNumbers();
    [[nodiscard]] Scene sceneWith(const std::vector<std::string>& assignments);
    [[nodiscard]] bool snippetsMove() const;
    [[nodiscard]] PackedMoment pack(const Scene& posed) const;
    [[nodiscard]] std::string editedText(Diagnostics& diagnostics) const;

    std::string file_;
    std::vector<std::string> given_;
    FileWatch watch_;
    std::shared_ptr<LoadedScene> loaded_;
    ModelLibrary models_;
    Scene posed_;
    std::optional<Scene> plain_;  ///< without edits; read when it is asked for
    Scene plainPosed_;
    Diagnostics problems_;
    int editsSeen_ = 0;                   ///< the version that is shown or asked for
    std::vector<std::string> taken_;      ///< assignments in `loaded_`
    std::optional<LoadRequest> waiting_;  ///< asked for, not taken yet
    bool textChanged_ = false;            ///< on the disk, since it was taken last
    int requests_ = 0;
};

/// Whether a file is a scene, a model or a field, by its name.
bool canOpen(const std::string& file);

/// Whether these assignments change numbers only, so that nothing has to be read or built again.
bool changesOnlyNumbers(const std::vector<std::string>& before,
                        const std::vector<std::string>& after);

}  // namespace vitrine
