// SPDX-License-Identifier: MIT
// The scene's objects as a tree in the panel: seen or hidden, selected, visited.
#pragma once

#include "app/viewer/edits.hpp"
#include "app/viewer/node_tree.hpp"
#include "app/viewer/scene_view.hpp"

namespace vitrine {

class ObjectTree {
  public:
    /// Into a part of the current ImGui window that scrolls by itself. A click selects, a double
    /// click visits, the eye hides and shows a node with what hangs on it.
    void draw(const Scene& scene, Edits& edits, Selection& selection);

  private:
    float height_ = 0;  ///< of all rows, when they were drawn last
};

}  // namespace vitrine
