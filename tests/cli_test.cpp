// SPDX-License-Identifier: MIT
// The command line without OpenGL: exit codes and messages, checking, measuring, comparing.
#include <sys/stat.h>
#include <sys/wait.h>

#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "cli_run.hpp"
#include "image/png.hpp"

namespace vitrine {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

class Cli : public CliTest {
  protected:
    void SetUp() override {
        CliTest::SetUp();
        write("good.toml",
              "[shape.crate]\nbox = { size = 1 }\n[[node]]\nshape = \"crate\"\n"
              "[[node]]\nshape = \"crate\"\nat = [2, 0, 0]\n");
    }
    void writePicture(const std::string& file, const ImageRgba8& image) const {
        const std::vector<uint8_t> bytes = encodePng(image);
        write(file, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    }
    static ImageRgba8 grey(int width, int height, uint8_t value) {
        return {width, height,
                std::vector<uint8_t>(static_cast<size_t>(width * height) * 4, value)};
    }
};

TEST_F(Cli, AGoodSceneIsGood) {
    const Outcome o = run({"check", "good.toml"});
    EXPECT_EQ(o.code, 0);
    EXPECT_EQ(o.out, "good.toml: good\n");
    EXPECT_EQ(o.err, "");
    EXPECT_EQ(run({"check", "good.toml", "--json", "-"}).out, "[]\n");
}

constexpr const char* kFourErrors = R"([render]
expsure = 1
bounces = 99
[shape.a]
mesh = "missing.obj"
[shape.b]
sdf = "bad.sdf.glsl"
)";
constexpr const char* kFourMessages =
    "four.toml:2:1: error: unknown key 'expsure' in [render] (did you mean 'exposure'?)\n"
    "four.toml:3:11: error: bounces is 99; it must be from 0 to 32\n"
    "four.toml:5:8: error: 'missing.obj': cannot read: No such file or directory\n"
    "bad.sdf.glsl:2:36: error: a ';' is missing behind this\n";

TEST_F(Cli, FourErrorsInOneRun) {
    write("four.toml", kFourErrors);
    write("bad.sdf.glsl",
          "// bounds[-1, -1, -1,  1, 1, 1]\nfloat sdf(vec3 p) { return length(p) }\n");
    const Outcome check = run({"check", "four.toml"});
    EXPECT_EQ(check.code, 1);
    EXPECT_EQ(check.out, kFourMessages);
    const Outcome render = run({"render", "four.toml", "-o", "x.png"});
    EXPECT_EQ(render.code, 1);
    EXPECT_EQ(render.err, kFourMessages);
    EXPECT_FALSE(exists("x.png"));
    const Outcome json = run({"check", "four.toml", "--json", "-"});
    EXPECT_EQ(json.code, 1);
    const Json list = Json::parse(json.out);
    ASSERT_EQ(list.size(), 4u);
    EXPECT_EQ(list[1]["file"], "four.toml");
    EXPECT_EQ(list[1]["line"], 3);
    EXPECT_EQ(list[1]["column"], 11);
    EXPECT_EQ(list[1]["severity"], "error");
}

TEST_F(Cli, ACommandLineAtFaultIsTwo) {
    const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
        {{"render", "good.toml", "-o", "x.png", "--viw", "normal"}, "--viw"},
        {{"render", "good.toml", "-o", "x.png", "--view", "nrmal"}, "(did you mean 'normal'?)"},
        {{"render", "good.toml", "-o", "x.png", "--view", "bhv=4"}, "(did you mean 'bvh'?)"},
        {{"render", "good.toml", "-o", "x.png", "--view", "bvh"}, "as in bvh=4"},
        {{"render", "good.toml", "-o", "x.png", "--view", "bvh=64"}, "0 to 63"},
        {{"render", "good.toml", "-o", "x.png", "--view", "bvh=4x"}, "as in bvh=4"},
        {{"render", "good.toml", "-o", "x.png", "--view", "normal=1"}, "takes no value"},
        {{"info", "good.toml", "--export-bvh", "x.ply"}, "must end in .obj"},
        {{"info", "good.toml", "--level", "2"}, "--export-bvh"},
        {{"info", "good.toml", "--export-bvh", "x.obj", "--level", "64"}, "64"},
        {{"render", "good.toml", "-o", "x.png", "--frames", "0-3"}, "needs ####"},
        {{"render", "good.toml", "-o", "x_#.png", "--frames", "3-0"}, "--frames: '3-0'"},
        {{"render", "good.toml", "-o", "x.png", "-r", "640"}, "-r: '640' is not WIDTHxHEIGHT"},
        {{"render", "good.toml", "-o", "x.png", "-r", "0x10"}, "-r: '0x10'"},
        {{"render", "good.toml", "-o", "x.png", "-r", "20000x10"}, "from 1 to 16384"},
        {{"render", "good.toml", "-o", "x.jpg"}, "-o: 'x.jpg' must end in .png or .exr"},
        {{"render", "good.toml", "-o", "x.png", "--spp", "0"}, "--spp"},
        {{"render", "good.toml", "-o", "x.png", "--time", "nan"}, "--time: 'nan'"},
        {{"render", "good.toml", "-o", "x.png", "--fps", "nan"}, "--fps: 'nan'"},
        {{"render", "good.toml", "-o", "x.png", "--backend", "metal"}, "--backend"},
        {{"render", "good.toml", "-o", "x.png", "--camera", "side"}, "no camera 'side'"},
        {{"render", "good.toml"}, "--output"},
        {{"render", "-o", "x.png"}, "FILE"},
        {{"compare", "a.png"}, "B is required"},
        {{"compare", "a.png", "b.png", "--tolerance", "nan"}, "--tolerance: 'nan'"},
        {{"paint", "good.toml"}, "paint"},
    };
    for (const auto& [arguments, message] : cases) {
        const Outcome o = run(arguments);
        EXPECT_EQ(o.code, 2) << message;
        EXPECT_NE((o.out + o.err).find(message), std::string::npos) << o.out << o.err;
    }
    EXPECT_EQ(files(), std::vector<std::string>{"good.toml"});
}

