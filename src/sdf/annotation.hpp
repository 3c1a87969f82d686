// SPDX-License-Identifier: MIT
// What users say in comments: "// slider[min, default, max] label", "// bounds[...]" and so on.
// Only "word[" at the very start of a comment is an annotation; all else is prose.
// Source of the forms: Fragmentarium (slider, color, checkbox, group), Synthclipse ("//! slider").
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sdf/problems.hpp"
#include "sdf/snippet.hpp"
#include "sdf/token.hpp"

namespace vitrine::glsl {

/// One thing between the commas: a word or number, or several in parentheses.
struct AnnotationValue {
    std::vector<std::string> words;
    bool inParentheses = false;
    Place place;
};

struct Annotation {
    std::string name;
    Place place;
    std::vector<AnnotationValue> values;
    /// What stands behind the "]".
    std::string label;
    bool closed = false;
};

/// The annotation at the start of `text`, whose first character stands at `place`.
std::optional<Annotation> findAnnotation(std::string_view text, Place place);

/// slider, color, checkbox: those that describe a uniform.
bool isControl(std::string_view name);
/// " (did you mean 'slider'?)" if the name is nearly that of an annotation.
std::string annotationSuggestion(std::string_view name);

/// Range, default and label of a uniform from its annotation.
void applyControl(const Annotation& annotation, Parameter& parameter, Problems& problems);
/// bounds, lipschitz, parts: those that describe the whole snippet. False if it is none of them.
bool applyToSnippet(const Annotation& annotation, Snippet& snippet, Problems& problems);

/// The group that a comment begins: "group[Shape]", "#group Shape", "group Shape" with one word and
/// alone on its line, or Synthclipse's "! <group name="Shape">".
std::optional<std::string> findGroup(const Comment& comment);

}  // namespace vitrine::glsl
