// SPDX-License-Identifier: MIT
#include "app/viewer/pass_times.hpp"

namespace vitrine {

void PassTimes::addCommands(std::vector<Command>& list) {
    list.push_back({"View", "Milliseconds by pass", "G", 'G', false, false,
                    [this] {
                        shown_ = !shown_;
                        graph_ = {};
                        view_.stage.measure(shown_);
                    },
                    shown_});
}

void PassTimes::draw(glm::vec2 /*pictureSize*/) {
    if (shown_ && !graph_.samples().empty()) graph_.draw();
}

void PassTimes::finishStep() {
    auto sample = view_.stage.takePassSeconds();
    if (!sample) return;
    graph_.add(std::move(*sample));
    window_.wake();
}

}  // namespace vitrine
