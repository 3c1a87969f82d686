// SPDX-License-Identifier: MIT
// The panel: a control for everything that `--set` can set, made from the option tables and from
// the annotations of snippets.
#pragma once

#include <string>

#include "app/viewer/scene_view.hpp"
#include "app/viewer/tree_rows.hpp"
#include "pack/assets.hpp"
#include "scene/scene.hpp"

namespace vitrine {

class Panel {
  public:
    /// Draws the panel into the current ImGui window. Changes go to `edits`.
    void draw(const Scene& scene, const Assets& assets, Edits& edits, Selection& selection);

  private:
    std::string filter_;
    ObjectTree tree_;
};

}  // namespace vitrine
