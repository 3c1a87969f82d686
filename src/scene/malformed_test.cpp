// SPDX-License-Identifier: MIT
// Scenes with mistakes, and word for word what their author is told.
#include <gtest/gtest.h>

#include <chrono>
#include <random>

#include "scene/document.hpp"
#include "scene/test_scene.hpp"

namespace vitrine {
namespace {

struct Case {
    const char* what;
    std::string scene;
    std::string messages;
    /// Otherwise the name of a test would hold the bytes of pointers.
    friend void PrintTo(const Case& c, std::ostream* out) { *out << c.what; }
};

class Malformed : public testing::TestWithParam<Case> {};

TEST_P(Malformed, SaysWhatIsWrong) {
    EXPECT_EQ(problemsOf(GetParam().scene), GetParam().messages) << GetParam().scene;
}

std::string nameOf(const testing::TestParamInfo<Case>& info) {
    return info.param.what;
}

const std::string kBall = "[shape.ball]\nsphere = {}\n";

INSTANTIATE_TEST_SUITE_P(
    Text, Malformed,
    testing::Values(
        Case{"UnterminatedString", "[scene]\ntitle = \"abc\n[render]\n",
             "t:2:13: error: the text has no closing quote"},
        Case{"NoValue", "[render]\nexposure =\n",
             "t:2:11: error: key-value pair: expected value, found the end of the line"},
        Case{"WordCutInTwo", "[[node]]\nvisible = tr\nue\n",
             "t:2:13: error: boolean: expected 'true', saw 'tr?'; text needs quotes"},
        Case{"LineEndInName", "[material.\"a\\nb\"]\nx = 1\n",
             "t:2:1: error: unknown key 'x' in [material.a?b]"},
        Case{"BareWord", "[render]\ntone_map = filmic\n",
             "t:2:13: error: boolean: expected 'false', saw 'fi'; text needs quotes"},
        Case{"UnclosedArray", "[[camera]]\neye = [1, 2\n",
             "t:2:13: error: array: encountered end-of-file"},
        Case{"UnclosedHeader", "[render\nexposure = 1\n",
             "t:1:8: error: table header: expected ']', found the end of the line"},
        Case{"DuplicateKey", "[render]\nao = 1\nao = 2\n",
             "t:3:6: error: key-value pair: cannot redefine existing integer 'ao'"},
        Case{"DuplicateSection", "[render]\n[render]\n",
             "t:2:1: error: table header: cannot redefine existing table 'render'"},
        Case{"BadUtf8", "[scene]\ntitle = \"\xff\"\n",
             "t:2:9: error: Encountered invalid utf-8 sequence"},
        Case{"ZeroByte", std::string("[scene]\ntitle = \"\0\"\n", 20),
             "t:2:10: error: string: unescaped control characters other than TAB "
             "(U+0009) are explicitly prohibited"},
        Case{"HugeInteger", "[render]\nseed = 99999999999999999999\n",
             "t:2:28: error: decimal integer: '99999999999999999999' is not "
             "representable in 64 bits"},
        Case{"LongLine", "a = 1\n" + std::string(5000, ' ') + "b = 1\n",
             "t:2:4097: error: the line is longer than 4096 bytes"},
        Case{"LongDottedKey",
             [] {
                 std::string s = "a";
                 for (int i = 0; i < 100000; ++i) s += ".a";
                 return s + " = 1\n";
             }(),
             "t:1:4097: error: the line is longer than 4096 bytes"},
        Case{"LongDottedHeader",
             [] {
                 std::string s = "[";
                 for (int i = 0; i < 100000; ++i) s += "a.";
                 return s + "a]\n";
             }(),
             "t:1:4097: error: the line is longer than 4096 bytes"},
        Case{"DeepArrays", "a = " + std::string(2000, '[') + std::string(2000, ']') + "\n",
             "t:1:261: error: value: exceeded maximum nested value depth of 256"},
        Case{"TooLarge", std::string((1 << 20) + 1, '\n'),
             "t: error: the scene is larger than 1048576 bytes"}),
    nameOf);

INSTANTIATE_TEST_SUITE_P(
    Keys, Malformed,
    testing::Values(
        Case{"MisspeltSection", "[rendr]\nexposure = 1\n",
             "t:1:2: error: unknown section 'rendr' (did you mean 'render'?)"},
        Case{"UnknownSection", "[[volume]]\n", "t:1:3: error: unknown section 'volume'"},
        Case{"KeyOutsideSections", "exposure = 1\n",
             "t:1:1: error: 'exposure' belongs to no section; write one above, such as [render]"},
        Case{"MisspeltKey", "[render]\n  expsure = 1\n",
             "t:2:3: error: unknown key 'expsure' in [render] (did you mean 'exposure'?)"},
        Case{"UnknownKey", "[render]\nzebra = 1\n",
             "t:2:1: error: unknown key 'zebra' in [render]"},
        Case{"MisspeltKeyInShape", "[shape.a]\nbox = { siz = 1 }\n",
             "t:2:9: error: unknown key 'siz' in box (did you mean 'size'?)"},
        Case{"MisspeltShape", "[shape.a]\nspere = { radius = 1 }\n",
             "t:2:1: error: unknown key 'spere' in [shape.a] (did you mean 'sphere'?)"},
        Case{"MisspeltChoice", "[render]\ntone_map = \"filmc\"\n",
             "t:2:12: error: tone_map must be one of 'none', 'filmic', 'aces', 'agx', 'reinhard', "
             "not 'filmc' (did you mean "
             "'filmic'?)"},
        Case{"UnknownChoice", "[[light]]\ntype = \"lamp\"\n",
             "t:2:8: error: type must be one of 'sun', 'point', 'spot', 'sphere', 'rect', not "
             "'lamp'"},
        Case{"ListInSingleBrackets", "[camera]\neye = [1, 2, 3]\n",
             "t:1:1: error: there can be several: write [[camera]]"},
        Case{"SingleInDoubleBrackets", "[[render]]\nao = 1\n",
             "t:1:1: error: there is only one: write [render]"},
        Case{"MaterialWithoutName", "[material]\nroughness = 1\n",
             "t:2:1: error: 'roughness' belongs to no material; each has a name: write "
             "[material.NAME] above"},
        Case{"MaterialAsList", "[[material]]\nroughness = 1\n",
             "t:1:1: error: each has a name: write [material.NAME]"},
        Case{"NamedMaterialAsList", "[[material.a]]\nroughness = 1\n",
             "t:1:12: error: there is only one: write [material.a]"},
        Case{"EmptyName", "[shape.\"\"]\nsphere = {}\n", "t:1:8: error: the shape's name is empty"},
        Case{"SectionIsANumber", "render = 5\nnode = 1\nmaterial = 2\nshape = [1]\nlight = [2]\n",
             "t:1:10: error: there is only one: write [render]\n"
             "t:2:8: error: there can be several: write [[node]]\n"
             "t:3:12: error: each has a name: write [material.NAME]\n"
             "t:4:9: error: each has a name: write [shape.NAME]\n"
             "t:5:10: error: write [[light]]"}),
    nameOf);

INSTANTIATE_TEST_SUITE_P(
    Values, Malformed,
    testing::Values(
        Case{"TextForNumber", "[render]\nexposure = \"bright\"\n",
             "t:2:12: error: exposure must be a number"},
        Case{"NumberForText", "[scene]\ntitle = 1\n", "t:2:9: error: title must be text in quotes"},
        Case{"FractionForWholeNumber", "[render]\nbounces = 1.5\n",
             "t:2:11: error: bounces must be a whole number"},
        Case{"NumberForTruth", "[[node]]\nvisible = 1\n",
             "t:2:11: error: visible must be true or false"},
        Case{"TooFewNumbers", "[[camera]]\neye = [1, 2]\n",
             "t:2:7: error: eye must be three numbers, as in [0, 1, 2]"},
        Case{"TextInVector", "[[camera]]\neye = [1, \"2\", 3]\n",
             "t:2:7: error: eye must be three numbers, as in [0, 1, 2]"},
        Case{"ScaleOfTwo", "[[node]]\nscale = [1, 2]\n",
             "t:2:9: error: scale must be one number, or three as in [1, 2, 1]"},
        Case{"OutOfRange", "[render]\nbounces = 33\n",
             "t:2:11: error: bounces is 33; it must be from 0 to 32"},
        Case{"BelowTheLeast", "[shape.a]\nsphere = { radius = -1 }\n",
             "t:2:21: error: radius is -1; it must be at least 1e-06"},
        Case{"AboveAll", "[[camera]]\neye = [2e9, 0, 0]\n",
             "t:2:8: error: eye is 2000000000; it must be at most 1000000000"},
        Case{"ColourOutOfRange", "[material.a]\nbase_color = [0.5, 1.5, 0.5]\n",
             "t:2:20: error: base_color is 1.5; it must be from 0 to 1"},
        Case{"BadHexColour", "[material.a]\nbase_color = \"#12345\"\n",
             "t:2:14: error: base_color must be \"#rrggbb\" or [r, g, b]"},
        Case{"NamedColour", "[material.a]\nbase_color = \"red\"\n",
             "t:2:14: error: base_color must be \"#rrggbb\" or [r, g, b]"},
        Case{"NotANumber", "[render]\nao = nan\n", "t:2:6: error: ao must be finite"},
        Case{"Infinite", "[[camera]]\neye = [inf, 0, 0]\n", "t:2:8: error: eye must be finite"},
        Case{"Date", "[render]\nao = 2026-01-01\n", "t:2:6: error: ao must be a number"},
        Case{"ShapeIsNumber", "[shape.a]\nbox = 1\n",
             "t:2:7: error: box must be a table, as in { size = 1 }"},
        Case{"SetIsNumber", kBall + "[[node]]\nshape = \"ball\"\nset = 1\n",
             "t:5:7: error: set must be a table, as in { size = 0.5 }"},
        Case{"SetOfFive",
             kBall + "[[node]]\nshape = \"ball\"\nset = { a = [1, 2, 3, 4, 5], b = {} }\n",
             "t:5:13: error: set.a must be a number, two to four of them in brackets, a colour, "
             "true or false\n"
             "t:5:34: error: set.b must be a number, two to four of them in brackets, a colour, "
             "true or false"},
        Case{"PartsIsText", kBall + "[[node]]\nshape = \"ball\"\nparts = \"gold\"\n",
             "t:5:9: error: parts must be a table, as in { lid = \"brass\" }"},
        Case{"PartIsNumber", kBall + "[[node]]\nshape = \"ball\"\nparts = { lid = 1 }\n",
             "t:5:17: error: parts.lid must be text in quotes"}),
    nameOf);

INSTANTIATE_TEST_SUITE_P(
    Meaning, Malformed,
    testing::Values(
        Case{"EyeIsTarget", "[[camera]]\neye = [1, 2, 3]\ntarget = [1, 2, 3]\n",
             "t:1:1: error: the camera's eye and target are the same point"},
        Case{"LooksAlongUp", "[[camera]]\neye = [0, 5, 0]\ntarget = [0, 0, 0]\n",
             "t:1:1: error: the camera looks along its up direction"},
        Case{"NoUp", "[[camera]]\nup = [0, 0, 0]\n", "t:2:6: error: up has no length"},
        Case{"FovAndFocalLength", "[[camera]]\nfov = 40\nfocal_length = 50\n",
             "t:3:16: error: give fov or focal_length, not both"},
        Case{"NoDirection", "[[light]]\ndirection = [0, 0, 0]\n",
             "t:2:13: error: direction has no length"},
        Case{"SunWithPosition", "[[light]]\nat = [0, 1, 0]\n",
             "t:2:6: error: a sun light has no position"},
        Case{"DirectionAndAngles", "[[light]]\ndirection = [0, -1, 0]\npolar = 30\nazimuth = 1\n",
             "t:3:9: error: give direction, or polar and azimuth, not both\n"
             "t:4:11: error: give direction, or polar and azimuth, not both"},
        Case{"AzimuthAlone", "[[light]]\nazimuth = 1\n",
             "t:2:11: error: azimuth needs polar, the angle from the zenith"},
        Case{"PointWithAngles", "[[light]]\ntype = \"point\"\npolar = 30\n",
             "t:3:9: error: only a sun or a spot has polar"},
        Case{"PointWithDirection", "[[light]]\ntype = \"point\"\ndirection = [0, -1, 0]\n",
             "t:3:13: error: a point light has no direction"},
        Case{"PointWithCone", "[[light]]\ntype = \"point\"\nouter_angle = 30\n",
             "t:3:15: error: only a spot light has a cone"},
        Case{"ConeInsideOut", "[[light]]\ntype = \"spot\"\ninner_angle = 40\nouter_angle = 30\n",
             "t:1:1: error: inner_angle is larger than outer_angle"},
        Case{"SkyBesideZenith", "[environment]\nsky = [1, 1, 1]\nzenith = [1, 1, 1]\n",
             "t:3:10: error: zenith has no effect beside sky, which is all of them"},
        Case{"ZenithBesideAtmosphere", "[environment]\nsky = \"sun\"\nzenith = [1, 1, 1]\n",
             "t:3:10: error: zenith has no effect beside sky, which is all of them"},
        Case{"SkyOfAnotherFormat", "[environment]\nsky = \"sky.png\"\n",
             "t:2:7: error: sky must be \"sun\", a colour, or a .hdr or .exr file, not 'sky.png'"},
        Case{"SunWithoutAtmosphere", "[environment]\nsky = \"a.hdr\"\nsun_elevation = 3\n",
             "t:3:17: error: sun_elevation has no effect: sky is not \"sun\""},
        Case{"GradientTurned", "[environment]\nrotation = 3\n",
             "t:2:12: error: rotation has no effect: sky is no picture"},
        Case{"SphereWithoutRadius", "[[light]]\ntype = \"sphere\"\nradius = 0\n",
             "t:3:10: error: a sphere light needs a radius; a point has none"},
        Case{"SunTooWide", "[[light]]\nradius = 91\n",
             "t:2:10: error: the radius of a sun is at most 90 degrees"},
        Case{"RectWithoutHeight", "[[light]]\ntype = \"rect\"\nsize = [1, 0, 0]\n",
             "t:3:8: error: a rect light needs a width and a height"},
        Case{"RectWithRadius", "[[light]]\ntype = \"rect\"\nradius = 1\n",
             "t:3:10: error: a rect light has a size instead of a radius"},
        Case{"PointWithSize", "[[light]]\ntype = \"point\"\nsize = 1\n",
             "t:3:8: error: only a rect light has a size; others have a radius"},
        Case{"NoShapeGiven", "[shape.a]\n",
             "t:1:1: error: shape 'a' must have exactly one of sdf, mesh, box, sphere, plane, "
             "torus, cylinder"},
        Case{"TwoShapesGiven", "[shape.a]\nsphere = {}\nbox = {}\n",
             "t:1:1: error: shape 'a' must have exactly one of sdf, mesh, box, sphere, plane, "
             "torus, cylinder"},
        Case{"PlaneWithoutWidth", "[shape.a]\nplane = { size = [0, 0, 4] }\n",
             "t:2:9: error: a plane needs a size along x and z"},
        Case{"ZeroScale", "[[node]]\nscale = [1, 0, 1]\n", "t:2:9: error: scale must not be zero"},
        Case{"UnknownShape", kBall + "[[node]]\nshape = \"bal\"\n",
             "t:4:9: error: no shape is named 'bal' (did you mean 'ball'?)"},
        Case{"UnknownMaterial",
             kBall + "[material.gold]\n[[node]]\nshape = \"ball\"\nmaterial = \"glod\"\nparts = { "
                     "a = \"x\" }\n",
             "t:6:12: error: no material is named 'glod' (did you mean 'gold'?)\n"
             "t:7:15: error: no material is named 'x'"},
        Case{"UnknownParent", "[[node]]\nname = \"base\"\n[[node]]\nparent = \"bsae\"\n",
             "t:4:10: error: no node is named 'bsae' (did you mean 'base'?)"},
        Case{"OwnParent", "[[node]]\nname = \"a\"\nparent = \"a\"\n",
             "t:3:10: error: node 'a' is its own ancestor"},
        Case{"ParentsInACircle",
             "[[node]]\nname = \"out\"\nparent = \"a\"\n[[node]]\nname = \"a\"\nparent = "
             "\"b\"\n[[node]]\nname = \"b\"\nparent = \"a\"\n",
             "t:9:10: error: node 'b' is its own ancestor"},
        Case{"TwoNodesOfOneName", "[[node]]\nname = \"a\"\n[[node]]\nname = \"a\"\n",
             "t:3:1: error: two nodes are named 'a'; the other is at t:1:1"},
        Case{"TwoCamerasOfOneName", "[[camera]]\nname = \"a\"\n[[camera]]\nname = \"a\"\n",
             "t:3:1: error: two cameras are named 'a'; the other is at t:1:1"},
        Case{"MaterialOfNothing",
             "[material.gold]\n[[node]]\nmaterial = \"gold\"\nset = { a = 1 }\n",
             "t:3:12: error: material has no effect: the node has no shape\n"
             "t:4:7: error: set has no effect: the node has no shape"},
        Case{"Several",
             "[render]\nexposure = \"x\"\nbounces = 99\n[[camera]]\neye = "
             "[1]\n[material.a]\nroughnes = 1\n[[node]]\nshape = \"none\"\nmaterial = \"glass\"\n",
             "t:2:12: error: exposure must be a number\n"
             "t:3:11: error: bounces is 99; it must be from 0 to 32\n"
             "t:5:7: error: eye must be three numbers, as in [0, 1, 2]\n"
             "t:7:1: error: unknown key 'roughnes' in [material.a] (did you mean 'roughness'?)\n"
             "t:9:9: error: no shape is named 'none'\n"
             "t:10:12: error: no material is named 'glass'"}),
    nameOf);

constexpr const char* kGood = R"([render]
exposure = 1.5
[[camera]]
eye = [1, 2, 3]
[environment]
sky = "#80a0ff"
[material.a]
set = { x = [1, 2], y = true }
snippet = "a.mat.glsl"
[shape.b]
torus = { radius = 1, tube = 0.25 }
[[node]]
name = "n"
shape = "b"
material = "a"
parts = { "lid" = "a" }
[[animation]]
name = "turn"
node = "n"
param = "rotate"
keys = [[0, [0, 0, 0]], [1.5, [0, 90, 0]]]
ease = "smooth"
loop = "repeat"
[[animation]]
param = "render.exposure"
keys = [[1, 0]]
)";

/// Whatever happens to a scene, there are only diagnostics, and each is on a line of it.
void expectPlaced(const std::string& text) {
    Diagnostics diagnostics;
    ASSERT_NO_THROW((void)parseScene(text, "t", {}, diagnostics)) << text;
    for (const Diagnostic& d : diagnostics.list()) {
        ASSERT_EQ(d.where.file, "t") << d.text() << "\n" << text;
        ASSERT_GE(d.where.line, 1) << d.text() << "\n" << text;
        ASSERT_EQ(d.message.find('\n'), std::string::npos) << text;
    }
}

TEST(MalformedScene, CutAtEveryByte) {
    const std::string good = kGood;
    ASSERT_EQ(problemsOf(good), "");
    for (size_t length = 0; length <= good.size(); ++length) expectPlaced(good.substr(0, length));
}

TEST(MalformedScene, RandomBytes) {
    std::mt19937 random(7);
    const std::string usual = "[]{}=\"'#.,\n\t\\-+_e0159ax \xff\xc3\x80";
    for (int round = 0; round < 20000; ++round) {
        std::string text = kGood;
        for (uint32_t i = 0; i <= random() % 4; ++i) {
            const size_t at = random() % text.size();
            const char byte =
                random() % 4 == 0 ? static_cast<char>(random()) : usual[random() % usual.size()];
            if (random() % 3 == 0)
                text.insert(at, 1, byte);
            else
                text[at] = byte;
        }
        expectPlaced(text);
        if (HasFatalFailure()) return;
    }
}

/// The largest scenes that are read at all, made of the dearest mistakes.
TEST(MalformedScene, AMegabyteOfMistakesTakesNoTime) {
    const auto fill = [](const auto& line) {
        std::string text;
        for (int i = 0;; ++i) {
            const std::string next = line(std::to_string(i));
            if (text.size() + next.size() > kMaxSceneBytes) return text;
            text += next;
        }
    };
    // Nine thousand keys for each of eighty thousand lights.
    std::string everyLight = "[[animation]]\nparam='light.range'\nkeys=[\n";
    for (int i = 0; i < 9000; ++i) everyLight += "[" + std::to_string(i) + ",1],\n";
    everyLight += "]\n";
    for (int i = 0; i < 80000; ++i) everyLight += "[[light]]\n";
    const std::string scenes[] = {
        fill([](const std::string& i) {
            return "[[node]]\nname='" + i + "'\nparent='x" + i + "'\n";
        }),
        fill([](const std::string&) { return "[[node]]\nname='n'\nparent='n'\n"; }),
        fill([](const std::string& i) {
            return "[shape.s" + i + "]\n[[node]]\nshape='t" + i + "'\n";
        }),
        fill([](const std::string& i) { return "[x" + i + "]\n"; }),
        fill([](const std::string& i) {
            return "[[node]]\nname='" + i + "'\n[[animation]]\nnode='x" + i +
                   "'\nparam='at'\nkeys=[[0,[0,0,0]]]\n";
        }),
        fill([](const std::string&) {
            return "[[light]]\n[[animation]]\nparam='light.range'\nkeys=[[0,1]]\n";
        }),
        fill([](const std::string&) {
            return "[[light]]\n[[animation]]\nparam='light.rang'\nkeys=[[0,1]]\n";
        }),
        everyLight,
        "[[camera]]\neye = [\n" + fill([](const std::string&) { return "1,\n"; }).substr(30) +
            "]\n"};
    for (const std::string& scene : scenes) {
        const auto start = std::chrono::steady_clock::now();
        EXPECT_NE(problemsOf(scene), "");
        const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
        EXPECT_LT(elapsed.count(), 20) << scene.substr(0, 50);
    }
}

}  // namespace
}  // namespace vitrine
