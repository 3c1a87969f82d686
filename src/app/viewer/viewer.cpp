// SPDX-License-Identifier: MIT
#include "app/viewer/viewer.hpp"

#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <chrono>

#include "app/viewer/camera_control.hpp"
#include "app/viewer/panel.hpp"
#include "app/viewer/stage.hpp"
#include "gpu/window.hpp"

namespace vitrine {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kBudget = 0.080;      // s for a frame while something moves
constexpr double kRestSeconds = 0.15;  // of quiet until the fine picture begins

class Viewer {
  public:
    explicit Viewer(const ViewOptions& options)
        : options_(options),
          window_(Window::open(options.width, options.height, "Vitrine")),
          stage_(window_->context()) {
        load();
        camera_ = findCamera(loaded_->scene, options.camera);
        home_ = camera_;
    }

    int run() {
        while (!window_->shouldClose()) step();
        return 0;
    }

  private:
    void load() {
        Diagnostics diagnostics;
        std::vector<std::string> overrides = options_.overrides;
        for (const std::string& a : edits_.assignments()) overrides.push_back(a);
        auto next = std::make_unique<LoadedScene>(loadAll(options_.file, overrides, diagnostics));
        if (diagnostics.hasErrors()) {
            problems_ = diagnostics.text();
            if (loaded_ == nullptr) diagnostics.throwIfErrors();
            return;
        }
        problems_.clear();
        const bool first = loaded_ == nullptr;
        loaded_ = std::move(next);
        stage_.setScene(*loaded_, !first);
        editsShown_ = edits_.version();
    }

    void step() {
        const bool busy = moving_ || !stage_.finished() || stage_.empty();
        window_->begin(busy ? 0 : 0.1);
        const auto now = Clock::now();
        const float elapsed = std::chrono::duration<float>(now - before_).count();
        before_ = now;
        interface();
        steer(elapsed);
        if (edits_.version() != editsShown_) {
            editsShown_ = edits_.version();
            load();
            lastMove_ = now;
        }
        moving_ = std::chrono::duration<double>(now - lastMove_).count() < kRestSeconds;
        Stage::Wish wish;
        wish.width = std::max(1, window_->width() - panelWidth());
        wish.height = window_->height();
        wish.camera = camera_;
        const RenderSettings& settings = loaded_->scene.render;
        wish.samples = settings.samples;
        wish.bounces = settings.bounces;
        wish.ssaa = settings.ssaa;
        wish.view = view_;
        wish.moving = moving_;
        stage_.draw(wish, kBudget);
        window_->clear();
        if (stage_.picture() != nullptr)
            window_->show(*stage_.picture(), {0, 0, wish.width, wish.height});
        window_->end();
    }

    [[nodiscard]] int panelWidth() const {
        return panelShown_ ? static_cast<int>(340 * window_->scale()) : 0;
    }

    void interface() {
        if (!panelShown_) return;
        const auto width = static_cast<float>(panelWidth());
        const ImVec2 size = ImGui::GetIO().DisplaySize;
        ImGui::SetNextWindowPos({size.x - width, 0});
        ImGui::SetNextWindowSize({width, size.y});
        ImGui::Begin("Settings", nullptr,
                     ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                         ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoTitleBar);
        ImGui::TextDisabled("%d of %d samples, %.0f ms, scale %.2f", stage_.samplesDrawn(),
                            loaded_->scene.render.samples, 1000 * stage_.lastSeconds(),
                            stage_.scale());
        if (!problems_.empty()) ImGui::TextWrapped("%s", problems_.c_str());
        panel_.draw(loaded_->scene, loaded_->assets, edits_, selection_);
        ImGui::End();
    }

    void steer(float elapsed) {
        const ImGuiIO& io = ImGui::GetIO();
        const auto touched = [&] { lastMove_ = Clock::now(); };
        if (!io.WantCaptureMouse) {
            const float height = std::max(io.DisplaySize.y, 1.0f);
            const glm::vec2 drag = glm::vec2(io.MouseDelta.x, -io.MouseDelta.y) / height;
            if (ImGui::IsMouseDragging(ImGuiMouseButton_Left, 0) && drag != glm::vec2(0)) {
                tumble(camera_, drag);
                touched();
            } else if ((ImGui::IsMouseDragging(ImGuiMouseButton_Right, 0) ||
                        ImGui::IsMouseDragging(ImGuiMouseButton_Middle, 0)) &&
                       drag != glm::vec2(0)) {
                pan(camera_, drag);
                touched();
            }
            if (io.MouseWheel != 0) {
                const glm::vec2 middle(static_cast<float>(window_->width() - panelWidth()) / 2,
                                       height / 2);
                const glm::vec2 cursor =
                    glm::vec2(io.MousePos.x - middle.x, middle.y - io.MousePos.y) / height;
                dolly(camera_, io.MouseWheel, cursor);
                touched();
            }
        }
        if (!io.WantCaptureKeyboard) {
            glm::vec3 way{0};
            const auto down = [](int key) { return ImGui::IsKeyDown(key) ? 1.0f : 0.0f; };
            way.x = down(GLFW_KEY_D) - down(GLFW_KEY_A);
            way.y = down(GLFW_KEY_E) - down(GLFW_KEY_Q);
            way.z = down(GLFW_KEY_W) - down(GLFW_KEY_S);
            if (way != glm::vec3(0)) {
                walk(camera_, way * std::min(elapsed, 0.1f) * 1.6f, false);
                touched();
            }
            if (ImGui::IsKeyPressed(GLFW_KEY_HOME)) {
                camera_ = home_;
                touched();
            }
            if (ImGui::IsKeyPressed(GLFW_KEY_F11)) window_->setFullScreen(!window_->isFullScreen());
        }
        if (io.KeyCtrl && ImGui::IsKeyPressed(GLFW_KEY_Z)) edits_.undo();
        if (io.KeyCtrl && ImGui::IsKeyPressed(GLFW_KEY_Y)) edits_.redo();
    }

    ViewOptions options_;
    std::unique_ptr<Window> window_;
    Stage stage_;
    std::unique_ptr<LoadedScene> loaded_;
    Camera camera_, home_;
    Edits edits_;
    int editsShown_ = 0;
    Panel panel_;
    Selection selection_;
    View view_ = View::kColor;
    std::string problems_;
    bool panelShown_ = true, moving_ = false;
    Clock::time_point before_ = Clock::now(), lastMove_{};
};

}  // namespace

int view(const ViewOptions& options) {
    return Viewer(options).run();
}

}  // namespace vitrine
