// SPDX-License-Identifier: MIT
// What the window shows to who has named no file: the scenes that come with it as pictures, and the
// files that were opened last.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/viewer/scene_files.hpp"
#include "app/viewer/thumbnails.hpp"

namespace vitrine {

class StartPage : public Tool {
  public:
    /// `scenes`: the folder of the scenes that come with the program; `version`: the program's.
    StartPage(Window& window, SceneView& view, SceneFiles& files, RecentFiles& recent,
              std::string scenes, std::string version)
        : window_(window),
          view_(view),
          files_(files),
          recent_(recent),
          scenes_(std::move(scenes)),
          version_(std::move(version)) {}

    void open();

    void addCommands(std::vector<Command>& list) override;
    void draw(glm::vec2 pictureSize) override;
    void update() override;
    [[nodiscard]] bool holdsScene() const override { return shown_; }
    [[nodiscard]] bool needsScene() const override { return false; }
    bool takeKey(const KeyPress& press) override;

  private:
    struct Tile {
        std::string file, title, description;
        Texture picture;
        bool failed = false;
    };
    void close();
    void readScenes();
    void drawLeft();
    void drawTiles();
    bool drawTile(const Tile& tile, glm::vec2 size);

    Window& window_;
    SceneView& view_;
    SceneFiles& files_;
    RecentFiles& recent_;
    std::string scenes_, version_;
    bool shown_ = false;
    int attempts_ = 0;  ///< of opening a file, when the page was opened
    std::vector<Tile> tiles_;
    std::unique_ptr<Thumbnails> thumbnails_;
};

}  // namespace vitrine
