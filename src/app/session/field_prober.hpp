// SPDX-License-Identifier: MIT
// Measures the distance fields of a scene before it is packed: how steep they are, and where they
// end if their author did not say (sdf/field_slope.hpp, sdf/field_bounds.hpp).
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "gpu/context.hpp"
#include "pack/assets.hpp"
#include "sdf/field_report.hpp"

namespace vitrine {

/// A field that was measured.
struct ProbedField {
    std::shared_ptr<const Snippet> field;
    FieldReport report;
};

/// Remembers what it has measured by the file's content and the settings in use, so that a window
/// that reloads measures only what has changed.
class FieldProber {
  public:
    enum class Thoroughness {
        kNeeded,  ///< fields that lack their bounds or their largest slope
        kAll,     ///< all fields, and bounds to suggest for those that are cut
    };

    /// Asks on `context`, which is current and outlives this; or, without one, on a context that it
    /// makes when the first field is to be measured, and which is current until this goes.
    explicit FieldProber(Thoroughness thoroughness = Thoroughness::kNeeded,
                         const Context* context = nullptr)
        : thoroughness_(thoroughness), context_(context) {}

    /// Fills in what the fields lack. A field that has no end, or no bounds on a machine without
    /// OpenGL, is an error and leaves the assets.
    void measure(const Scene& scene, Assets& assets, Diagnostics& diagnostics);
    /// The same for one field that stands alone. Null after an error.
    std::shared_ptr<const Snippet> measure(const std::shared_ptr<const Snippet>& field,
                                           const std::vector<FieldSetting>& inUse,
                                           Diagnostics& diagnostics);

    /// What the last calls measured, in the scene's order; not those that need no measuring.
    [[nodiscard]] const std::vector<ProbedField>& fields() const { return fields_; }
    /// The context that is asked; null on a machine without OpenGL, and then excuse() says why.
    [[nodiscard]] const Context* context();
    [[nodiscard]] const std::string& excuse() const { return excuse_; }

    /// Answers for a field, as the renderer would see it. Throws MachineError without OpenGL,
    /// InputError if it does not compile.
    FieldEvaluator evaluator(const std::shared_ptr<const Snippet>& field);

  private:
    [[nodiscard]] ProbedField probe(const std::shared_ptr<const Snippet>& field,
                                    const std::vector<FieldSetting>& inUse,
                                    Diagnostics& diagnostics);

    Thoroughness thoroughness_;
    const Context* context_;
    std::unique_ptr<Context> own_;
    std::string excuse_;
    std::vector<ProbedField> fields_;
    std::map<std::string, ProbedField> known_;
};

}  // namespace vitrine
