// SPDX-License-Identifier: MIT
// The command line where it draws; any OpenGL will do.
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "cli_run.hpp"
#include "image/png.hpp"

namespace vitrine {
namespace {

using Json = nlohmann::json;
using Arguments = std::vector<std::string>;

constexpr const char* kScene = R"([[camera]]
name = "front"
eye = [0, 1, 4]
[[camera]]
name = "top"
eye = [0, 6, 1]
[[light]]
direction = [-1, -2, -1]
[material.m]
base_color = [0.8, 0.1, 0.1]
[shape.crate]
box = { size = 1 }
[shape.ball]
sdf = "ball.sdf.glsl"
[[node]]
shape = "crate"
material = "m"
[[node]]
name = "ball"
shape = "ball"
at = [0.8, 0, 0]
)";
constexpr const char* kBall =
    "// bounds[-1, -1, -1,  1, 1, 1]\n"
    "uniform float radius;  // slider[0.1, 0.5, 1.0] Radius\n"
    "float sdf(vec3 p) { return length(p) - radius * (1.0 - 0.1 * time); }\n";

/// A triangle in a node of this scale, with a camera, as a file by itself.
std::string model(double scale) {
    Json json = Json::parse(R"({"asset": {"version": "2.0"},
        "buffers": [{"byteLength": 36, "uri": "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}],
        "bufferViews": [{"buffer": 0, "byteLength": 36}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "type": "VEC3", "count": 3}],
        "materials": [{"name": "Brass", "doubleSided": true,
                       "pbrMetallicRoughness": {"baseColorFactor": [1, 0, 0, 1], "metallicFactor": 0}}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "material": 0}]}],
        "cameras": [{"name": "eye", "type": "perspective", "perspective": {"yfov": 0.8, "znear": 0.1}}],
        "nodes": [{"name": "leaf", "mesh": 0}, {"camera": 0, "translation": [0.3, 0.3, 2]}]})");
    json["nodes"][0]["scale"] = {scale, scale, scale};
    return json.dump(2);
}

