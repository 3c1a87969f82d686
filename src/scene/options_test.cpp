// SPDX-License-Identifier: MIT
// Every row of every table is put to the test by itself: a new option needs no new test here.
#include "scene/options.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "base/file.hpp"
#include "scene/test_scene.hpp"

namespace vitrine {
namespace {

std::string textOf(const glm::vec3& v) {
    return fmt::format("[{}, {}, {}]", v.x, v.y, v.z);
}

/// What an option's member holds, as it would be written in a scene.
template <class T>
std::string valueOf(const Option<T>& option, const T& object) {
    const auto read = [&](auto member) -> std::string {
        using M = decltype(member);
        if constexpr (std::is_same_v<M, Color T::*>)
            return textOf((object.*member).rgb);
        else if constexpr (std::is_same_v<M, glm::vec3 T::*>)
            return textOf(object.*member);
        else if constexpr (std::is_same_v<M, ScaleMember<T>>)
            return textOf(object.*member.member);
        else if constexpr (std::is_same_v<M, ChoiceMember<T>>)
            return fmt::format("\"{}\"", member.words[static_cast<size_t>(member.get(object))]);
        else if constexpr (std::is_same_v<M, Reference T::*>)
            return fmt::format("\"{}\"", (object.*member).name);
        else if constexpr (std::is_same_v<M, std::string T::*>)
            return fmt::format("\"{}\"", object.*member);
        else
            return fmt::format("{}", object.*member);
    };
    return std::visit(read, option.member);
}

/// A number in the range, `step` quarters of it up.
double inside(const Range& range, int step) {
    const double low = std::max(range.minimum, -7.0);
    const double high = std::min(range.maximum, low + 64);
    return low + (high - low) * step / 4;
}

template <class T>
std::string otherValue(const Option<T>& option) {
    const Range& r = option.range;
    const auto write = [&](auto member) -> std::string {
        using M = decltype(member);
        if constexpr (std::is_same_v<M, float T::*>) return fmt::format("{}", inside(r, 3));
        if constexpr (std::is_same_v<M, int T::*>)
            return fmt::format("{}", static_cast<int>(inside(r, 3)));
        if constexpr (std::is_same_v<M, bool T::*>)
            return valueOf(option, T{}) == "true" ? "false" : "true";
        if constexpr (std::is_same_v<M, ChoiceMember<T>>) {
            for (const std::string& word : member.words)
                if (valueOf(option, T{}) != "\"" + word + "\"") return "\"" + word + "\"";
        }
        if constexpr (std::is_same_v<M, std::string T::*> || std::is_same_v<M, Reference T::*>)
            return "\"other\"";
        return textOf({inside(r, 1), inside(r, 2), inside(r, 3)});
    };
    return std::visit(write, option.member);
}

template <class T>
bool isNumeric(const Option<T>& option) {
    return valueOf(option, T{}).find_first_of("0123456789") != std::string::npos &&
           valueOf(option, T{})[0] != '"';
}

/// A section of a scene around the key of a table, and where it ends up.
template <class T>
struct Place {
    std::string before, after;
    std::function<T(const Scene&)> find;
};

template <class T>
void checkTable(const OptionTable<T>& options, const Place<T>& place) {
    // Things that references may name.
    const std::string others =
        "[material.other]\n[shape.other]\nsphere = {}\n"
        "[[node]]\nname = \"other\"\n";
    const auto parse = [&](const std::string& assignment, Diagnostics& diagnostics) {
        const bool light = assignment.rfind("at =", 0) == 0 && place.before.find("[[light]]") == 0;
        const std::string text = others + place.before + (light ? "type = \"point\"\n" : "") +
                                 assignment + place.after + "\n";
        return place.find(parseScene(text, "t", {}, diagnostics));
    };
    for (const Option<T>& option : options) {
        SCOPED_TRACE(place.before + option.key);
        EXPECT_FALSE(option.help.empty());
        const std::string value = otherValue(option);
        Diagnostics good;
        const T object = parse(option.key + " = " + value, good);
        EXPECT_EQ(good.text(), "");
        EXPECT_EQ(valueOf(option, object), value);
        EXPECT_NE(value, valueOf(option, T{})) << "the test must change something";

        Diagnostics wrongType;
        const T untouched = parse(option.key + " = [[1]]", wrongType);
        EXPECT_NE(wrongType.text().find("error: " + option.key + " must be "), std::string::npos)
            << wrongType.text();
        const Option<T>& o = option;
        EXPECT_EQ(valueOf(o, untouched), valueOf(o, parse("", wrongType)));

        for (const double step : {-1.0, 1.0}) {
            if (!isNumeric(option)) continue;
            const double limit = step < 0 ? option.range.minimum : option.range.maximum;
            const std::string number = fmt::format("{}", limit + step);
            Diagnostics outside;
            const bool vector = valueOf(option, T{})[0] == '[';
            const T same = parse(
                option.key + " = " + (vector ? fmt::format("[{0}, {0}, {0}]", number) : number),
                outside);
            EXPECT_NE(outside.text().find(fmt::format("{} is {}; it must be ", option.key, number)),
                      std::string::npos)
                << outside.text();
            EXPECT_EQ(valueOf(option, same), valueOf(option, untouched));
        }
    }
}

TEST(Options, EveryRowOfSingleSectionsReachesItsMember) {
    checkTable<Scene>(sceneOptions(), {"[scene]\n", "", [](const Scene& s) { return s; }});
    checkTable<RenderSettings>(renderOptions(),
                               {"[render]\n", "", [](const Scene& s) { return s.render; }});
    checkTable<Environment>(environmentOptions(),
                            {"[environment]\n", "", [](const Scene& s) { return s.environment; }});
}

TEST(Options, EveryRowOfListedSectionsReachesItsMember) {
    checkTable<Camera>(cameraOptions(),
                       {"[[camera]]\n", "", [](const Scene& s) { return s.cameras.at(0); }});
    checkTable<Light>(lightOptions(),
                      {"[[light]]\n", "", [](const Scene& s) { return s.lights.at(0); }});
    OptionTable<Node> options = nodeOptions();
    const auto needsShape = [](const Option<Node>& o) { return o.key == "material"; };
    const auto isName = [](const Option<Node>& o) { return o.key == "name"; };
    const auto node = [](const Scene& s) { return s.nodes.at(1); };
    checkTable<Node>({*std::find_if(options.begin(), options.end(), needsShape)},
                     {"[[node]]\nshape = \"other\"\n", "", node});
    std::erase_if(options, needsShape);
    // The name "other" is taken; renaming the first node leaves the second one free to take it.
    Diagnostics diagnostics;
    EXPECT_EQ(parseScene("[[node]]\nname = \"n\"", "t", {}, diagnostics).nodes[0].name, "n");
    std::erase_if(options, isName);
    checkTable<Node>(options, {"[[node]]\n", "", node});
}

TEST(Options, EveryRowOfNamedSectionsReachesItsMember) {
    const auto material = [](const Scene& s) { return s.materials.at(0); };
    checkTable<Material>(materialOptions(), {"[material.a]\n", "", material});
    const auto shape = [](const Scene& s) { return s.shapes.at(0); };
    checkTable<Shape>(shapeOptions(), {"[shape.a]\n", "", shape});
    const auto box = [&](const Scene& s) { return *shape(s).box; };
    checkTable<BoxShape>(boxOptions(), {"[shape.a]\nbox = { ", " }", box});
    const auto sphere = [&](const Scene& s) { return *shape(s).sphere; };
    checkTable<SphereShape>(sphereOptions(), {"[shape.a]\nsphere = { ", " }", sphere});
    const auto plane = [&](const Scene& s) { return *shape(s).plane; };
    checkTable<PlaneShape>(planeOptions(), {"[shape.a]\nplane = { ", " }", plane});
    const auto torus = [&](const Scene& s) { return *shape(s).torus; };
    checkTable<TorusShape>(torusOptions(), {"[shape.a]\ntorus = { ", " }", torus});
    const auto cylinder = [&](const Scene& s) { return *shape(s).cylinder; };
    checkTable<CylinderShape>(cylinderOptions(), {"[shape.a]\ncylinder = { ", " }", cylinder});
}

/// VITRINE_UPDATE_DOCS=1 writes the page anew. Tests run in the root of the source tree.
TEST(SceneFormatReference, IsThePageInDocs) {
    const std::string file = "docs/scene-format.md";
    const char* update = std::getenv("VITRINE_UPDATE_DOCS");
    if (update != nullptr && std::string(update) == "1")
        writeFileAtomically(file, sceneFormatReference());
    EXPECT_EQ(readFile(file, 1 << 20), sceneFormatReference())
        << "run this test with VITRINE_UPDATE_DOCS=1";
}

TEST(SceneFormatReference, ItsExampleIsAGoodScene) {
    const std::string page = sceneFormatReference();
    const size_t start = page.find("```toml\n") + 8;
    const Scene scene = goodScene(page.substr(start, page.find("```", start) - start));
    EXPECT_EQ(scene.nodes.size(), 1u);
}

}  // namespace
}  // namespace vitrine
