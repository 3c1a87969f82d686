// SPDX-License-Identifier: MIT
#include "sdf/field_report.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace vitrine {
namespace {

/// Four digits at most, no zeros behind: what a person would write.
std::string shortNumber(float value, int digits = 4) {
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value,
                                   std::chars_format::general, digits)
                         .ptr;
    return {text.data(), end};
}

std::string percent(double share) {
    if (share > 0 && share < 0.001) return "less than 0.1 %";
    return shortNumber(static_cast<float>(100 * share), 3) + " %";
}

/// Where the annotation of this name stands; the whole file if there is none.
SourceLocation annotationPlace(const Snippet& snippet, std::string_view name) {
    const size_t at = snippet.source.find(std::string(name) + "[");
    if (at == std::string::npos) return {snippet.file};
    const auto begin = snippet.source.begin();
    const auto line = std::count(begin, begin + static_cast<std::ptrdiff_t>(at), '\n');
    const size_t lineStart = at == 0 ? 0 : snippet.source.rfind('\n', at - 1) + 1;
    return {snippet.file, static_cast<int>(line) + 1, static_cast<int>(at - lineStart) + 1};
}

void judgeSlope(const FieldReport& report, const Snippet& snippet, Diagnostics& diagnostics) {
    const FieldPlace& steepest = report.steepest;
    const std::string where = describePlace(steepest, snippet);
    if (report.jump > 0)
        diagnostics.warning(
            {snippet.file},
            "the field jumps by about " + shortNumber(report.jump, 2) + " at " +
                describePlace(report.jumpPlace, snippet) +
                ": no step is short enough there, and rays may pass through the surface; see that "
                "floor(), mod() and fract() repeat what is alike on both sides");
    if (snippet.lipschitz && steepest.value > kCleanSlope * *snippet.lipschitz)
        diagnostics.warning(annotationPlace(snippet, "lipschitz"),
                            "lipschitz is too small: the field's slope is " +
                                shortNumber(steepest.value, 3) + " at " + where +
                                ", so there may be holes; leave the line out or write "
                                "`// lipschitz[" +
                                shortNumber(report.lipschitz) + "]`");
    if (!snippet.lipschitz && steepest.value > kCleanSlope && report.jump == 0)
        diagnostics.warning(
            {snippet.file},
            "the field is no distance: its slope is " + shortNumber(steepest.value, 3) + " at " +
                where + "; steps are divided by " + shortNumber(report.lipschitz) +
                ". If that is right, write `// lipschitz[" + shortNumber(report.lipschitz) + "]`");
}

}  // namespace

bool FieldReport::hasSurface() const {
    const glm::vec3 size = bounds.extent();
    return nearest <= 2e-3f * std::max({size.x, size.y, size.z});
}

float safeLipschitz(float slope) {
    if (slope <= kCleanSlope) return 1;
    // A fiftieth for what the samples have missed; steps of a twentieth of the power of two below.
    const float wanted = 1.02f * slope;
    const float grid = 0.05f * std::exp2(std::floor(std::log2(wanted)));
    return std::min(std::ceil(wanted / grid) * grid, 1000.0f);
}

std::string describePlace(const FieldPlace& place, const Snippet& snippet) {
    std::string text = "(" + shortNumber(place.point.x, 3) + ", " + shortNumber(place.point.y, 3) +
                       ", " + shortNumber(place.point.z, 3) + ")";
    if (snippet.usesTime) text += ", time " + shortNumber(place.time, 3) + " s";
    for (size_t i = 0; i < std::min(place.setting.size(), snippet.parameters.size()); ++i) {
        const Parameter& p = snippet.parameters[i];
        if (place.setting[i] == p.defaultValue) continue;
        text += ", " + p.name;
        for (int c = 0; c < componentCount(p.type); ++c)
            text += " " + shortNumber(place.setting[i][c], 3);
    }
    return text;
}

std::string describeBounds(const Aabb& box) {
    std::string text = "bounds[";
    for (int i = 0; i < 6; ++i) {
        if (i > 0) text += i == 3 ? ",  " : ", ";
        text += shortNumber(i < 3 ? box.min[i] : box.max[i - 3]);
    }
    return text + "]";
}

std::string describeField(const FieldReport& report, const Snippet& snippet) {
    std::string text = describeBounds(report.bounds) + (report.boundsFound ? " (found)" : "") +
                       "; slope " + shortNumber(report.steepest.value, 3) + " at " +
                       describePlace(report.steepest, snippet) + ", above 1 in " +
                       percent(report.steepShare) + " of the outside; " +
                       percent(report.negativeShare) + " of the box is inside";
    if (report.steepestInside.value > kCleanSlope)
        text += ", where the slope is " + shortNumber(report.steepestInside.value, 3);
    if (report.notFinite > 0) text += "; " + std::to_string(report.notFinite) + " not finite";
    text += "; steps divided by " +
            shortNumber(snippet.lipschitz ? *snippet.lipschitz : report.lipschitz) +
            (snippet.lipschitz ? " (given; " + shortNumber(report.lipschitz) + " would do)" : "");
    return text;
}

void judgeField(const FieldReport& report, const Snippet& snippet, Diagnostics& diagnostics) {
    if (report.notFinite > 0)
        diagnostics.warning({snippet.file},
                            "the field is not a finite number at " +
                                describePlace(report.notFinitePlace, snippet) + " and " +
                                std::to_string(report.notFinite - 1) +
                                " other samples: rays take these places for empty; look for a "
                                "division by zero, or a sqrt(), log() or pow() below zero");
    if (report.isSolid())
        diagnostics.warning(
            {snippet.file},
            "the field is zero or negative in all of its bounds: what is seen is the "
            "box. Is the sign the wrong way round?");
    else if (!report.hasSurface())
        diagnostics.warning({snippet.file},
                            "the field is nowhere zero in its bounds: there is nothing to see");
    judgeSlope(report, snippet, diagnostics);
    if (report.cut && !report.isSolid()) {
        std::string text = "the bounds cut the surface: the field is " +
                           shortNumber(report.cut->value, 3) + " on their face at " +
                           describePlace(*report.cut, snippet);
        if (!report.cutInUse) text += ", with parameters that are within their ranges";
        if (report.suggestedBounds)
            text += "; write `// " + describeBounds(*report.suggestedBounds) + "`";
        diagnostics.warning(annotationPlace(snippet, "bounds"), text);
    }
}

}  // namespace vitrine
