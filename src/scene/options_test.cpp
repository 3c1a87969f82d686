// SPDX-License-Identifier: MIT
// Every row of every table is put to the test by itself: a new option needs no new test here.
#include "scene/options.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <map>

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
        else if constexpr (std::is_same_v<M, FileMember<T>>)
            return fmt::format("\"{}\"", (object.*member.member).name);
        else if constexpr (std::is_same_v<M, TextureMember<T>>)
            return fmt::format("\"{}\"", (object.*member.member).file.name);
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
float inside(const Range& range, int step) {
    const double low = std::max(range.minimum, -7.0);
    const double high = std::min(range.maximum, low + 64);
    return static_cast<float>(low + (high - low) * step / 4);
}

template <class T>
std::string otherValue(const Option<T>& option) {
    const Range& r = option.range;
    const std::string usual = valueOf(option, T{});
    const auto write = [&](auto member) -> std::string {
        using M = decltype(member);
        if constexpr (std::is_same_v<M, float T::*>) {
            return fmt::format("{}", inside(r, 3));
        } else if constexpr (std::is_same_v<M, int T::*>) {
            return fmt::format("{}", static_cast<int>(inside(r, 3)));
        } else if constexpr (std::is_same_v<M, bool T::*>) {
            return usual == "true" ? "false" : "true";
        } else if constexpr (std::is_same_v<M, ChoiceMember<T>>) {
            const bool first = usual == fmt::format("\"{}\"", member.words[0]);
            return fmt::format("\"{}\"", member.words[first ? 1 : 0]);
        } else if constexpr (std::is_same_v<M, Reference T::*> ||
                             std::is_same_v<M, FileMember<T>> ||
                             std::is_same_v<M, TextureMember<T>>) {
            return "\"other\"";
        } else if constexpr (std::is_same_v<M, std::string T::*>) {
            return "\"fresh\"";
        } else {
            return textOf({inside(r, 1), inside(r, 2), inside(r, 3)});
        }
    };
    return std::visit(write, option.member);
}

template <class T>
bool isNumeric(const Option<T>& option) {
    return valueOf(option, T{}).find_first_of("0123456789") != std::string::npos &&
           valueOf(option, T{})[0] != '"';
}

/// Where a table's keys stand in a scene, and where they end up.
template <class T>
struct Place {
    std::string before, after;
    std::function<T(const Scene&)> find;
    /// What a key needs beside it.
    std::map<std::string, std::string> company{};
};

template <class T>
T parseIn(const Place<T>& place, const std::string& company, const std::string& assignment,
          Diagnostics& diagnostics) {
    const std::string others =
        "[material.other]\n[shape.other]\nsphere = {}\n[[node]]\nname = \"other\"\n";
    return place.find(parseScene(others + place.before + company + assignment + place.after, "t",
                                 {}, diagnostics));
}

template <class T>
void checkRow(const Option<T>& option, const OptionTable<T>& table, const Place<T>& place) {
    SCOPED_TRACE(place.before + option.key);
    EXPECT_FALSE(option.help.empty());
    const auto company = place.company.find(option.key);
    const std::string beside = company == place.company.end() ? "" : company->second;
    const auto parse = [&](const std::string& value, Diagnostics& diagnostics) {
        return parseIn(place, beside, option.key + " = " + value, diagnostics);
    };
    Diagnostics good, wrongType;
    const std::string value = otherValue(option);
    const T object = parse(value, good);
    EXPECT_EQ(good.text(), "");
    EXPECT_EQ(valueOf(option, object), value);
    EXPECT_NE(valueOf(option, T{}), value) << "the test must change something";

    const T untouched = parse("[[1]]", wrongType);
    EXPECT_NE(wrongType.text().find("error: " + option.key + " must be "), std::string::npos)
        << wrongType.text();
    for (const Option<T>& other : table) {
        // Giving the field of view takes the default away from the focal length.
        if (other.key == "focal_length") continue;
        const bool same = valueOf(other, object) == valueOf(other, untouched);
        EXPECT_EQ(same, other.key != option.key) << other.key;
    }
    if (!isNumeric(option)) return;
    const bool vector = valueOf(option, T{})[0] == '[';
    for (const double bad : {option.range.minimum - 1, option.range.maximum + 1}) {
        Diagnostics outside;
        const T same =
            parse(vector ? fmt::format("[{0}, {0}, {0}]", bad) : fmt::format("{}", bad), outside);
        const std::string message = fmt::format("{} is {}; it must be ", option.key, bad);
        EXPECT_NE(outside.text().find(message), std::string::npos) << outside.text();
        EXPECT_EQ(valueOf(option, same), valueOf(option, untouched));
    }
}