TEST_F(Cli, InfoComparesBuilders) {
    write("ball.toml",
          "[bvh]\nbuilder = \"nine\"\nmax_leaf_size = 1\n[shape.b]\nsphere = { radius = 1 }\n"
          "[[node]]\nshape = \"b\"\n");
    const Json mesh =
        Json::parse(run({"info", "ball.toml", "--builders", "--json", "-"}).out).at("meshes").at(0);
    EXPECT_EQ(mesh.at("builder"), "nine");
    EXPECT_EQ(mesh.at("leaf_sizes").at(1), mesh.at("leaves"));
    EXPECT_EQ(mesh.at("references"), mesh.at("triangles"));
    ASSERT_EQ(mesh.at("builders").size(), 3u);
    EXPECT_EQ(mesh.at("builders").at("nine").at("sah_cost"), mesh.at("sah_cost"));
    for (const auto& [name, tree] : mesh.at("builders").items()) {
        EXPECT_GT(tree.at("sah_cost").get<double>(), 1) << name;
        EXPECT_GE(tree.at("references"), mesh.at("triangles")) << name;
        EXPECT_GT(tree.at("tree_bytes").get<int>(), 48 * mesh.at("triangles").get<int>()) << name;
    }
    // Without being asked it does not build what nobody uses.
    EXPECT_EQ(run({"info", "ball.toml", "--json", "-"}).out.find("builders"), std::string::npos);
}

