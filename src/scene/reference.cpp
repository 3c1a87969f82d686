// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <sstream>

#include "scene/options.hpp"

namespace vitrine {
namespace {

template <class T>
struct Describe {
    const T& defaults;

    std::pair<std::string, std::string> operator()(float T::*m) const {
        return {"number", fmt::format("{}", defaults.*m)};
    }
    std::pair<std::string, std::string> operator()(int T::*m) const {
        return {"whole number", fmt::format("{}", defaults.*m)};
    }
    std::pair<std::string, std::string> operator()(bool T::*m) const {
        return {"true or false", fmt::format("{}", defaults.*m)};
    }
    std::pair<std::string, std::string> operator()(glm::vec3 T::*m) const {
        return {"[x, y, z]", vector(defaults.*m)};
    }
    std::pair<std::string, std::string> operator()(Color T::*m) const {
        return {"colour", vector((defaults.*m).rgb)};
    }
    std::pair<std::string, std::string> operator()(std::string T::*) const { return {"text", ""}; }
    std::pair<std::string, std::string> operator()(Reference T::*) const { return {"name", ""}; }
    std::pair<std::string, std::string> operator()(const ScaleMember<T>& m) const {
        return {"number or [x, y, z]", vector(defaults.*m.member)};
    }
    std::pair<std::string, std::string> operator()(const ChoiceMember<T>& m) const {
        return {fmt::format("\"{}\"", fmt::join(m.words, "\", \"")),
                fmt::format("\"{}\"", m.words[static_cast<size_t>(m.get(defaults))])};
    }
    static std::string vector(const glm::vec3& v) { return fmt::format("[{}, {}, {}]", v.x, v.y, v.z); }
};

std::string rangeOf(Range range) {
    if (range.minimum <= -1e9 && range.maximum >= 1e9) return "";
    if (range.maximum >= 1e9) return fmt::format("from {}", range.minimum);
    return fmt::format("{} to {}", range.minimum, range.maximum);
}

template <class T>
void section(std::ostringstream& out, const std::string& title, const OptionTable<T>& options) {
    out << "\n## `" << title << "`\n\n| key | value | default | range | meaning |\n|---|---|---|---|---|\n";
    const T defaults{};
    for (const Option<T>& option : options) {
        const auto [type, value] = std::visit(Describe<T>{defaults}, option.member);
        out << fmt::format("| `{}` | {} | {} | {} | {} |\n", option.key, type, value,
                           rangeOf(option.range), option.help);
    }
}

}  // namespace

std::string sceneFormatReference() {
    std::ostringstream out;
    out << "# The scene format: every key\n\n"
           "Generated from the tables in `src/scene/options.cpp`; a test compares. Metres, seconds,\n"
           "degrees, +Y up, right-handed. Colours are linear `[r, g, b]` or sRGB `\"#rrggbb\"`.\n"
           "Every key can be given on the command line: `--set render.exposure=1`,\n"
           "`--set node.NAME.at=[0,1,0]`, `--set node.NAME.set.PARAMETER=0.5`.\n";
    section(out, "[scene]", sceneOptions());
    section(out, "[render]", renderOptions());
    section(out, "[[camera]]", cameraOptions());
    section(out, "[environment]", environmentOptions());
    out << "\n`sky = COLOUR` is short for the same zenith, horizon and ground.\n";
    section(out, "[[light]]", lightOptions());
    section(out, "[material.NAME]", materialOptions());
    out << "\n`set = { PARAMETER = VALUE }` gives values to the parameters of the snippet.\n";
    section(out, "[shape.NAME]", shapeOptions());
    out << "\nInstead of `sdf` or `mesh`, one of the built-in shapes:\n";
    section(out, "box = { ... }", boxOptions());
    section(out, "sphere = { ... }", sphereOptions());
    section(out, "plane = { ... }", planeOptions());
    section(out, "torus = { ... }", torusOptions());
    section(out, "cylinder = { ... }", cylinderOptions());
    section(out, "[[node]]", nodeOptions());
    out << "\n`set = { PARAMETER = VALUE }` gives values to the parameters of an SDF shape;\n"
           "`parts = { PART = \"MATERIAL\" }` gives materials to its parts.\n";
    return out.str();
}

}  // namespace vitrine
