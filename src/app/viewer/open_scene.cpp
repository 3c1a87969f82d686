// SPDX-License-Identifier: MIT
#include "app/viewer/open_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <tuple>

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

OpenScene::OpenScene(const Context& context, std::string file, std::vector<std::string> overrides)
    : file_(std::move(file)),
      given_(std::move(overrides)),
      prober_(FieldProber::Thoroughness::kNeeded, &context) {
    if (!load()) problems_.throwIfErrors();
}

std::vector<std::string> OpenScene::overrides() const {
    std::vector<std::string> all = given_;
    for (std::string& assignment : edits.assignments()) all.push_back(std::move(assignment));
    return all;
}

bool OpenScene::load() {
    Diagnostics diagnostics;
    auto next = std::make_unique<LoadedScene>();
    {
        const ReadRecord record;
        try {
            *next = loadAll(file_, overrides(), prober_, diagnostics);
        } catch (const InputError& error) {
            diagnostics.append(error.diagnostics());
        }
        files_ = record.files();
    }
    files_.insert(file_);
    watch_.watch(files_);
    editsTaken_ = edits.version();
    problems_ = diagnostics;
    if (diagnostics.hasErrors()) return false;
    problems_ = {};
    loaded_ = std::move(next);
    taken_ = overrides();
    models_ = {};
    return true;
}

/// Reads the scene's text again, with the edits, and nothing else.
bool OpenScene::takeNumbers() {
    Diagnostics diagnostics;
    editsTaken_ = edits.version();
    Scene next = loadScene(file_, overrides(), diagnostics);
    importModels(next, models_, diagnostics);
    if (!diagnostics.hasErrors()) {
        std::swap(loaded_->scene, next);
        try {
            (void)moment(0);
            taken_ = overrides();
            problems_ = {};
            return true;
        } catch (const InputError& error) {
            diagnostics = error.diagnostics();
            std::swap(loaded_->scene, next);
        }
    }
    problems_ = diagnostics;
    return false;
}

Diagnostics OpenScene::open(std::string file) {
    Diagnostics problems;
    if (!canOpen(file)) {
        problems.error({file}, "not a file that can be shown: .toml, .glb, .gltf, .obj, .sdf.glsl");
        return problems;
    }
    const auto before =
        std::tuple(file_, given_, edits, watch_, files_, problems_, editsTaken_, taken_);
    file_ = std::move(file);
    given_.clear();
    edits.clear();
    if (load()) return problems;
    problems = std::move(problems_);
    std::tie(file_, given_, edits, watch_, files_, problems_, editsTaken_, taken_) = before;
    return problems;
}

OpenScene::Change OpenScene::follow(bool files) {
    const bool filesChanged = files && !watch_.changed().empty();
    if (!filesChanged && editsTaken_ == edits.version()) return Change::kNone;
    // While the files are broken, numbers of the last good scene cannot be trusted to fit them.
    if (filesChanged || problems_.hasErrors() || !isScene(file_) ||
        !changesOnlyNumbers(taken_, overrides()))
        return load() ? Change::kAll : Change::kNone;
    return takeNumbers() ? Change::kNumbers : Change::kNone;
}

PackedMoment OpenScene::moment(float time) {
    posed_ = loaded_->scene.animations.empty() ? loaded_->scene : poseScene(loaded_->scene, time);
    Diagnostics diagnostics;
    PackedMoment moment = packMoment(posed_, loaded_->assets, loaded_->packed, diagnostics);
    diagnostics.throwIfErrors();
    return moment;
}

float OpenScene::duration() const {
    float last = 0;
    for (const AnimationTrack& track : loaded_->scene.animations)
        last = std::max({last, track.times.back(), track.loopEnd});
    return last;
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
        ModelLibrary library;
        FieldProber prober;
        text = sceneAround(file_, library, prober, diagnostics).value_or("");
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
    files_.insert(file_);
    watch_.watch(files_);
    return "saved as " + file_;
}

}  // namespace vitrine