TEST_F(Cli, InfoExportsBoxes) {
    const Outcome o = run({"info", "good.toml", "--export-bvh", "boxes.obj", "--level", "0"});
    EXPECT_EQ(o.code, 0) << o.err;
    const std::string text = read("boxes.obj");
    const auto count = [&](const std::string& word) {
        size_t found = 0;
        for (size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
            ++found;
        return found;
    };
    EXPECT_EQ(count("\no "), 2u);
    EXPECT_EQ(count("\nv "), 16u);
    EXPECT_EQ(count("\nf "), 12u);
    EXPECT_NE(text.find("v 2.5 0.5 0.5\n"), std::string::npos) << "in the world";
    EXPECT_EQ(run({"check", "boxes.obj"}).code, 0) << "readable by ourselves";
    EXPECT_EQ(run({"info", "good.toml", "--export-bvh", "missing/boxes.obj"}).code, 3);
}

TEST_F(Cli, HelpAndVersionAreGood) {
    for (const auto& arguments : std::vector<std::vector<std::string>>{
             {"--help"}, {"--version"}, {"render", "--help"}, {"check", "--help"}}) {
        const Outcome o = run(arguments);
        EXPECT_EQ(o.code, 0);
        EXPECT_NE(o.out, "");
    }
}

TEST_F(Cli, AMachineAtFaultIsThree) {
    const Outcome missing = run({"render", "good.toml", "-o", "no/x.png"});
    EXPECT_EQ(missing.code, 3);
    EXPECT_EQ(missing.err, "vitrine: cannot write 'no/x.png': No such file or directory\n");
    EXPECT_EQ(run({"render", "nothere.toml", "-o", "no/x.png"}).code, 3)
        << "asked before the scene";
    EXPECT_EQ(run({"render", "good.toml", "-o", "x.png", "--json", "no/x.json"}).code, 3);
    EXPECT_EQ(run({"info", "good.toml", "--json", "no/x.json"}).code, 3);
    fs::create_directory(folder / "folder.png");
    EXPECT_EQ(run({"render", "good.toml", "-o", "folder.png"}).code, 3);
    ASSERT_EQ(::mkfifo((folder / "pipe.json").c_str(), 0600), 0);
    EXPECT_EQ(run({"info", "good.toml", "--json", "pipe.json"}).code, 3);
    EXPECT_TRUE(fs::is_fifo(folder / "pipe.json"));
    const std::string fullDisk =
        "cd " + folder.string() + " && " VITRINE_PROGRAM " info good.toml > /dev/full 2> full.txt";
    EXPECT_EQ(WEXITSTATUS(std::system(fullDisk.c_str())), 3);
    EXPECT_EQ(read("full.txt"), "vitrine: cannot write to standard output\n");
}

TEST_F(Cli, WithoutOpenGlItSaysWhatToInstall) {
    const std::vector<std::string> none{"__EGL_VENDOR_LIBRARY_DIRS=/nonexistent"};
    const Outcome o = run({"render", "good.toml", "-o", "x.png", "-r", "8x8"}, none);
    EXPECT_EQ(o.code, 3);
    EXPECT_NE(o.err.find("install 'libegl1 libgl1-mesa-dri'"), std::string::npos) << o.err;
    EXPECT_EQ(run({"check", "good.toml"}, none).code, 0) << "nothing to be compiled";
    write("f.sdf.glsl",
          "// bounds[-1, -1, -1,  1, 1, 1]\nfloat sdf(vec3 p) { return length(p); }\n");
    write("field.toml", "[shape.a]\nsdf = \"f.sdf.glsl\"\n[[node]]\nshape = \"b\"\n");
    const Outcome check = run({"check", "field.toml"}, none);
    EXPECT_EQ(check.code, 1) << "what is known to be wrong is said all the same";
    EXPECT_EQ(check.out.find("field.toml:4:9: error: no shape is named 'b'"), 0u) << check.out;
    EXPECT_NE(check.out.find("field.toml: warning: the snippets were not compiled: no usable"),
              std::string::npos);
    EXPECT_NE(check.out.find("field.toml: warning: nor were the fields measured"),
              std::string::npos);
    write("f.sdf.glsl", "float sdf(vec3 p) { return length(p); }\n");
    const Outcome unbound = run({"check", "f.sdf.glsl"}, none);
    EXPECT_EQ(unbound.code, 1);
    EXPECT_EQ(unbound.out.find("f.sdf.glsl: error: the field has no bounds, and they cannot be "
                               "found without OpenGL; write them"),
              0u)
        << unbound.out;
}

TEST_F(Cli, FilesThatAreNoScenes) {
    ASSERT_EQ(::mkfifo((folder / "pipe.toml").c_str(), 0600), 0);
    ASSERT_EQ(::mkfifo((folder / "pipe.obj").c_str(), 0600), 0);
    fs::create_directory(folder / "folder.toml");
    write("empty.obj", "");
    write("huge.toml", std::string((1 << 20) + 1, '\n'));
    const std::vector<std::pair<std::string, std::string>> cases{
        {"nothere.toml", "nothere.toml: error: cannot read: No such file or directory\n"},
        {"pipe.toml", "pipe.toml: error: not a regular file\n"},
        {"pipe.obj", "pipe.obj: error: not a regular file\n"},
        {"folder.toml", "folder.toml: error: not a regular file\n"},
        {"huge.toml", "huge.toml: error: too large: 1048577 bytes, at most 1048576 are read\n"},
        {"picture.jpg",
         "picture.jpg: error: not a scene (.toml), a model (.gltf, .glb, .obj) or a field "
         "(.sdf.glsl)\n"}};
    for (const auto& [file, message] : cases)
        for (const char* command : {"check", "info"}) {
            const Outcome o = run({command, file}, {}, 10);
            EXPECT_EQ(o.code, 1) << file;
            EXPECT_EQ(o.out + o.err, message);
        }
    EXPECT_EQ(run({"check", "empty.obj"}).code, 1);
}

TEST_F(Cli, NothingOutsideTheFolderIsRead) {
    write("secret.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    fs::create_directory(folder / "scene");
    fs::create_symlink("../secret.obj", folder / "scene/link.obj");
    fs::create_directory_symlink("..", folder / "scene/up");
    const std::vector<std::string> paths{"../secret.obj", "link.obj", "up/secret.obj",
                                         "a/../../secret.obj", folder / "secret.obj"};
    for (const std::string& path : paths) {
        write("scene/s.toml", "[shape.a]\nmesh = \"" + path + "\"\n[[node]]\nshape = \"a\"\n");
        const Outcome o = run({"check", "scene/s.toml"});
        EXPECT_EQ(o.code, 1) << path;
        EXPECT_EQ(o.out.find("scene/s.toml:2:8: error: '" + path + "': the path "), 0u) << o.out;
    }
    write("scene/inside.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    write("scene/s.toml", "[shape.a]\nmesh = \"./x/../inside.obj\"\n[[node]]\nshape = \"a\"\n");
    EXPECT_EQ(run({"check", "scene/s.toml"}).out, "scene/s.toml: good\n");
}

TEST_F(Cli, InfoCounts) {
    write("two.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 2 4 3\n");
    write("s.toml",
          "[shape.a]\nmesh = \"two.obj\"\n[shape.b]\nbox = {}\n"
          "[[node]]\nshape = \"a\"\n[[node]]\nshape = \"b\"\n[[node]]\nshape = \"b\"\n");
    const Outcome o = run({"info", "s.toml", "--json", "-"});
    EXPECT_EQ(o.code, 0);
    EXPECT_EQ(o.err, "");
    const Json json = Json::parse(o.out);
    EXPECT_EQ(json["triangles"], 2 + 2 * 12);
    EXPECT_EQ(json["instances"], 3);
    ASSERT_EQ(json["meshes"].size(), 2u);
    EXPECT_EQ(json["meshes"][0]["triangles"], 2);
    EXPECT_EQ(json["meshes"][1]["triangles"], 12);
    const Outcome text = run({"info", "s.toml", "--set", "node.x=1"});
    EXPECT_EQ(text.code, 1) << "a mistake in --set is found in the scene";
    EXPECT_EQ(text.err, "--set node.x=1: error: say which node: node.NAME.x\n");
    EXPECT_NE(run({"info", "s.toml"}).out.find("26 triangles, 3 instances"), std::string::npos);
}

TEST_F(Cli, CompareMeasures) {
    writePicture("a.png", grey(40, 25, 100));
    writePicture("same.png", grey(40, 25, 100));
    ImageRgba8 other = grey(40, 25, 100);
    other.at(7, 9)[1] = 110;  // one channel of one pixel
    writePicture("one.png", other);
    writePicture("wide.png", grey(41, 25, 100));

    const Outcome same = run({"compare", "a.png", "same.png", "--tolerance", "0", "--json", "-"});
    EXPECT_EQ(same.code, 0);
    const Json zero = Json::parse(same.out);
    EXPECT_EQ(zero["pixels_over"], 0);
    EXPECT_TRUE(zero["psnr"].is_null()) << "no number is infinite in JSON";
    EXPECT_EQ(zero["equal"], true);

    const std::vector<std::string> strict{"compare", "a.png", "one.png", "--fraction", "0"};
    const auto with = [&](const std::string& tolerance) {
        std::vector<std::string> arguments = strict;
        arguments.insert(arguments.end(), {"--tolerance", tolerance});
        return run(arguments).code;
    };
    EXPECT_EQ(with("9"), 1) << "the pixel is off by 10";
    EXPECT_EQ(with("10"), 0);
    EXPECT_EQ(run(strict).code, 0) << "without a tolerance it only measures";
    EXPECT_EQ(run({"compare", "a.png", "one.png", "--tolerance", "9", "--fraction", "0.001"}).code,
              0)
        << "one of a thousand pixels";
    EXPECT_EQ(run({"compare", "a.png", "one.png", "--tolerance", "9", "--fraction", "0.0009"}).code,
              1);
    const Json json = Json::parse(run({"compare", "a.png", "one.png", "--json", "-"}).out);
    EXPECT_EQ(json["pixels_over"], 1);
    EXPECT_EQ(json["pixels"], 1000);
    EXPECT_NEAR(json["largest_difference"], 10.0 / 255, 1e-9);
    EXPECT_NEAR(json["rmse"], 10.0 / 255 / std::sqrt(3000.0), 1e-9);
    EXPECT_GT(json["flip"], 0);
}

TEST_F(Cli, CompareWritesAHeatMap) {
    writePicture("a.png", grey(40, 25, 100));
    ImageRgba8 other = grey(40, 25, 100);
    for (int c = 0; c < 3; ++c) other.at(7, 9)[static_cast<size_t>(c)] = 255;
    writePicture("b.png", other);
    EXPECT_EQ(run({"compare", "a.png", "b.png", "-o", "heat.png"}).code, 0);
    const std::string bytes = read("heat.png");
    const ImageRgba8 heat =
        decodePng({reinterpret_cast<const uint8_t*>(bytes.data()), bytes.size()}, "heat.png");
    ASSERT_EQ(heat.width, 40);
    ASSERT_EQ(heat.height, 25);
    EXPECT_GT(heat.at(7, 9)[0], heat.at(30, 20)[0]) << "bright where the pictures differ";
}

TEST_F(Cli, CompareRefusesWhatItCannotCompare) {
    writePicture("a.png", grey(40, 25, 100));
    writePicture("wide.png", grey(41, 25, 100));
    write("cut.png", read("a.png").substr(0, 60));
    const Outcome size = run({"compare", "a.png", "wide.png"});
    EXPECT_EQ(size.code, 1);
    EXPECT_EQ(size.err, "wide.png: error: the picture is 41x25; 'a.png' is 40x25\n");
    EXPECT_EQ(run({"compare", "a.png", "cut.png"}).code, 1);
    EXPECT_EQ(run({"compare", "a.png", "none.png"}).code, 1);
    EXPECT_EQ(run({"compare", "a.png", "a.png", "-o", "no/heat.png"}).code, 3);
}

}  // namespace
}  // namespace vitrine
