// SPDX-License-Identifier: MIT
// The command line. Exit codes: 0 good; 1 the input is at fault; 2 the command line is; 3 the
// machine is.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <functional>
#include <tuple>

#include "app/cli/commands.hpp"
#include "app/cli/frames.hpp"
#include "app/viewer/viewer.hpp"
#include "pack/tree_level.hpp"

namespace vitrine {
namespace {

constexpr int kInputFault = 1, kUsageFault = 2, kMachineFault = 3;

/// A range lets "nan" through, because it is neither too small nor too large.
const CLI::Validator kFinite{
    [](const std::string& text) {
        double value = 0;
        const bool good = CLI::detail::lexical_cast(text, value) && std::isfinite(value);
        return good ? std::string() : "'" + text + "' is not a finite number";
    },
    ""};

void addOverrides(CLI::App& command, std::vector<std::string>& overrides) {
    command.add_option("--set", overrides, "change a key of the scene: render.exposure=1")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
}

void defineRender(CLI::App& app, RenderOptions& o, std::function<int()>& chosen) {
    CLI::App* c = app.add_subcommand("render", "draw a scene into a picture");
    c->add_option("FILE", o.file,
                  "a scene (.toml), a model (.gltf, .glb, .obj) or a field (.sdf.glsl)")
        ->required();
    c->add_option("-o,--output", o.output,
                  "name.png, or name.exr with layers; with --frames name_####.png, or a film: "
                  "name.mp4, .webm or .gif")
        ->required();
    c->add_option("-r,--resolution", o.resolution, "width x height")->capture_default_str();
    c->add_option("--spp", o.samples, "samples a pixel")->check(CLI::Range(1, 65536));
    c->add_option("--time", o.time, "seconds")->check(CLI::Range(-1e6, 1e6))->check(kFinite);
    c->add_option("--frames", o.frames, "A-B or A-B:STEP: a picture each");
    c->add_option("--fps", o.fps, "frames a second")
        ->check(CLI::Range(0.001, 10000.0))
        ->check(kFinite)
        ->capture_default_str();
    c->add_option("--camera", o.camera, "the camera of this name");
    c->add_option("--view", o.view,
                  fmt::format("what to show: {}=LEVEL", fmt::join(viewNames(), " ")))
        ->capture_default_str();
    c->add_option("--mode", o.mode, "hybrid is quick; reference follows all light there is")
        ->check(CLI::IsMember({"hybrid", "reference"}))
        ->capture_default_str();
    c->add_option("--backend", o.backend, "fragment or compute shaders")
        ->check(CLI::IsMember({"auto", "fragment", "compute"}))
        ->capture_default_str();
    c->add_option("--primary", o.primary, "who finds what the camera sees")
        ->check(CLI::IsMember({"raster", "trace"}))
        ->capture_default_str();
    c->add_option("--seed", o.seed, "start of the random numbers")
        ->check(CLI::Range(0, 2147483647));
    c->add_option("--json", o.json, "write numbers about the rendering to this file, or - ");
    addOverrides(*c, o.overrides);
    o.version = VITRINE_VERSION;
    c->callback([&] { chosen = [&] { return render(o); }; });
}

void defineCheck(CLI::App& app, CheckOptions& o, std::function<int()>& chosen) {
    CLI::App* c = app.add_subcommand("check", "report all errors and warnings of a scene");
    c->add_option("FILE", o.file)->required();
    c->add_option("--json", o.json, "write them as JSON to this file, or - ");
    c->add_option("-o,--output", o.output, "draw a field, cut through, into this picture");
    addOverrides(*c, o.overrides);
    c->callback([&] { chosen = [&] { return check(o); }; });
}

void defineInfo(CLI::App& app, InfoOptions& o, std::function<int()>& chosen) {
    CLI::App* c = app.add_subcommand("info", "show what is in a scene");
    c->add_option("FILE", o.file)->required();
    c->add_option("--json", o.json, "write it as JSON to this file, or - ");
    c->add_flag("--builders", o.builders, "compare the trees that all builders make");
    CLI::Option* boxes = c->add_option("--export-bvh", o.exportBoxes,
                                       "write the boxes of a level of the trees to this .obj");
    c->add_option("--level", o.level, "the level for --export-bvh")
        ->check(CLI::Range(0, kMaxTreeLevel))
        ->needs(boxes)
        ->capture_default_str();
    addOverrides(*c, o.overrides);
    c->callback([&] { chosen = [&] { return info(o); }; });
}

void defineView(CLI::App& app, ViewOptions& o, std::function<int()>& chosen) {
    CLI::App* c = app.add_subcommand("view", "open a window on a scene");
    c->add_option("FILE", o.file,
                  "a scene (.toml), a model (.gltf, .glb, .obj) or a field (.sdf.glsl)")
        ->required();
    c->add_option("--camera", o.camera, "the camera of this name");
    c->add_option_function<std::string>(
         "-r,--resolution",
         [&](const std::string& text) { std::tie(o.width, o.height) = parseResolution(text); },
         "the window's width x height, with the panel")
        ->default_str("1280x800");
    c->add_option("--timings", o.timings,
                  "write at the end how long the window took to answer, - to standard output");
    addOverrides(*c, o.overrides);
    o.scenes = VITRINE_SCENES;
    o.version = VITRINE_VERSION;
    c->callback([&] { chosen = [&] { return view(o); }; });
}

void defineCompare(CLI::App& app, CompareOptions& o, std::function<int()>& chosen) {
    CLI::App* c = app.add_subcommand("compare", "measure how two pictures differ");
    c->add_option("A", o.a)->required();
    c->add_option("B", o.b)->required();
    c->add_option("--tolerance", o.tolerance,
                  "exit with 1 if too many pixels differ by more than this, in steps of 1/255")
        ->check(CLI::Range(0.0, 255.0))
        ->check(kFinite);
    c->add_option("--fraction", o.fraction, "how many pixels are too many, as a part of all")
        ->check(CLI::Range(0.0, 1.0))
        ->check(kFinite)
        ->capture_default_str();
    c->add_option("-o,--output", o.output, "write a heat map of the difference (FLIP)");
    c->add_option("--json", o.json, "write the numbers to this file, or - ");
    c->callback([&] { chosen = [&] { return compare(o); }; });
}

/// `vitrine` alone: the start screen, and behind it the best scene there is; without a display, its
/// picture in a file.
int show(const std::string& version) {
    const std::string file = VITRINE_SCENES "/lesson-both.toml";
    try {
        ViewOptions window;
        window.file = file;
        window.scenes = VITRINE_SCENES;
        window.version = version;
        window.startPage = true;
        return view(window);
    } catch (const NoDisplay& error) {
        fmt::print(stderr, "vitrine: {}; drawing a picture instead\n", error.what());
    }
    RenderOptions o;
    o.file = file;
    o.output = "lesson-both.png";
    o.samples = 16;
    o.version = version;
    const int code = render(o);
    fmt::print("wrote {}; try `vitrine --help`\n", o.output);
    return code;
}

int run(int argc, char** argv) {
    CLI::App app{"Vitrine: meshes and distance fields in one scene, and every ray sees both",
                 "vitrine"};
    app.set_version_flag("--version", "vitrine " VITRINE_VERSION);
    app.require_subcommand(0, 1);
    std::function<int()> chosen = [] { return show(VITRINE_VERSION); };
    RenderOptions renderOptions;
    CheckOptions checkOptions;
    InfoOptions infoOptions;
    CompareOptions compareOptions;
    ViewOptions viewOptions;
    defineView(app, viewOptions, chosen);
    defineRender(app, renderOptions, chosen);
    defineCheck(app, checkOptions, chosen);
    defineInfo(app, infoOptions, chosen);
    defineCompare(app, compareOptions, chosen);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : kUsageFault;
    }
    const int code = chosen();
    if (std::fflush(stdout) != 0) throw MachineError("cannot write to standard output");
    return code;
}

}  // namespace
}  // namespace vitrine

int main(int argc, char** argv) {
    using namespace vitrine;
    try {
        return run(argc, argv);
    } catch (const InputError& error) {
        fmt::print(stderr, "{}\n", error.what());
        return kInputFault;
    } catch (const UsageError& error) {
        fmt::print(stderr, "vitrine: {}\n", error.what());
        return kUsageFault;
    } catch (const MachineError& error) {
        fmt::print(stderr, "vitrine: {}\n", error.what());
        return kMachineFault;
    } catch (const std::bad_alloc&) {
        fmt::print(stderr, "vitrine: out of memory\n");
        return kMachineFault;
    } catch (const std::exception& error) {
        fmt::print(stderr, "vitrine: internal error, please report it: {}\n", error.what());
        return kMachineFault;
    }
}