class CliGpu : public CliTest {
  protected:
    void SetUp() override {
        CliTest::SetUp();
        write("s.toml", kScene);
        write("ball.sdf.glsl", kBall);
    }
    /// Draws 64 by 40 pixels into `file`.
    [[nodiscard]] Outcome draw(const std::string& file, const Arguments& more = {},
                               const Arguments& environment = {}) const {
        Arguments arguments{"render", "s.toml", "-o", file, "-r", "64x40"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run(arguments, environment);
    }
    /// Draws and expects that all is good and quiet.
    [[nodiscard]] std::string drawn(const std::string& file, const Arguments& more = {},
                                    const Arguments& environment = {}) const {
        const Outcome o = draw(file, more, environment);
        EXPECT_EQ(o.code, 0) << o.err;
        EXPECT_EQ(o.out + o.err, "") << "a pipe gets no progress";
        return read(file);
    }
    [[nodiscard]] ImageRgba8 picture(const std::string& file) const {
        const std::string bytes = read(file);
        return decodePng({reinterpret_cast<const uint8_t*>(bytes.data()), bytes.size()}, file);
    }
};

TEST_F(CliGpu, DrawsAPicture) {
    (void)drawn("x.png");
    const ImageRgba8 image = picture("x.png");
    EXPECT_EQ(image.width, 64);
    EXPECT_EQ(image.height, 40);
    const auto red = image.at(28, 20);
    EXPECT_GT(red[0], red[1] + 40) << "the crate stands left of the middle";
    EXPECT_GE(image.at(0, 0)[2], image.at(0, 0)[0]) << "and there is sky above";
    EXPECT_EQ(files(), (Arguments{"ball.sdf.glsl", "s.toml", "x.png"})) << "no temporary is left";
}

TEST_F(CliGpu, DrawsLayers) {
    const std::string bytes = drawn("x.exr", {"--spp", "2"});
    EXPECT_EQ(drawn("again.exr", {"--spp", "2"}), bytes);
    for (const char* layer : {"albedo.R", "normal.Z", "depth.Z", "id.instance", "id.material"})
        EXPECT_NE(bytes.find(layer), std::string::npos) << layer;
    (void)drawn("x.png", {"--spp", "2", "--set", "render.tone_map=none"});
    const Arguments alike{"compare", "x.exr", "x.png", "--tolerance", "1", "--fraction", "0"};
    EXPECT_EQ(run(alike).code, 0);
    (void)drawn("x.png", {"--spp", "2", "--set", "render.tone_map=none", "--time", "3"});
    EXPECT_EQ(run(alike).code, 1);
    (void)drawn("x.exr", {"--spp", "2", "--set", "render.exposure=2"});
    EXPECT_EQ(read("x.exr"), bytes) << "exposure is no matter of light";
}

TEST_F(CliGpu, DrawsLayersOfFrames) {
    EXPECT_EQ(draw("f_##.exr", {"--frames", "0-24:24"}).code, 0);
    EXPECT_EQ(files(), (Arguments{"ball.sdf.glsl", "f_00.exr", "f_24.exr", "s.toml"}));
    const Json json = Json::parse(run({"compare", "f_00.exr", "f_24.exr", "--json", "-"}).out);
    EXPECT_EQ(json["values"], "linear");
    EXPECT_GT(json["rmse"], 0.001) << "the ball shrinks";
}

TEST_F(CliGpu, OptionsChangeThePicture) {
    const std::string plain = drawn("x.png");
    for (const Arguments& more : std::vector<Arguments>{{"--camera", "top"},
                                                        {"--view", "normal"},
                                                        {"--time", "3"},
                                                        {"--set", "node.ball.set.radius=0.9"},
                                                        {"--set", "render.exposure=1"},
                                                        {"--spp", "4"}})
        EXPECT_NE(drawn("y.png", more), plain) << more[0] << " " << more[1];
    EXPECT_EQ(drawn("y.png", {"--camera", "front"}), plain);
}

TEST_F(CliGpu, StatisticsHaveAllKeys) {
    const Outcome o = draw("x.png", {"--spp", "2", "--json", "-"});
    EXPECT_EQ(o.code, 0) << o.err;
    const Json json = Json::parse(o.out);
    for (const char* key :
         {"vitrine", "scene", "resolution", "samples", "bounces", "triangles", "instances", "rays",
          "nodes_visited", "field_evaluations", "largest_loop_count", "seconds_by_pass",
          "seconds_compiling", "seconds", "renderer", "gl_vendor", "gl_version", "backend"})
        EXPECT_TRUE(json.contains(key)) << key;
    EXPECT_EQ(json["resolution"], (std::vector<int>{64, 40}));
    EXPECT_EQ(json["samples"], 2);
    EXPECT_EQ(json["triangles"], 12);
    EXPECT_EQ(json["instances"], 2);
    EXPECT_EQ(json["rays"]["primary"], 2 * 64 * 40);
    EXPECT_GT(json["rays"]["shadow"], 0);
    EXPECT_GT(json["rays"]["bounce"], 0);
    EXPECT_GT(json["field_evaluations"], 0);
    EXPECT_GT(json["largest_loop_count"], 0);
    EXPECT_LT(json["largest_loop_count"], 65535) << "where llvmpipe ends loops without a word";
    for (const char* pass :
         {"raster", "march", "light", "bounce", "accumulate", "display"})
        EXPECT_GE(json["seconds_by_pass"].at(pass), 0.0) << pass;
    EXPECT_EQ(draw("x.png", {"--json", "x.json"}).code, 0);
    EXPECT_EQ(Json::parse(read("x.json"))["samples"], 1);
}

TEST_F(CliGpu, DrawsFrames) {
    const Outcome o = draw("f_###.png", {"--frames", "0-3", "--fps", "1"});
    EXPECT_EQ(o.code, 0) << o.err;
    EXPECT_EQ(files(), (Arguments{"ball.sdf.glsl", "f_000.png", "f_001.png", "f_002.png",
                                  "f_003.png", "s.toml"}));
    EXPECT_NE(read("f_000.png"), read("f_003.png")) << "the ball shrinks";
    EXPECT_EQ(read("f_003.png"), drawn("t.png", {"--time", "3"})) << "frame 3 is second 3";
    const Outcome skipped = draw("g_#.png", {"--frames", "2-9:5"});
    EXPECT_EQ(skipped.code, 0);
    EXPECT_TRUE(exists("g_2.png") && exists("g_7.png"));
    EXPECT_FALSE(exists("g_3.png") || exists("g_12.png"));
}

TEST_F(CliGpu, AnimatesNodesFromAnIncludedFile) {
    write("part.toml",
          "[[node]]\nname = \"other\"\nshape = \"crate\"\n[[animation]]\nnode = \"other\"\n"
          "param = \"at\"\nkeys = [[0, [-1, 0, 0]], [3, [-1, 1.5, 0]]]\n");
    write("s.toml", "[scene]\ninclude = [\"part.toml\"]\n" + std::string(kScene));
    EXPECT_EQ(draw("f_#.png", {"--frames", "0-3", "--fps", "1"}).code, 0);
    for (const char* frame : {"0", "2", "3"})
        EXPECT_EQ(read(std::string("f_") + frame + ".png"), drawn("t.png", {"--time", frame}))
            << frame;
    const std::string still = drawn("a.png", {"--time", "2", "--set", "node.other.at=[9,9,9]"});
    EXPECT_NE(drawn("b.png", {"--time", "2"}), still);
    write("part.toml", "[[node]]\nname = \"other\"\nshape = \"crate\"\nat = [9, 9, 9]\n");
    EXPECT_EQ(drawn("c.png", {"--time", "2"}), still) << "what --set gives is not animated";
}

TEST_F(CliGpu, TheSameBytesEachTime) {
    const std::string first = drawn("x.png", {"--spp", "3", "--seed", "5"});
    EXPECT_EQ(drawn("y.png", {"--spp", "3", "--seed", "5"}), first);
    for (const char* threads : {"LP_NUM_THREADS=0", "LP_NUM_THREADS=1", "LP_NUM_THREADS=2"})
        EXPECT_EQ(drawn("y.png", {"--spp", "3", "--seed", "5"}, {threads}), first) << threads;
    EXPECT_NE(drawn("y.png", {"--spp", "3", "--seed", "6"}), first);
}

TEST_F(CliGpu, AKilledRenderLeavesNoPicture) {
    Arguments arguments{"render", "s.toml", "-o", "x.png", "-r", "256x160", "--spp", "60000"};
    const Outcome o = run(arguments, {}, 1.5);
    EXPECT_EQ(o.signal, SIGKILL) << "it should still have been at work";
    EXPECT_EQ(files(), (Arguments{"ball.sdf.glsl", "s.toml"}));
    write("x.png", "old");
    EXPECT_EQ(run(arguments, {}, 1.5).signal, SIGKILL);
    EXPECT_EQ(read("x.png"), "old");
}

TEST_F(CliGpu, DrawsBareFiles) {
    write("tri.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\nf 2 3 4\n");
    write("far.obj", "v 5e8 0 0\nv 6e8 0 0\nv 5e8 1e8 0\nf 1 2 3\n");
    write("tiny.obj", "v 0 0 0\nv 3e-7 0 0\nv 0 3e-7 0\nf 1 2 3\n");
    write("metre.gltf", model(1));
    write("tiny.gltf", model(1e-6));
    write("far.gltf", model(1e8));
    for (const char* file : {"tri.obj", "ball.sdf.glsl", "far.obj", "tiny.obj", "metre.gltf",
                             "tiny.gltf", "far.gltf"}) {
        const Arguments with{"render", file, "-o", "x.png", "-r", "64x40", "--view", "depth"};
        Arguments without = with;
        without[3] = "y.png";
        without.insert(without.end(), {"--set", "node.object.visible=false"});
        for (const Arguments& arguments : {with, without}) {
            const Outcome o = run(arguments);
            EXPECT_EQ(o.code, 0) << file;
            EXPECT_EQ(o.err, "") << file;
        }
        const ImageRgba8 there = picture("x.png"), gone = picture("y.png");
        size_t differing = 0;
        for (size_t i = 0; i < there.pixels.size(); i += 4)
            differing += there.pixels[i] != gone.pixels[i] ? 1 : 0;
        EXPECT_GT(differing, 100u) << file << ": the object is large in the picture";
    }
}

TEST_F(CliGpu, ModelsBringCamerasAndMaterials) {
    write("leaf.gltf", model(1));
    write("m.toml", "[[node]]\nname = \"a\"\ninclude = \"leaf.gltf\"\n");
    const auto middle = [&](const Arguments& more) {
        Arguments arguments{"render", "m.toml", "-o", "x.png", "-r", "64x40", "--view", "albedo"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Outcome o = run(arguments);
        EXPECT_EQ(o.code, 0) << o.err;
        const ImageRgba8 image = picture("x.png");
        const auto pixel = image.at(32, 20);
        return std::array<int, 3>{pixel[0], pixel[1], pixel[2]};
    };
    EXPECT_EQ(middle({}), (std::array{255, 0, 0})) << "the model's camera is the only one";
    EXPECT_EQ(middle({"--camera", "a/eye", "--set", "material.leaf/Brass.base_color=[0,1,0]"}),
              (std::array{0, 255, 0}));
    EXPECT_EQ(middle({"--set", "node.a/leaf.at=[0,9,0]"}), (std::array{0, 0, 0}));
    const Outcome info = run({"info", "leaf.gltf"});
    EXPECT_EQ(info.code, 0);
    EXPECT_NE(info.out.find("cameras: plinth, object/eye"), std::string::npos) << info.out;
    EXPECT_NE(info.out.find("mesh leaf/mesh 0: 1 triangles"), std::string::npos) << info.out;
    EXPECT_EQ(run({"check", "leaf.gltf"}).out, "leaf.gltf: good\n");

    write("leaf.gltf", "{\n \"asset\": {\"version\": \"2.0\"},\n \"nodes\": [{\"mesh\": 0}]\n}");
    for (const char* file : {"leaf.gltf", "m.toml"}) {
        const Outcome check = run({"check", file});
        EXPECT_EQ(check.code, 1);
        EXPECT_NE(check.out.find("leaf.gltf:3:"), std::string::npos) << check.out;
    }
}

TEST_F(CliGpu, MistakesInSnippetsAreAtTheUsersLine) {
    write("loop.sdf.glsl",
          "// bounds[-1, -1, -1,  1, 1, 1]\nfloat sdf(vec3 p) {\n    float d = 1.0;\n"
          "    for (int i = 0; i < 3; i++) {\n        d += nothing(p) * 0.1;\n    }\n"
          "    return d;\n}\n");
    write("type.sdf.glsl",
          "// bounds[-1, -1, -1,  1, 1, 1]\nfloat sdf(vec3 p) {\n"
          "    float d = p;\n    return d;\n}\n");
    write("m.mat.glsl",
          "void material(inout Surface s) {\n    s.roughness = 0.5;\n"
          "    s.colour = vec3(1.0);\n}\n");
    write("s.toml",
          "[shape.a]\nsdf = \"loop.sdf.glsl\"\n[shape.b]\nsdf = \"type.sdf.glsl\"\n"
          "[material.m]\nsnippet = \"m.mat.glsl\"\n[[node]]\nshape = \"a\"\n"
          "material = \"m\"\n[[node]]\nshape = \"b\"\n");
    const auto expectAll = [](const std::string& text) {
        EXPECT_NE(text.find("loop.sdf.glsl:5:14: error: "), std::string::npos) << text;
        EXPECT_NE(text.find("'nothing'"), std::string::npos) << text;
        EXPECT_NE(text.find("type.sdf.glsl:3:5: error: "), std::string::npos) << text;
        EXPECT_NE(text.find("m.mat.glsl:3:5: error: "), std::string::npos) << text;
        EXPECT_NE(text.find("colour"), std::string::npos) << text;
    };
    const Outcome check = run({"check", "s.toml"});
    EXPECT_EQ(check.code, 1);
    expectAll(check.out);
    const Outcome render = draw("x.png");
    EXPECT_EQ(render.code, 1);
    expectAll(render.err);
    EXPECT_FALSE(exists("x.png"));
}

TEST_F(CliGpu, CheckMeasuresFields) {
    write("steep.sdf.glsl", "float sdf(vec3 p) { return 3.0 * (length(p) - 0.5); }\n");
    const Outcome text = run({"check", "steep.sdf.glsl", "-o", "slice.png"});
    EXPECT_EQ(text.code, 0) << text.err;
    EXPECT_EQ(text.out.find("steep.sdf.glsl: warning: the field is no distance: its slope is 3"),
              0u)
        << text.out;
    EXPECT_NE(text.out.find("; steps are divided by 3.1."), std::string::npos) << text.out;
    EXPECT_NE(text.out.find("steep.sdf.glsl: field: bounds[-0.54, -0.54, -0.54,  0.54, 0.54, "
                            "0.54] (found)"),
              std::string::npos)
        << text.out;

    const Json list = Json::parse(run({"check", "steep.sdf.glsl", "--json", "-"}).out);
    ASSERT_EQ(list.size(), 2u);
    EXPECT_EQ(list[0]["severity"], "warning");
    EXPECT_EQ(list[1]["severity"], "note");
    const Json& field = list[1]["field"];
    EXPECT_NEAR(field["slope"], 3, 0.03);
    EXPECT_EQ(field["bounds_found"], true);
    EXPECT_NEAR(field["steps_divided_by"], 3.1, 1e-5);
    EXPECT_EQ(field["slope_place"]["at"].size(), 3u);
    EXPECT_EQ(field["not_finite"], 0);
    const std::string scene = run({"check", "s.toml"}).out;
    EXPECT_EQ(scene.find("ball.sdf.glsl: field: bounds["), 0u) << scene;
    EXPECT_EQ(run({"render", "steep.sdf.glsl", "-o", "x.png", "-r", "64x40"}).err, "");
    EXPECT_EQ(run({"check", "s.toml", "-o", "slice.png"}).code, 2);
    EXPECT_EQ(run({"check", "steep.sdf.glsl", "-o", "slice.jpg"}).code, 2);
}

// The ball of slope 3 has a radius of 0.5 in bounds of 1.08: on the paper its rim is where its
// formula says, and all that is outside of it is hatched.
TEST_F(CliGpu, ASliceShowsTheField) {
    write(
        "steep.sdf.glsl",
        "// bounds[-1, -1, -1,  1, 1, 1]\nfloat sdf(vec3 p) { return 3.0 * (length(p) - 0.5); }\n");
    EXPECT_EQ(run({"check", "steep.sdf.glsl", "-o", "slice.png"}).code, 0);
    const ImageRgba8 image = picture("slice.png");
    EXPECT_EQ(image.width, 900);
    EXPECT_GT(image.height, 950) << "with a legend";
    write("true.sdf.glsl",
          "// bounds[-1, -1, -1,  1, 1, 1]\nfloat sdf(vec3 p) { return length(p) - 0.5; }\n");
    EXPECT_EQ(run({"check", "true.sdf.glsl", "-o", "slice.png"}).code, 0);
    const ImageRgba8 clean = picture("slice.png");
    const auto isInk = [](const ImageRgba8& i, int x, int y) {
        const auto p = i.at(x, y);
        return p[0] < 60 && p[1] < 60 && p[2] < 60;
    };
    const auto red = [](const ImageRgba8& i) {
        int count = 0;
        for (int y = 0; y < i.width; ++y)
            for (int x = 0; x < i.width; ++x)
                count += i.at(x, y)[0] > 190 && i.at(x, y)[1] < 100 ? 1 : 0;
        return count;
    };
    // 2.48 units are 900 pixels; the middle plane shows the whole circle.
    int rim = 0;
    for (int degree = 0; degree < 360; ++degree) {
        const double a = degree * 3.14159265 / 180, r = 0.5 / 2.48 * 900;
        rim += isInk(clean, static_cast<int>(450 + r * std::cos(a)),
                     static_cast<int>(450 - r * std::sin(a)))
                   ? 1
                   : 0;
    }
    EXPECT_EQ(rim, 360);
    EXPECT_EQ(red(clean), 0);
    EXPECT_GT(red(image), 40000);
    // Inside is blue, outside is orange.
    EXPECT_GT(clean.at(450, 450)[2], clean.at(450, 450)[0] + 20);
    EXPECT_GT(clean.at(100, 100)[0], clean.at(100, 100)[2] + 20);
}

TEST_F(CliGpu, SceneAndSnippetMistakesComeTogether) {
    write("type.sdf.glsl", "// bounds[-1, -1, -1,  1, 1, 1]\nfloat sdf(vec3 p) { return p; }\n");
    write("s.toml", "[render]\nao = -1\n[shape.b]\nsdf = \"type.sdf.glsl\"\n");
    for (const Outcome& o : {run({"check", "s.toml"}), draw("x.png")}) {
        EXPECT_EQ(o.code, 1);
        const std::string text = o.out + o.err;
        EXPECT_NE(text.find("s.toml:2:6: error: ao is -1"), std::string::npos) << text;
        EXPECT_NE(text.find("type.sdf.glsl:2:21: error: "), std::string::npos) << text;
    }
}

}  // namespace
}  // namespace vitrine
