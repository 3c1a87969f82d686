// SPDX-License-Identifier: MIT
#include "sdf_pages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "pattern_pages.hpp"
#include "picture_studio.hpp"

namespace vitrine {

namespace {

using Quality = LibraryFunction::Quality;

/// A chapter of the page: the functions of one file.
struct Chapter {
    std::string_view file, title, color;
};

constexpr std::array<Chapter, 12> kChapters = {{
    {"shape3_basic.glsl", "Solids: balls, boxes, cylinders, cones", "#d9793f"},
    {"shape3_curved.glsl", "Solids: ellipsoids, curves, wires", "#c9622f"},
    {"shape3_faceted.glsl", "Solids with flat faces", "#b8503a"},
    {"surface.glsl", "Minimal surfaces", "#a8455c"},
    {"shape2_angular.glsl", "Plane shapes with straight edges", "#3f7fb5"},
    {"shape2_round.glsl", "Plane shapes of arcs", "#3a8fa8"},
    {"shape2_curve.glsl", "Plane shapes of other curves", "#4a70b8"},
    {"operator.glsl", "Operators", "#5f9a4f"},
    {"domain.glsl", "Domains: moves, mirrors, bends", "#c29a2f"},
    {"domain_repeat.glsl", "Domains: repetition", "#b08a4a"},
    {"noise.glsl", "Noise", "#7d6bb0"},
    {"numeric.glsl", "Equations", "#808080"},
}};

constexpr const char* kHead = R"(# The library of distance functions

A snippet (`NAME.sdf.glsl` or `NAME.mat.glsl`) may call any function of this page by its name. There
is nothing to include. Only what is called, and what that calls, becomes part of the program, once.
A function that the snippet defines itself wins over one of the same name here.

```glsl
// bounds[-1, -1, -1, 1, 1, 1]
float sdf(vec3 p) {{
    return opSmoothUnion(sdSphere(p, 0.5), sdTorus(p, 0.7, 0.15), 0.2);
}}
```

| names | what they take and return |
|---|---|
| `sd...` | a point in space, sizes: the distance to a shape, negative inside |
| `sd2...` | the same in a plane, to extrude or revolve; y is up |
| `op...` | distances: a distance |
| `dom...` | a point: the point at which a shape is to be asked |
| `slope...` | how much steeper something makes a field: divide the distance by it |
| `noise...` | a point: values about 0 |
| `num...` | roots of equations that distances lead to |

The point comes first, then sizes, metres and radians throughout. The axis of whatever has one is y,
sizes are half sizes where the middle is the origin, and `...Between(p, a, b)` stands between two
points.

- **exact**: the true distance to the surface, so a ray takes the longest safe steps and `opRound`,
  `opShell` and offsets are right. *Exact outside* or *inside*: on that side; elsewhere a bound.
- **bound**: never more than the true distance.
- **slope**: the largest rate at which the value changes. A ray is safe if this is at most 1, or if
  the snippet says so: `// lipschitz[1.42]`. For operators it is the factor by which the result is
  steeper than what is put in; the other half of the product rule is yours.
- **fills**: a box that holds the shape, for `// bounds[...]`.

All of this stands in the comments of `shaders/lib/sdf`, where the tests read it: each slope is
searched for its worst place, each exact distance is checked against its surface, each surface
against a second description. This page is made from the same comments by
`tools/make_sdf_pages.sh`, and a test compares them. There are {} functions.

)";

std::string_view qualityText(Quality quality) {
    switch (quality) {
        case Quality::kExact:
            return "exact";
        case Quality::kExactInside:
            return "exact inside";
        case Quality::kExactOutside:
            return "exact outside";
        case Quality::kBound:
            return "bound";
        case Quality::kNone:
            return "";
    }
    return "";
}

std::string fileOf(const LibraryFunction& function) {
    return function.where.file.substr(function.where.file.rfind('/') + 1);
}

/// Bars would end the cell of a table.
std::string cell(const std::string& text) {
    std::string result;
    for (const char c : text) result += c == '|' ? std::string("\\|") : std::string(1, c);
    return result;
}

std::string claims(const LibraryFunction& f) {
    std::string text(qualityText(f.quality));
    const auto add = [&](const std::string& part) { text += (text.empty() ? "" : ", ") + part; };
    if (f.quality == Quality::kExact && f.lipschitz.empty())
        add("slope 1");
    else if (!f.lipschitz.empty())
        add("slope " + (f.lipschitz == "1.0" ? "1" : "`" + f.lipschitz + "`"));
    if (!f.bounds.empty()) add("fills `" + f.bounds + "`");
    return text;
}

std::string row(const LibraryFunction& f) {
    std::string text = cell(f.about);
    if (!f.source.empty()) text += "<br>*Why:* " + cell(f.source);
    const std::string claimed = claims(f);
    if (!claimed.empty()) text += "<br>**" + cell(claimed) + "**";
    return fmt::format("| ![{0}](sdf/{0}.png) | `{1}`<br>{2} |\n", f.name, f.signature, text);
}

const Chapter& chapterOf(const LibraryFunction& function) {
    for (const Chapter& chapter : kChapters)
        if (chapter.file == fileOf(function)) return chapter;
    throw std::logic_error("no chapter of docs/sdf.md is for " + function.where.file);
}

}  // namespace

std::string sdfPage() {
    const auto& functions = sdfLibrary().functions();
    const auto patterns = std::count_if(functions.begin(), functions.end(), isPattern);
    std::string text = fmt::format(kHead, functions.size() - static_cast<size_t>(patterns));
    for (const LibraryFunction& f : functions)
        if (!isPattern(f)) (void)chapterOf(f);
    for (const Chapter& chapter : kChapters) {
        text += fmt::format("## {}\n\n| | |\n|---|---|\n", chapter.title);
        for (const LibraryFunction& f : functions)
            if (!isPattern(f) && fileOf(f) == chapter.file) text += row(f);
        text += "\n";
    }
    text.pop_back();
    return text;
}

std::string sdfPictureField(const LibraryFunction& function) {
    std::string text = "// bounds[-1.2, -1.2, -1.2, 1.2, 1.2, 1.2]\n";
    const std::string& slope = function.lipschitz;
    if (slope.find_first_not_of("0123456789.") == std::string::npos && slope > "1.0" &&
        function.name.compare(0, 2, "op") == 0)
        text += "// lipschitz[" + slope + "]\n";
    const std::string& example = function.examples.front();
    const char* cut = "sdBox(p, vec3(1.19))";
    if (function.name.compare(0, 3, "sd2") == 0)
        text += fmt::format(
            "float flat2(vec2 p) {{ return {}; }}\n"
            "float sdf(vec3 p) {{ return max(opExtrude(flat2(p.xy), p.z, 0.12), {}); }}\n",
            example, cut);
    else
        text += fmt::format("float sdf(vec3 p) {{ return max({}, {}); }}\n", example, cut);
    return text;
}

std::string sdfPictureScene(const LibraryFunction& function) {
    return pictureStudio(
        function.name, "eye = [1.9, 1.75, 3.6]\ntarget = [0, -0.1, 0]\nfov = 30",
        fmt::format("base_color = \"{}\"\nroughness = 0.35", chapterOf(function).color), -1.2);
}

}  // namespace vitrine
