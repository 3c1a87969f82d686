// SPDX-License-Identifier: MIT
#include "pattern_pages.hpp"

#include <fmt/format.h>

#include <array>

#include "base/text.hpp"
#include "picture_studio.hpp"

namespace vitrine {

namespace {

/// A chapter of the page: the functions of one file.
struct Chapter {
    std::string_view file, title;
};

constexpr std::array<Chapter, 3> kChapters = {{
    {"lib/material/mapping.glsl", "Mappings"},
    {"lib/material/regular.glsl", "Patterns that repeat"},
    {"lib/material/organic.glsl", "Patterns in space, and wear"},
}};

constexpr const char* kHead = R"(# Patterns for materials

A snippet (`NAME.mat.glsl`, see [materials.md](materials.md)) may call any function of this page by its
name, and those of [sdf.md](sdf.md), the noises above all. There is nothing to include. A field may
call them as well, for example to raise the bricks that its material colours.

```glsl
void material(inout Surface s) {
    vec2 wall = uvBox(s.localPosition, s.localNormal);
    vec2 width = abs(uvBox(s.localFootprint, s.localNormal));
    vec4 brick = patBricks(wall, vec2(0.25, 0.08), 0.01, width);
    vec3 clay = vec3(0.35, 0.10, 0.06) * (0.7 + 0.6 * noiseHash(vec3(brick.yz, 0.0)).x);
    s.baseColor = mix(clay, vec3(0.5), brick.x);
}
```

`uv...` takes a place and returns a place of a plane, `pat...` takes a place and returns a pattern.
Places are metres of the object, and patterns have a period of 1 (bricks: sizes of their own): scale the
place, and the widths with it.

**Widths.** A pattern that is finer than a pixel flickers. The functions take the pixel's width in their
own units and return the mean over it. `s.localFootprint` has the widths along the three axes of the
object, longer where a surface is seen edge on.

**Curvature.** `s.curvature` is the mean curvature, 1/m: 1/r on a ball of radius r, 1/(2 r) on a
cylinder, 0 where it is flat, below 0 in hollows. On a field it is found by four more evaluations where
a ray has hit, over the material's `curvature_radius`, which is what makes an edge of a box as wide as
wear is; only scenes whose snippets ask for it pay. On a mesh it follows from how the normals of
a triangle's corners turn, one value a triangle: flat-shaded edges have none, rounded ones do.

This page is made from the comments of `shaders/lib/material` by `tools/make_sdf_pages.sh`. The tests
compare each function with a second description, and every picture, on the GPU, with the same text in
double precision.

)";

std::string row(const LibraryFunction& f) {
    std::string text = f.about;
    if (!f.source.empty()) text += "<br>*Why:* " + f.source;
    return fmt::format("| ![{0}](patterns/{0}.png) | `{1}`<br>{2} |\n", f.name, f.signature, text);
}

}  // namespace

bool isPattern(const LibraryFunction& function) {
    return startsWith(function.where.file, "lib/material/");
}

std::string patternPage() {
    std::string text = kHead;
    for (const Chapter& chapter : kChapters) {
        text += fmt::format("## {}\n\n| | |\n|---|---|\n", chapter.title);
        for (const LibraryFunction& f : sdfLibrary().functions())
            if (f.where.file == chapter.file) text += row(f);
        text += "\n";
    }
    text.pop_back();
    return text;
}

std::string patternPictureMaterial(const LibraryFunction& function) {
    return fmt::format(R"(void material(inout Surface s) {{
    vec3 p = s.localPosition;
    vec3 n = s.localNormal;
    vec3 w = s.localFootprint;
    float k = s.curvature;
    float r = s.curvatureRadius;
    s.baseColor = vec3({});
}}
)",
                       function.patterns.front());
}

std::string patternPictureField(const LibraryFunction& function) {
    const std::string shape =
        function.shape.empty() ? "sdRoundedBox(p, vec3(0.78), 0.03)" : function.shape;
    return fmt::format(
        "// bounds[-1.1, -1.1, -1.1, 1.1, 1.1, 1.1]\nfloat sdf(vec3 p) {{ return {}; }}\n", shape);
}

std::string patternPictureScene(const LibraryFunction& function) {
    return pictureStudio(
        function.name, "eye = [2.0, 1.7, 3.3]\ntarget = [0, -0.06, 0]\nfov = 33",
        fmt::format("roughness = 0.5\nsnippet = \"{}.mat.glsl\"\ncurvature_radius = 0.16",
                    function.name),
        -1.0);
}

}  // namespace vitrine