template <class T>
void checkTable(const OptionTable<T>& table, const Place<T>& place) {
    for (const Option<T>& option : table) checkRow(option, table, place);
}

TEST(Options, EveryRowOfSingleSectionsReachesItsMember) {
    checkTable<Scene>(sceneOptions(), {"[scene]\n", "", [](const Scene& s) { return s; }});
    checkTable<RenderSettings>(renderOptions(),
                               {"[render]\n", "", [](const Scene& s) { return s.render; }});
    checkTable<TreeSettings>(bvhOptions(), {"[bvh]\n", "", [](const Scene& s) { return s.bvh; }});
    checkTable<Environment>(environmentOptions(), {"[environment]\n",
                                                   "",
                                                   [](const Scene& s) { return s.environment; },
                                                   {{"sun_elevation", "sky = \"sun\"\n"},
                                                    {"sun_azimuth", "sky = \"sun\"\n"},
                                                    {"turbidity", "sky = \"sun\"\n"},
                                                    {"rotation", "sky = \"a.hdr\"\n"}}});
}

TEST(Options, EveryRowOfListedSectionsReachesItsMember) {
    checkTable<Camera>(cameraOptions(),
                       {"[[camera]]\n", "", [](const Scene& s) { return s.cameras.at(0); }});
    checkTable<Light>(lightOptions(), {"[[light]]\n",
                                       "",
                                       [](const Scene& s) { return s.lights.at(0); },
                                       {{"at", "type = \"point\"\n"},
                                        {"range", "type = \"point\"\n"},
                                        {"size", "type = \"rect\"\n"},
                                        {"azimuth", "polar = 10\n"},
                                        {"inner_angle", "type = \"spot\"\nouter_angle = 90\n"},
                                        {"outer_angle", "type = \"spot\"\n"}}});
    checkTable<Node>(nodeOptions(), {"[[node]]\n",
                                     "",
                                     [](const Scene& s) { return s.nodes.at(1); },
                                     {{"material", "shape = \"other\"\n"},
                                      {"animation", "include = \"other.glb\"\n"}}});
}

TEST(Options, EveryRowOfNamedSectionsReachesItsMember) {
    const auto shape = [](const Scene& s) { return s.shapes.at(0); };
    checkTable<Shape>(shapeOptions(), {"[shape.a]\n", "", shape});
    checkTable<Material>(materialOptions(),
                         {"[material.a]\n", "", [](const Scene& s) { return s.materials.at(0); }});
    checkTable<BoxShape>(
        boxOptions(), {"[shape.a]\nbox = { ", " }", [&](const Scene& s) { return *shape(s).box; }});
    checkTable<SphereShape>(sphereOptions(), {"[shape.a]\nsphere = { ", " }",
                                              [&](const Scene& s) { return *shape(s).sphere; }});
    checkTable<PlaneShape>(planeOptions(), {"[shape.a]\nplane = { ", " }",
                                            [&](const Scene& s) { return *shape(s).plane; }});
    checkTable<TorusShape>(torusOptions(), {"[shape.a]\ntorus = { ", " }",
                                            [&](const Scene& s) { return *shape(s).torus; }});
    checkTable<CylinderShape>(
        cylinderOptions(),
        {"[shape.a]\ncylinder = { ", " }", [&](const Scene& s) { return *shape(s).cylinder; }});
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
