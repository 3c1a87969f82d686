// SPDX-License-Identifier: MIT
// Lets the GPU answer what a probe asks of a field, with the GLSL that the renderer marches along.
#pragma once

#include <memory>

#include "frame/pass_context.hpp"
#include "sdf/field_samples.hpp"

namespace vitrine {

class FieldProbe {
  public:
    /// Compiles nothing yet. `field` stays alive with the probe.
    FieldProbe(const Context& context, std::shared_ptr<const Snippet> field);

    /// One answer a sample. Throws InputError, at the user's line, if the snippet does not compile.
    std::vector<FieldValue> ask(const FieldSamples& samples);

  private:
    /// At most kBatch samples from `first` on.
    void askBatch(const FieldSamples& samples, size_t first, size_t count,
                  std::vector<FieldValue>& values);

    PassContext context_;
    Texture places_, steps_, values_, gradients_;
};

}  // namespace vitrine
