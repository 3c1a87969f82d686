// SPDX-License-Identifier: MIT
#include "app/session/field_prober.hpp"

#include <fmt/format.h>

#include "frame/pass_probe_field.hpp"
#include "pack/parameters.hpp"
#include "sdf/field_bounds.hpp"
#include "sdf/field_slope.hpp"

namespace vitrine {
namespace {

constexpr const char* kBoundsAdvice = "write them, as in `// bounds[-1, -1, -1,  1, 1, 1]`";

/// A reload gives a new object for the same text, and nodes may use other values.
std::string keyOf(const Snippet& field, const std::vector<FieldSetting>& inUse) {
    std::string key = field.file + '\n' + field.source;
    for (const FieldSetting& setting : inUse)
        for (const glm::vec4& v : setting) key += fmt::format("\n{} {} {} {}", v.x, v.y, v.z, v.w);
    return key;
}

/// The settings of the nodes that show this field.
std::vector<FieldSetting> settingsInUse(const Scene& scene, const Assets& assets,
                                        const std::shared_ptr<const Snippet>& field) {
    std::vector<FieldSetting> settings;
    for (const Node& node : scene.nodes)
        for (size_t i = 0; i < scene.shapes.size() && !node.set.empty(); ++i) {
            if (scene.shapes[i].name != node.shape.name || assets.fields[i] != field) continue;
            Diagnostics ignored;  // the packer reports them
            settings.push_back(parameterValues(*field, node.set, ignored));
        }
    return settings;
}

/// What `found` says of bounds that are missing; false if that is an error.
bool acceptBounds(const FoundBounds& found, const Snippet& field, Diagnostics& diagnostics) {
    switch (found.outcome) {
        case FoundBounds::Outcome::kFound:
            return true;
        case FoundBounds::Outcome::kNothing:
            diagnostics.error(
                {field.file},
                fmt::format("the field has no bounds, and none were found: it is nowhere zero; {}",
                            kBoundsAdvice));
            return false;
        case FoundBounds::Outcome::kInfinite:
            diagnostics.error(
                {field.file},
                fmt::format("the field has no end: its surface reaches farther than {} m; cut it "
                            "where it may end with `// bounds[-10, -10, -10,  10, 10, 10]`, or "
                            "inside the field with max(d, box)",
                            0.5f * kFarthestBounds));
            return false;
    }
    return false;
}

}  // namespace

const Context* FieldProber::context() {
    if (context_ == nullptr && excuse_.empty()) {
        try {
            own_ = Context::createHeadless();
            context_ = own_.get();
        } catch (const MachineError& error) {
            excuse_ = error.what();
        }
    }
    return context_;
}

FieldEvaluator FieldProber::evaluator(const std::shared_ptr<const Snippet>& field) {
    if (context() == nullptr) throw MachineError(excuse_);
    auto probe = std::make_shared<FieldProbe>(*context_, field);
    return [probe](const FieldSamples& samples) { return probe->ask(samples); };
}

ProbedField FieldProber::probe(const std::shared_ptr<const Snippet>& field,
                               const std::vector<FieldSetting>& inUse, Diagnostics& diagnostics) {
    const FieldEvaluator evaluate = evaluator(field);
    auto measured = std::make_shared<Snippet>(*field);
    FieldDomain domain = domainOf(*field, {}, inUse);
    if (!field->bounds) {
        const FoundBounds found = findBounds(domain, evaluate);
        if (!acceptBounds(found, *field, diagnostics)) return {};
        measured->foundBounds = found.box;
    }
    domain.box = *measured->box();
    FieldReport report = measureSlope(domain, evaluate);
    report.boundsFound = !field->bounds;
    measured->measuredLipschitz = report.lipschitz;
    if (report.cut && thoroughness_ == Thoroughness::kAll && field->bounds) {
        const FoundBounds found = findBounds(domain, evaluate);
        if (found.outcome == FoundBounds::Outcome::kFound) report.suggestedBounds = found.box;
    }
    return {std::move(measured), std::move(report)};
}

std::shared_ptr<const Snippet> FieldProber::measure(const std::shared_ptr<const Snippet>& field,
                                                    const std::vector<FieldSetting>& inUse,
                                                    Diagnostics& diagnostics) {
    if (thoroughness_ == Thoroughness::kNeeded && field->bounds && field->lipschitz) return field;
    const std::string key = keyOf(*field, inUse);
    auto known = known_.find(key);
    if (known == known_.end()) {
        if (context() == nullptr) {
            if (field->bounds) return field;
            diagnostics.error({field->file},
                              fmt::format("the field has no bounds, and they cannot be found "
                                          "without OpenGL; {}",
                                          kBoundsAdvice));
            return nullptr;
        }
        try {
            ProbedField probed = probe(field, inUse, diagnostics);
            if (probed.field == nullptr) return nullptr;
            known = known_.emplace(key, std::move(probed)).first;
        } catch (const InputError& error) {
            // It does not compile. Whoever compiles it next says so, if it has bounds to be used.
            if (field->bounds) return field;
            diagnostics.append(error.diagnostics());
            return nullptr;
        }
    }
    fields_.push_back(known->second);
    return known->second.field;
}

void FieldProber::measure(const Scene& scene, Assets& assets, Diagnostics& diagnostics) {
    fields_.clear();
    std::map<const Snippet*, std::shared_ptr<const Snippet>> done;
    for (size_t i = 0; i < assets.fields.size(); ++i) {
        const auto field = assets.fields[i];
        if (field == nullptr) continue;
        auto found = done.find(field.get());
        if (found == done.end())
            found = done.emplace(field.get(),
                                 measure(field, settingsInUse(scene, assets, field), diagnostics))
                        .first;
        assets.fields[i] = found->second;
    }
}

}  // namespace vitrine
