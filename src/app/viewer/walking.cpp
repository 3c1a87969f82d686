// SPDX-License-Identifier: MIT
#include "app/viewer/walking.hpp"

#include <functional>

#include "app/viewer/way_round.hpp"

namespace vitrine {

Walking::Walking(SceneView& view, Surroundings& surroundings)
    : view_(view), surroundings_(surroundings) {
    view_.pilot.legs = [this](Camera& camera, glm::vec3 metres, float elapsed) {
        if (solid_) return walker_.go(camera, metres, elapsed, std::ref(surroundings_));
        if (metres == glm::vec3(0)) return false;
        walk(camera, metres, true);
        return true;
    };
    view_.pilot.detour = [this](const Camera& from, const Camera& to) {
        return wayRound(from, to, std::ref(surroundings_));
    };
}

void Walking::addCommands(std::vector<Command>& list) {
    list.push_back({"Move", "Walk on the ground, stop at walls", "B", 'B', false, false,
                    [this] {
                        solid_ = !solid_;
                        walker_ = {};
                    },
                    solid_});
}

}  // namespace vitrine
