// SPDX-License-Identifier: MIT
// Handles over the picture that move, turn and scale what is selected, as edits that can be undone
// and saved.
#pragma once

#include <optional>
#include <string>

#include "app/viewer/handle_view.hpp"
#include "app/viewer/node_tree.hpp"
#include "app/viewer/scene_view.hpp"
#include "app/viewer/tool.hpp"

namespace vitrine {

class Handles : public Tool {
  public:
    Handles(Window& window, SceneView& view) : window_(window), view_(view) {}
    void addCommands(std::vector<Command>& list) override;
    void draw(glm::vec2 pictureSize) override;

  private:
    /// The node that is selected, in this scene.
    [[nodiscard]] std::optional<size_t> selected() const;
    void drawButtons(const std::string& why);
    void drawBox(ImDrawList& list, const Projection& projection, const NodeTree& tree, size_t node,
                 const glm::mat4& worldFromNode) const;
    void hover(const HandleView& handles, const Projection& projection, size_t node,
               const glm::mat4& worldFromParent);
    void pull(const Projection& projection);
    void send(const Place& place);
    void endDrag();
    void cancel();
    void selectParent();

    Window& window_;
    SceneView& view_;
    int shownFor_ = -1;  ///< the node for which they have been drawn
    HandleMode mode_ = HandleMode::kMove;

    /// What was under the mouse when it was looked at last: a slow picture lets the mouse leave the
    /// handle before the button is known to be down.
    struct Hover {
        Handle handle;
        Sight sight;
        glm::vec2 mouse{0};
    };
    std::optional<Hover> hover_;

    std::optional<HandleDrag> drag_;
    std::string path_;  ///< of the node being dragged, as in its keys: "node.NAME"
    Place shown_;       ///< where the drag has brought it
    int gesture_ = 0;
    bool sent_ = false, snaps_ = false;
    bool letGo_ = false;  ///< given up: until no button is down, the mouse is not the camera's
};

/// Why a node cannot be placed by hand in this way; "" if it can.
std::string whyFixed(const Scene& scene, size_t node, HandleMode mode);

/// The place of a node in its parent.
Place placeOf(const Node& node);

}  // namespace vitrine
