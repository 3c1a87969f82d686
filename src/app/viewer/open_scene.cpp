// SPDX-License-Identifier: MIT
#include "app/viewer/open_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <future>
#include <iterator>

#include "app/session/bare_file.hpp"
#include "base/file.hpp"
#include "base/text.hpp"
#include "import/import_models.hpp"
#include "scene/edit_text.hpp"
#include "scene/parse.hpp"
#include "scene/pose.hpp"

namespace vitrine {
namespace {

constexpr uint64_t kMaxSceneBytes = 16u << 20;

bool isScene(const std::string& file) {
    return endsWith(file, ".toml");
}

/// Whether what was read for one is that of the other.
bool fits(const Scene& a, const Scene& b) {
    const auto same = [](const auto& x, const auto& y) {
        return std::equal(x.begin(), x.end(), y.begin(), y.end(),
                          [](const auto& i, const auto& k) { return i.name == k.name; });
    };
    return same(a.shapes, b.shapes) && same(a.materials, b.materials);
}

bool isOfCamera(const AnimationTrack& track) {
    return track.target.object == AnimationTarget::Object::kCamera;
}

constexpr float kSnippetSeconds = 10;  // of a time that has no end, to begin with

}  // namespace

bool canOpen(const std::string& file) {
    return isScene(file) || isBareFile(file);
}

bool changesOnlyNumbers(const std::vector<std::string>& before,
                        const std::vector<std::string>& after) {
    std::vector<std::string> a = before, b = after, changed;
    std::sort(a.begin(), a.end());
    std::sort(b.begin(), b.end());
    std::set_symmetric_difference(a.begin(), a.end(), b.begin(), b.end(),
                                  std::back_inserter(changed));
    // The surroundings may be a picture that is computed from their numbers.
    return std::all_of(changed.begin(), changed.end(), [](const std::string& assignment) {
        const std::string section = assignment.substr(0, assignment.find('.'));
        return section == "render" || section == "camera" || section == "light" ||
               section == "material" || section == "node";
    });
}

std::vector<std::string> OpenScene::overrides() const {
    std::vector<std::string> all = given_;
    for (std::string& assignment : edits.assignments()) all.push_back(std::move(assignment));
    return all;
}

LoadRequest OpenScene::request() {
    editsSeen_ = edits.version();
    const bool sameText = loaded_ != nullptr && !textChanged_ && isScene(file_) &&
                          changesOnlyNumbers(taken_, overrides());
    waiting_ = LoadRequest{file_, overrides(), ++requests_, editsSeen_, sameText, false};
    return *waiting_;
}

LoadRequest OpenScene::requestFor(const std::string& otherFile) {
    LoadRequest request;
    request.file = otherFile;
    request.otherFile = true;
    return request;
}

bool OpenScene::take(LoadResult result, const Diagnostics& problems) {
    result.problems.append(problems);
    const bool good = !result.problems.hasErrors();
    const LoadRequest& request = result.request;
    // Another request may have been made since; what is wrong now, it will tell.
    const bool latest = request.otherFile || (waiting_ && waiting_->number == request.number);
    if (!good && (request.otherFile || !latest)) return false;
    if (request.otherFile) {
        file_ = request.file;
        given_.clear();
        edits.clear();
    }
    if (latest) {
        waiting_.reset();
        textChanged_ = false;
        watch_.watch(std::move(result.files));
        // Edits that were made meanwhile come next.
        editsSeen_ = request.otherFile ? edits.version() : request.editsVersion;
    }
    problems_ = good ? Diagnostics() : std::move(result.problems);
    if (!good) return false;
    loaded_ = std::move(result.scene);
    models_ = std::move(result.models);
    plain_.reset();
    taken_ = request.overrides;
    return true;
}

/// The scene's text, read again, with assignments.
Scene OpenScene::sceneWith(const std::vector<std::string>& assignments) {
    Diagnostics diagnostics;
    Scene scene = loaded_->text.empty()
                      ? loadScene(file_, assignments, diagnostics)
                      : parseScene(loaded_->text, file_, assignments, diagnostics);
    importModels(scene, models_, diagnostics);
    diagnostics.throwIfErrors();
    return scene;
}

/// Reads the scene's text again, with the edits, and nothing else.
bool OpenScene::takeNumbers() {
    editsSeen_ = edits.version();
    try {
        Scene next = sceneWith(overrides());
        // Changed on the disk a moment ago: the next look at the files finds it.
        if (!fits(next, loaded_->scene)) return false;
        std::swap(loaded_->scene, next);
        try {
            (void)moment(0);
        } catch (const InputError&) {
            std::swap(loaded_->scene, next);
            throw;
        }
        taken_ = overrides();
        problems_ = {};
        return true;
    } catch (const InputError& error) {
        problems_ = error.diagnostics();
        return false;
    }
}

OpenScene::Change OpenScene::follow(bool files) {
    if (files) {
        const std::set<std::filesystem::path> changed = watch_.changed();
        for (const std::filesystem::path& file : changed)
            textChanged_ = textChanged_ || isScene(file.string());
        if (!changed.empty()) return Change::kMustRead;
    }
    if (editsSeen_ == edits.version()) return Change::kNone;
    const std::vector<std::string>& before = waiting_ ? waiting_->overrides : taken_;
    // While the files are broken, numbers of the last good scene cannot be trusted to fit them.
    if (problems_.hasErrors() || !changesOnlyNumbers(before, overrides())) return Change::kMustRead;
    // Numbers do not wait for a snippet; but those that may not fit this scene do, for the next.
    if (waiting_ && !waiting_->sameText) return Change::kNone;
    return takeNumbers() ? Change::kNumbers : Change::kNone;
}

PackedMoment OpenScene::pack(const Scene& posed) const {
    Diagnostics diagnostics;
    PackedMoment moment = packMoment(posed, loaded_->assets, loaded_->packed, diagnostics);
    diagnostics.throwIfErrors();
    return moment;
}

PackedMoment OpenScene::moment(float time) {
    posed_ = loaded_->scene.animations.empty() ? loaded_->scene : poseScene(loaded_->scene, time);
    return pack(posed_);
}

PackedMoment OpenScene::momentWithoutEdits(float time) {
    if (!plain_) {
        Scene scene = sceneWith(given_);
        // Changed on the disk a moment ago, and soon read anew: then the old one will do.
        if (fits(scene, loaded_->scene)) plain_ = std::move(scene);
    }
    if (!plain_) return moment(time);
    plainPosed_ = plain_->animations.empty() ? *plain_ : poseScene(*plain_, time);
    return pack(plainPosed_);
}

TimeSpan OpenScene::timeSpan(size_t camera) const {
    TimeSpan span;
    span.endless = snippetsMove();
    if (span.endless) span.seconds = kSnippetSeconds;
    float last = 0;
    for (const AnimationTrack& track : loaded_->scene.animations) {
        if (isOfCamera(track) && track.target.index != camera) continue;
        span.hasKeys = true;
        span.endless = span.endless || track.loop != LoopMode::kNone;
        last = std::max({last, track.times.back(), track.loopEnd});
    }
    if (last > 0) span.seconds = last;
    return span;
}

bool OpenScene::snippetsMove() const {
    const auto moves = [](const auto& snippet) { return snippet && snippet->usesTime; };
    const Assets& assets = loaded_->assets;
    return std::any_of(assets.fields.begin(), assets.fields.end(), moves) ||
           std::any_of(assets.materials.begin(), assets.materials.end(), moves);
}

bool OpenScene::moves(size_t camera) const {
    const auto& tracks = loaded_->scene.animations;
    return std::any_of(tracks.begin(), tracks.end(), [&](const AnimationTrack& track) {
        return isOfCamera(track) && track.target.index == camera &&
               (track.target.key == "eye" || track.target.key == "target");
    });
}

bool OpenScene::movesAlone(size_t camera) const {
    const auto& tracks = loaded_->scene.animations;
    return moves(camera) && !snippetsMove() &&
           std::all_of(tracks.begin(), tracks.end(), isOfCamera);
}

bool OpenScene::canSave() const {
    return isScene(file_);
}

/// The scene's file, or what stands for it, with the edits in it.
std::string OpenScene::editedText(Diagnostics& diagnostics) const {
    std::string text;
    if (canSave()) {
        text = readFile(file_, kMaxSceneBytes);
    } else {
        // On a thread of its own, whose OpenGL context takes no other one's place.
        text = std::async(std::launch::async, [&] {
                   ModelLibrary library;
                   FieldProber prober;
                   return sceneAround(file_, library, prober, diagnostics).value_or("");
               }).get();
    }
    return editSceneText(text, file_, edits.assignments(), diagnostics);
}

std::string OpenScene::save() {
    if (edits.empty()) return "nothing has been changed";
    if (!canSave()) return "only scenes (.toml) can be saved; \"Save as\" makes one of this";
    try {
        Diagnostics diagnostics;
        const std::string text = editedText(diagnostics);
        if (diagnostics.hasErrors()) return "not saved: " + diagnostics.text();
        if (text != readFile(file_, kMaxSceneBytes)) writeFileAtomically(file_, text);
        const size_t values = edits.assignments().size();
        edits.clear();
        return fmt::format("saved {} value{} to {}", values, values == 1 ? "" : "s", file_);
    } catch (const std::exception& error) {
        return fmt::format("not saved: {}", error.what());
    }
}

std::string OpenScene::saveAs(const std::string& file) {
    if (waiting_) return "not saved: the scene is still being read";
    try {
        Diagnostics diagnostics;
        const std::string text = editedText(diagnostics);
        if (diagnostics.hasErrors()) return "not saved: " + diagnostics.text();
        writeFileAtomically(file, text);
    } catch (const std::exception& error) {
        return fmt::format("not saved: {}", error.what());
    }
    file_ = file;
    edits.clear();
    // In no state that is known: the next look at the files reads it, and all that it names.
    watch_.watch({{file_, {}}});
    return "saved as " + file_;
}

}  // namespace vitrine
