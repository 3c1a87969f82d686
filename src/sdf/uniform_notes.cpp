// SPDX-License-Identifier: MIT
#include "sdf/uniform_notes.hpp"

#include <algorithm>
#include <utility>

namespace vitrine::glsl {

UniformNotes::UniformNotes(const Preprocessed& text, Snippet& snippet, Problems& problems)
    : groups_(text.groups) {
    for (const Comment& comment : text.comments) {
        if (const auto group = findGroup(comment)) {
            groups_.push_back({comment.place.line, *group});
            continue;
        }
        std::optional<Annotation> annotation = findAnnotation(comment.text, comment.place);
        if (!annotation) continue;
        if (isControl(annotation->name) || !annotationSuggestion(annotation->name).empty()) {
            if (!applyToSnippet(*annotation, snippet, problems)) add(std::move(*annotation));
        }
    }
    std::stable_sort(groups_.begin(), groups_.end(),
                     [](const GroupLine& a, const GroupLine& b) { return a.line < b.line; });
}

const Annotation* UniformNotes::claim(Place place) {
    for (Control& control : controls_) {
        const Place at = control.annotation.place;
        if (at.line != place.line || at.column < place.column) continue;
        control.claimed = true;
        return &control.annotation;
    }
    return nullptr;
}

std::string UniformNotes::group(int line) const {
    std::string name;
    for (const GroupLine& group : groups_)
        if (group.line <= line) name = group.name;
    return name;
}

void UniformNotes::reportUnclaimed(Problems& problems) const {
    for (const Control& control : controls_) {
        if (control.claimed) continue;
        const std::string& name = control.annotation.name;
        if (isControl(name))
            problems.error(control.annotation.place,
                           name + " describes no uniform: it belongs on the line where one ends");
        else  // perhaps prose, so no error
            problems.warning(control.annotation.place,
                             "'" + name + "[' is no annotation" + annotationSuggestion(name));
    }
}

}  // namespace vitrine::glsl
