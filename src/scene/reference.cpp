// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <sstream>

#include "scene/options.hpp"

namespace vitrine {
namespace {

/// What to write for an option, and what holds if it is not written.
template <class T>
struct Describe {
    const T& defaults;
    Range range;
    using Texts = std::pair<std::string, std::string>;

    Texts operator()(float T::*m) const {
        // A default that may not be written means "not given".
        const bool given = defaults.*m >= range.minimum && defaults.*m <= range.maximum;
        return {"number", given ? fmt::format("{}", defaults.*m) : ""};
    }
    Texts operator()(int T::*m) const { return {"whole number", fmt::format("{}", defaults.*m)}; }
    Texts operator()(bool T::*m) const {
        return {"`true` or `false`", fmt::format("`{}`", defaults.*m)};
    }
    Texts operator()(glm::vec3 T::*m) const { return {"`[x, y, z]`", vector(defaults.*m)}; }
    Texts operator()(Color T::*m) const { return {"colour", vector((defaults.*m).rgb)}; }
    Texts operator()(std::string T::*) const { return {"text", ""}; }
    Texts operator()(Reference T::*) const { return {"name", ""}; }
    Texts operator()(const FileMember<T>&) const { return {"file", ""}; }
    Texts operator()(const TextureMember<T>&) const { return {"file", ""}; }
    Texts operator()(const ScaleMember<T>& m) const {
        return {"number or `[x, y, z]`", vector(defaults.*m.member)};
    }
    Texts operator()(const ChoiceMember<T>& m) const {
        return {fmt::format("`\"{}\"`", fmt::join(m.words, "\"`, `\"")),
                fmt::format("`\"{}\"`", m.words[static_cast<size_t>(m.get(defaults))])};
    }
    static std::string vector(const glm::vec3& v) {
        return fmt::format("`[{}, {}, {}]`", v.x, v.y, v.z);
    }
};

std::string rangeOf(Range range) {
    if (range.minimum <= -1e9 && range.maximum >= 1e9) return "";
    if (range.maximum >= 1e9) return fmt::format("at least {}", range.minimum);
    return fmt::format("{} to {}", range.minimum, range.maximum);
}

template <class T>
void table(std::ostringstream& out, const std::string& title, const OptionTable<T>& options) {
    out << title << "| key | value | default | range | meaning |\n|---|---|---|---|---|\n";
    const T defaults{};
    for (const Option<T>& option : options) {
        const auto [type, value] = std::visit(Describe<T>{defaults, option.range}, option.member);
        out << fmt::format("| `{}` | {} | {} | {} | {} |\n", option.key, type, value,
                           rangeOf(option.range), option.help);
    }
}

template <class T>
void section(std::ostringstream& out, const std::string& title, const OptionTable<T>& options) {
    table(out, "\n## `" + title + "`\n\n", options);
}

template <class T>
void builtIn(std::ostringstream& out, const std::string& name, const OptionTable<T>& options) {
    table(out, "\n### `" + name + " = { ... }`\n\n", options);
}

constexpr const char* kIntroduction = R"(# The scene format: every key

A scene is a [TOML](https://toml.io) file. This is a whole one:

```toml
[shape.ball]
sphere = { radius = 0.5 }

[[node]]
shape = "ball"
```

- Metres, seconds, degrees; +Y is up; right-handed.
- A colour is linear, `[r, g, b]`, or sRGB, `"#rrggbb"`.
- Names of files are relative to the file that they stand in and may not lead out of the scene's
  folder.
- A name in double brackets, `[[node]]`, may be given several times. Nothing has to be given at all.
- A key or section that is not listed here is an error, and so is a value out of its range.

Every key can also be given on the command line. What is no TOML value is taken for text:

```
--set render.exposure=1             --set environment.sky=[0.1,0.2,0.3]
--set bvh.builder=spatial           --set bvh.max_leaf_size=1
--set camera.fov=40                 the first camera           --set camera.NAME.fov=40
--set light.intensity=2             every light                --set light.NAME.type=point
--set material.NAME.roughness=0.1   --set shape.NAME.sphere.radius=2
--set node.NAME.at=[0,1,0]          --set node.NAME.set.PARAMETER=0.5
--set material.FILE/NAME.roughness=0.1    what an included model brings
```

A value given so stays as it is, even if an animation of the scene would change it.

This page is generated from the tables that the parser reads (`src/scene/options.cpp`), and a test
compares them.
)";

constexpr const char* kIncludes = R"(
`include = ["parts/hall.toml", ...]` adds other scene files: their cameras, lights, materials,
shapes, nodes and animations, after the scene's own. Their `[render]` and `[environment]` hold where
the including file is silent (`[environment]` as a whole), their title and description are not used.
An included file lies in the scene's folder or below, may include others, up to 16 deep, and is taken
once, however often it is named. Two objects of one kind may not have the same name.
)";

constexpr const char* kAnimations = R"(
`keys = [[TIME, VALUE], ...]` says what the value is when: times in seconds, each larger than the one
before; values as the key itself takes them. In between, numbers, vectors and colours go straight
from key to key, `rotate` angle by angle; `true` and `false` jump. Before the first key the first
value holds.

```toml
[[animation]]                       # the turret looks left and comes back, for ever
node = "turret"
param = "rotate"
keys = [[0, [0, -20, 0]], [4, [0, 35, 0]]]
ease = "smooth"
loop = "mirror"

[[animation]]                       # a parameter of the node's distance field
node = "ball"
param = "set.morph"
keys = [[0, 0.0], [2, 1.0]]

[[animation]]                       # the whole path of `--set` instead of an object and its key
param = "render.exposure"
keys = [[0, -8], [1.5, 0]]
ease = "out"
```

Everything can change that is a number, a vector, a colour or true or false, of nodes, cameras, lights,
materials, `render` and `environment`; whole numbers and the sizes of shapes cannot (a node's `scale`
can). A node whose scale comes to 0 is not there. `loop = "repeat"` takes the last key for the first
one of the next round.
)";

