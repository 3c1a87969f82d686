// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/cli/commands.hpp"
#include "app/cli/field_slice.hpp"
#include "base/file.hpp"
#include "base/text.hpp"
#include "image/png.hpp"

namespace vitrine {
namespace {

using Json = nlohmann::ordered_json;

Json toJson(const Diagnostic& d) {
    return {{"severity", d.severity == Severity::kError ? "error" : "warning"},
            {"file", d.where.file},
            {"line", d.where.line},
            {"column", d.where.column},
            {"message", d.message}};
}

Json toJson(const Aabb& b) {
    return {b.min.x, b.min.y, b.min.z, b.max.x, b.max.y, b.max.z};
}

Json toJson(const FieldPlace& place, const Snippet& snippet) {
    Json json{{"at", {place.point.x, place.point.y, place.point.z}}};
    if (snippet.usesTime) json["time"] = place.time;
    for (size_t i = 0; i < place.setting.size(); ++i) {
        Json numbers = Json::array();
        for (int c = 0; c < componentCount(snippet.parameters[i].type); ++c)
            numbers.push_back(place.setting[i][c]);
        json["parameters"][snippet.parameters[i].name] = numbers.size() == 1 ? numbers[0] : numbers;
    }
    return json;
}

/// A note has the place and message of a diagnostic, and the numbers.
Json toJson(const ProbedField& probed) {
    const FieldReport& r = probed.report;
    const Snippet& snippet = *probed.field;
    Json field{{"bounds", toJson(r.bounds)},
               {"bounds_found", r.boundsFound},
               {"slope", r.steepest.value},
               {"slope_place", toJson(r.steepest, snippet)},
               {"slope_inside", r.steepestInside.value},
               {"steep_share", r.steepShare},
               {"negative_share", r.negativeShare},
               {"samples", r.samples},
               {"not_finite", r.notFinite},
               {"jump", r.jump},
               {"has_surface", r.hasSurface()},
               {"bounds_cut", r.cut.has_value()},
               {"suggested_lipschitz", r.lipschitz},
               {"steps_divided_by", snippet.stepDivisor()}};
    if (r.suggestedBounds) field["suggested_bounds"] = toJson(*r.suggestedBounds);
    return {{"severity", "note"},
            {"file", snippet.file},
            {"line", 0},
            {"column", 0},
            {"message", describeField(r, snippet)},
            {"field", std::move(field)}};
}

void drawSlice(const std::string& output, FieldProber& prober) {
    if (prober.fields().empty()) return;
    const ProbedField& probed = prober.fields().front();
    const ImageRgba8 image =
        drawFieldSlice(probed.report, *probed.field, prober.evaluator(probed.field));
    writeFileAtomically(output, encodePng(image, {{"Title", probed.field->file}}));
}

void print(const CheckOptions& options, const Diagnostics& diagnostics, const FieldProber& prober) {
    if (!diagnostics.list().empty()) fmt::print("{}\n", diagnostics.text());
    for (const ProbedField& probed : prober.fields())
        fmt::print("{}: field: {}\n", probed.field->file,
                   describeField(probed.report, *probed.field));
    if (diagnostics.list().empty()) fmt::print("{}: good\n", options.file);
}

void printJson(const CheckOptions& options, const Diagnostics& diagnostics,
               const FieldProber& prober) {
    Json list = Json::array();
    for (const Diagnostic& d : diagnostics.list()) list.push_back(toJson(d));
    for (const ProbedField& probed : prober.fields()) list.push_back(toJson(probed));
    writeJson(options.json, list.dump(2));
}

}  // namespace

int check(const CheckOptions& options) {
    if (!options.output.empty()) {
        if (!endsWith(options.output, ".png"))
            throw UsageError(fmt::format("-o: '{}' must end in .png", options.output));
        if (!endsWith(options.file, ".sdf.glsl"))
            throw UsageError("-o: only a field (.sdf.glsl) is cut through for a picture");
        checkWritable(options.output);
    }
    Diagnostics diagnostics;
    FieldProber prober(FieldProber::Thoroughness::kAll);
    try {
        const LoadedScene loaded = loadAll(options.file, options.overrides, prober, diagnostics);
        compileSnippets(loaded, prober, diagnostics);
        for (const ProbedField& probed : prober.fields())
            judgeField(probed.report, *probed.field, diagnostics);
        if (!options.output.empty()) drawSlice(options.output, prober);
    } catch (const InputError& error) {
        diagnostics.append(error.diagnostics());
    }
    if (options.json.empty())
        print(options, diagnostics, prober);
    else
        printJson(options, diagnostics, prober);
    return diagnostics.hasErrors() ? 1 : 0;
}

}  // namespace vitrine
