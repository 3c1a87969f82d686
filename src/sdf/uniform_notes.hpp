// SPDX-License-Identifier: MIT
// The annotations of a file, waiting for the uniforms they describe.
#pragma once

#include <string>
#include <vector>

#include "sdf/annotation.hpp"
#include "sdf/preprocessor.hpp"

namespace vitrine::glsl {

class UniformNotes {
  public:
    /// Reads all comments; those about the whole snippet are applied to it at once.
    UniformNotes(const Preprocessed& text, Snippet& snippet, Problems& problems);

    /// An annotation that stands in the text itself, as in Fragmentarium.
    void add(Annotation annotation) { controls_.push_back({std::move(annotation), false}); }
    /// The annotation that stands behind `place` on its line; null if there is none.
    const Annotation* claim(Place place);
    /// The group of a uniform on this line.
    [[nodiscard]] std::string group(int line) const;
    /// After all uniforms: what is left describes nothing.
    void reportUnclaimed(Problems& problems) const;

  private:
    struct Control {
        Annotation annotation;
        bool claimed = false;
    };
    std::vector<Control> controls_;
    std::vector<GroupLine> groups_;  // by line
};

}  // namespace vitrine::glsl
