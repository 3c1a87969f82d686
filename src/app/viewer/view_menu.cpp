// SPDX-License-Identifier: MIT
#include "app/viewer/view_menu.hpp"

namespace vitrine {
namespace {

const std::string& nameOf(View view) {
    return viewNames()[static_cast<size_t>(view)];
}

}  // namespace

void ViewMenu::addCommands(std::vector<Command>& list) {
    Split& split = view_.split;
    for (size_t i = 0; i < viewNames().size(); ++i) {
        const auto view = static_cast<View>(i);
        list.push_back({"Show", viewNames()[i], "", 0, false, false,
                        [this, view] { view_.showView(view); }, view_.view() == view});
    }
    list.push_back(
        {"Split", "Split the picture", "V", 'V', false, false,
         [this, &split] { split.isOpen() ? split.close() : view_.openSplit(split.view()); },
         split.isOpen()});
    list.push_back({"Split", "Before the changes", "Shift+V", 'V', false, true,
                    [this, &split] {
                        split.isPlain() ? split.close() : view_.openSplit(view_.view(), true);
                    },
                    split.isPlain()});
    for (size_t i = 0; i < viewNames().size(); ++i) {
        const auto view = static_cast<View>(i);
        list.push_back({"Split", "right: " + viewNames()[i], "", 0, false, false,
                        [this, view] { view_.openSplit(view); },
                        split.isOpen() && !split.isPlain() && split.view() == view});
    }
}

void ViewMenu::draw(glm::vec2 pictureSize) {
    if (view_.split.isPlain())
        view_.split.drawLine(pictureSize, "changed", "before");
    else
        view_.split.drawLine(pictureSize, nameOf(view_.view()), nameOf(view_.split.view()));
}

}  // namespace vitrine