constexpr const char* kWays = R"(
A camera with an `orbit` goes round its `target`, for ever; it begins at `eye`, or where `orbit` says.
`--set camera.orbit.period=8` makes a turntable of any camera. A camera with a `path` goes from key to
key without a jolt, starts and ends at rest, and waits where two keys are the same:

```toml
[[camera]]
name = "turntable"
eye = [3, 2, 4]
target = [0, 0.5, 0]
orbit = { period = 12 }

[[camera]]
name = "ride"
path = [[0, [6, 2, 6], [0, 1, 0]],    # [TIME, EYE, TARGET]
        [3, [0, 1, 4], [0, 1, 0]],
        [5, [-4, 2, 3], [0, 0.5, 0]]]
loop = "mirror"
```

In a window a hand on the mouse takes it over, Home gives it back. What `--set` says of `eye` or
`target` holds, and that part of the way is not gone.
)";

}  // namespace

std::string sceneFormatReference() {
    std::ostringstream out;
    out << kIntroduction;
    section(out, "[scene]", sceneOptions());
    out << kIncludes;
    section(out, "[render]", renderOptions());
    out << "\n`filmic`, the default, has deep blacks and vivid colours (Narkowicz's fit of ACES). "
           "`aces` is Hill's\nfit with its primaries: bright colours pale, and hues turn a little. "
           "`agx` (Sobotka) is soft and keeps\nhues best: bright blue goes to white without "
           "violet. `reinhard` is the plain one of 2002. Middle\ngrey stays about where it is in "
           "all of them. EXR files hold light before all this.\n";
    section(out, "[bvh]", bvhOptions());
    out << "\nHow the trees of meshes are built. `info FILE --builders` compares the builders,\n"
           "`--view bvh=4` shows a tree.\n";
    section(out, "[[camera]]", cameraOptions());
    out << "\nThe first camera is used unless `--camera` names another.\n\n"
           "With `f_stop` the camera has a thin lens of the diameter focal length / f_stop, in "
           "true\n"
           "measures (1 is a metre): a 50 mm lens at f/2 is 25 mm wide. It blurs toys much and a "
           "tank little, so\na scene that is not built to its true size wants another f_stop. "
           "With `fov` the focal length is the\none that sees as much. A lens needs `--spp` "
           "(one sample looks through its middle), and its first hits\nare always traced. EXR "
           "layers stay sharp. `lens = \"filter\"` blurs one sample as widely, in circles of up\n"
           "to 256 pixels: smooth at once and for motion, but mirror images are as sharp as their "
           "mirror, and\nwhat an object hides is guessed. With it `--spp` only smooths edges.\n";
    builtIn(out, "orbit", orbitOptions());
    out << kWays;
    section(out, "[environment]", environmentOptions());
    out << "\n`sky = COLOUR` is short for the same zenith, horizon and ground. `sky = "
           "\"FILE.hdr\"` or "
           "`\"FILE.exr\"` is\na picture of all directions (equirectangular, +Y up): its middle "
           "lies "
           "towards +x, and +z is a quarter\nof its width to the right, as in three.js and, after "
           "Blender's import of glTF, in Cycles. `rotation` turns\nit counterclockwise seen from "
           "above; the Mapping node of Cycles turns by the same angle with the other\nsign. "
           "`sky = \"sun\"` is a computed atmosphere with the sun as a light. Its noon gives about "
           "3 W/m2 with\nexposure 0; later hours are brightened as an eye would get used to "
           "them.\n";
    section(out, "[[light]]", lightOptions());
    section(out, "[material.NAME]", materialOptions());
    out << "\n`set = { PARAMETER = VALUE }` gives values to the parameters of the snippet: "
           "numbers,\n"
           "`true` or `false`, vectors `[x, y]` to `[x, y, z, w]`, colours.\n";
    section(out, "[shape.NAME]", shapeOptions());
    out << "\nA glTF file as `mesh` is one shape of all that it shows; its parts are its "
           "materials,\n"
           "which hold unless the node gives others.\n\n"
           "A shape is one of `sdf`, `mesh` or a built-in solid, which is centred on the "
           "origin:\n";
    builtIn(out, "box", boxOptions());
    builtIn(out, "sphere", sphereOptions());
    builtIn(out, "plane", planeOptions());
    builtIn(out, "torus", torusOptions());
    builtIn(out, "cylinder", cylinderOptions());
    section(out, "[[node]]", nodeOptions());
    out << "\nA node is scaled, then rotated, then moved; its parent's place comes on top.\n\n"
           "`include = \"f.glb\"` puts all that is in a glTF file below the node: nodes, meshes,\n"
           "materials, textures, perspective cameras and lights (a lux is 1 W/m2, a candela 1 "
           "W/sr).\n"
           "Materials are called FILE/NAME, all else NODE/NAME. `material` and `parts` replace\n"
           "materials of the file by their names in it. Its first animation plays, over and over,\n"
           "or the one that `animation` names; see [gltf.md](gltf.md).\n\n"
           "`set = { PARAMETER = VALUE }` gives values to the parameters of an SDF shape, as for\n"
           "materials. `parts = { PART = \"MATERIAL\" }` gives materials to its parts.\n";
    section(out, "[[animation]]", animationOptions());
    out << kAnimations;
    return out.str();
}

}  // namespace vitrine
