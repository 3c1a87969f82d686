// SPDX-License-Identifier: MIT
// From a file name to something that can be drawn; what the command line, the window and the web
// page have in common.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/session/field_prober.hpp"
#include "frame/frame.hpp"
#include "gpu/context.hpp"
#include "import/model_library.hpp"
#include "pack/pack_scene.hpp"

namespace vitrine {

/// A scene with everything it needs, read and packed.
struct LoadedScene {
    Scene scene;
    Assets assets;
    PackedScene packed;
    std::string text;  ///< of the scene that has been made around a bare file; "": of none
};

/// What has been read and built for a scene, for the next load of it: only what has changed on the
/// disk is made again. Warnings about what has not changed are given once.
struct SceneCache {
    ModelLibrary models;
    AssetCache assets;
    void sweep() {
        models.sweep();
        assets.sweep();
    }
};

/// Reads a scene file, or a bare model or field. All that is wrong goes to `diagnostics`. Throws
/// InputError if the file itself cannot be read. Fields are measured by `prober`, which may be kept
/// for the next load.
LoadedScene loadAll(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                    FieldProber& prober, Diagnostics& diagnostics);
LoadedScene loadAll(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                    FieldProber& prober, SceneCache& cache, Diagnostics& diagnostics);
/// With a prober of its own, that measures what is needed.
LoadedScene loadAll(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                    Diagnostics& diagnostics);

/// Adds what the GLSL compiler has to say about each snippet. Throws MachineError without OpenGL,
/// unless the scene has errors already, which are worth more.
void compileSnippets(const LoadedScene& loaded, FieldProber& prober, Diagnostics& diagnostics);

/// The camera of this name, or the first one for "". Throws UsageError if there is none such.
const Camera& findCamera(const Scene& scene, const std::string& name);

struct PictureRequest {
    int width = 640, height = 400;
    std::string camera;
    float time = 0;
    std::optional<int> samples, seed;
    View view = View::kColor;
    int treeLevel = 0;  ///< of View::kBvh
    Primary primary = Primary::kRaster;
    RenderMode mode = RenderMode::kHybrid;
};

/// Draws pictures of one scene without a display.
class Renderer {
  public:
    /// Makes the GL context. Throws MachineError if there is none, InputError if a snippet does
    /// not compile, with the mistakes of all snippets.
    Renderer(const LoadedScene& loaded, Backend backend, bool counters);

    /// From now on draws a scene that differs from the loaded one in numbers only: places,
    /// materials, parameters, lights, settings. Throws InputError if something is wrong with them.
    void change(Scene scene);

    /// The scene at the request's time. `progress` is called after each sample with the samples
    /// done and to do.
    ImageRgba8 draw(const PictureRequest& request, const std::function<void(int, int)>& progress);
    /// The same picture as data.
    LayerImages drawLayers(const PictureRequest& request,
                           const std::function<void(int, int)>& progress);
    [[nodiscard]] FrameStatistics statistics() { return frame_->statistics(); }
    [[nodiscard]] const GpuInfo& gpu() const { return context_->info(); }
    [[nodiscard]] Backend backend() const { return frame_->backend(); }
    [[nodiscard]] double compileSeconds() const { return frame_->compileSeconds(); }

  private:
    const Scene& sceneAt(float time);
    void show(const Scene& scene);
    /// Leaves the samples in the frame.
    void drawSamples(const PictureRequest& request, bool layers,
                     const std::function<void(int, int)>& progress);

    const LoadedScene& loaded_;
    std::optional<Scene> changed_;
    /// What the frame shows, if things move.
    Scene posed_;
    std::optional<float> posedTime_;
    std::unique_ptr<Context> context_;
    std::unique_ptr<Frame> frame_;
};

}  // namespace vitrine
