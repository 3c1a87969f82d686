// SPDX-License-Identifier: MIT
#include "app/session/session.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/session/bare_file.hpp"
#include "base/text.hpp"
#include "frame/check_snippets.hpp"
#include "import/import_models.hpp"
#include "scene/parse.hpp"
#include "scene/pose.hpp"

namespace vitrine {

LoadedScene loadAll(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                    FieldProber& prober, SceneCache& cache, Diagnostics& diagnostics) {
    LoadedScene loaded;
    ModelLibrary& library = cache.models;
    if (isBareFile(file)) {
        const auto text = sceneAround(file, library, prober, diagnostics);
        if (!text) return loaded;
        loaded.text = *text;
        loaded.scene = parseScene(loaded.text, file.string(), overrides, diagnostics);
    } else if (endsWith(file.string(), ".toml")) {
        loaded.scene = loadScene(file, overrides, diagnostics);
    } else {
        throw InputError({file.string()},
                         "not a scene (.toml), a model (.gltf, .glb, .obj) or a field (.sdf.glsl)");
    }
    importModels(loaded.scene, library, diagnostics);
    loaded.assets = loadAssets(loaded.scene, cache.assets, diagnostics);
    prober.measure(loaded.scene, loaded.assets, diagnostics);
    loaded.packed = packScene(loaded.scene, loaded.assets, diagnostics);
    return loaded;
}

LoadedScene loadAll(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                    FieldProber& prober, Diagnostics& diagnostics) {
    SceneCache cache;
    return loadAll(file, overrides, prober, cache, diagnostics);
}

LoadedScene loadAll(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                    Diagnostics& diagnostics) {
    FieldProber prober;
    return loadAll(file, overrides, prober, diagnostics);
}

void compileSnippets(const LoadedScene& loaded, FieldProber& prober, Diagnostics& diagnostics) {
    const auto there = [](const auto& list) {
        return std::any_of(list.begin(), list.end(), [](const auto& s) { return s != nullptr; });
    };
    if (!there(loaded.assets.fields) && !there(loaded.assets.materials)) return;
    if (const Context* context = prober.context()) {
        diagnostics.append(checkSnippets(*context, loaded.assets));
        return;
    }
    if (!diagnostics.hasErrors()) throw MachineError(prober.excuse());
    diagnostics.warning({loaded.scene.file},
                        fmt::format("the snippets were not compiled: {}", prober.excuse()));
    if (there(loaded.assets.fields))
        diagnostics.warning({loaded.scene.file},
                            "nor were the fields measured: their steps may be too long");
}

const Camera& findCamera(const Scene& scene, const std::string& name) {
    if (name.empty()) return scene.cameras.front();
    std::vector<std::string> names;
    for (const Camera& camera : scene.cameras) {
        if (camera.name == name) return camera;
        names.push_back(camera.name);
    }
    throw UsageError(fmt::format("--camera: the scene has no camera '{}'{}; it has '{}'", name,
                                 didYouMean(name, names), fmt::join(names, "', '")));
}

Renderer::Renderer(const LoadedScene& loaded, Backend backend, bool counters)
    : loaded_(loaded), context_(Context::createHeadless()) {
    frame_ = std::make_unique<Frame>(*context_, loaded.packed, backend, counters);
}

void Renderer::show(const Scene& scene) {
    Diagnostics diagnostics;
    const PackedMoment moment = packMoment(scene, loaded_.assets, loaded_.packed, diagnostics);
    diagnostics.throwIfErrors();
    frame_->update(moment);
}

void Renderer::change(Scene scene) {
    if (scene.animations.empty()) show(scene);
    changed_ = std::move(scene);
    posedTime_.reset();
}

const Scene& Renderer::sceneAt(float time) {
    const Scene& scene = changed_ ? *changed_ : loaded_.scene;
    if (scene.animations.empty()) return scene;
    if (posedTime_ != time) {
        posedTime_.reset();  // show() may throw
        posed_ = poseScene(scene, time);
        show(posed_);
        posedTime_ = time;
    }
    return posed_;
}

ImageRgba8 Renderer::draw(const PictureRequest& request,
                          const std::function<void(int, int)>& progress) {
    drawSamples(request, false, progress);
    return frame_->picture();
}

LayerImages Renderer::drawLayers(const PictureRequest& request,
                                 const std::function<void(int, int)>& progress) {
    drawSamples(request, true, progress);
    return frame_->layers();
}

void Renderer::drawSamples(const PictureRequest& request, bool layers,
                           const std::function<void(int, int)>& progress) {
    const Scene& scene = sceneAt(request.time);
    const RenderSettings& settings = scene.render;
    FrameRequest frame;
    frame.width = request.width;
    frame.height = request.height;
    frame.camera = findCamera(scene, request.camera);
    frame.time = request.time;
    frame.samples = request.samples.value_or(settings.samples);
    frame.bounces = settings.bounces;
    frame.ssaa = settings.ssaa;
    frame.seed = request.seed.value_or(settings.seed);
    frame.view = request.view;
    frame.treeLevel = request.treeLevel;
    frame.primary = request.primary;
    frame.layers = layers;
    frame.mode = request.mode;
    try {
        frame_->begin(frame);
        for (int i = 0; i < frame.samples; ++i) {
            frame_->drawSample();
            if (progress) progress(i + 1, frame.samples);
        }
    } catch (const InputError&) {
        // One program reports one snippet's mistakes at best: ask each snippet by itself.
        checkSnippets(*context_, loaded_.assets).throwIfErrors();
        throw;
    }
}

}  // namespace vitrine
