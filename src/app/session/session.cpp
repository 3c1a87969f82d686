// SPDX-License-Identifier: MIT
#include "app/session/session.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/session/bare_file.hpp"
#include "base/text.hpp"
#include "frame/check_snippets.hpp"
#include "import/import_models.hpp"
#include "scene/parse.hpp"

namespace vitrine {

LoadedScene loadAll(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                    Diagnostics& diagnostics) {
    LoadedScene loaded;
    ModelLibrary library;
    if (isBareFile(file)) {
        const auto text = sceneAround(file, library, diagnostics);
        if (!text) return loaded;
        loaded.scene = parseScene(*text, file.string(), overrides, diagnostics);
    } else if (endsWith(file.string(), ".toml")) {
        loaded.scene = loadScene(file, overrides, diagnostics);
    } else {
        throw InputError({file.string()},
                         "not a scene (.toml), a model (.gltf, .glb, .obj) or a field (.sdf.glsl)");
    }
    importModels(loaded.scene, library, diagnostics);
    loaded.assets = loadAssets(loaded.scene, diagnostics);
    loaded.packed = packScene(loaded.scene, loaded.assets, diagnostics);
    return loaded;
}

void compileSnippets(const LoadedScene& loaded, Diagnostics& diagnostics) {
    const auto there = [](const auto& list) {
        return std::any_of(list.begin(), list.end(), [](const auto& s) { return s != nullptr; });
    };
    if (!there(loaded.assets.fields) && !there(loaded.assets.materials)) return;
    try {
        diagnostics.append(checkSnippets(*Context::createHeadless(), loaded.assets));
    } catch (const MachineError& error) {
        if (!diagnostics.hasErrors()) throw;
        diagnostics.warning({loaded.scene.file},
                            fmt::format("the snippets were not compiled: {}", error.what()));
    }
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

ImageRgba8 Renderer::draw(const PictureRequest& request,
                          const std::function<void(int, int)>& progress) {
    const RenderSettings& settings = loaded_.scene.render;
    FrameRequest frame;
    frame.width = request.width;
    frame.height = request.height;
    frame.camera = findCamera(loaded_.scene, request.camera);
    frame.time = request.time;
    frame.samples = request.samples.value_or(settings.samples);
    frame.bounces = settings.bounces;
    frame.ssaa = settings.ssaa;
    frame.seed = request.seed.value_or(settings.seed);
    frame.view = request.view;
    frame.primary = request.primary;
    try {
        frame_->begin(frame);
        for (int i = 0; i < frame.samples; ++i) {
            frame_->drawSample();
            if (progress) progress(i + 1, frame.samples);
        }
        return frame_->picture();
    } catch (const InputError&) {
        // One program reports one snippet's mistakes at best: ask each snippet by itself.
        checkSnippets(*context_, loaded_.assets).throwIfErrors();
        throw;
    }
}

}  // namespace vitrine
