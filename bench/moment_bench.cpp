// SPDX-License-Identifier: MIT
// moment_bench [SCENE]: what a frame costs in which things move, without drawing it: the pose, and
// the packing of what moves (most of it the tree over the instances). Against packing everything,
// one after the other in every round; the medians are printed.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <functional>

#include "mesh/primitives.hpp"
#include "pack/pack_scene.hpp"
#include "scene/parse.hpp"
#include "scene/pose.hpp"

namespace vitrine {
namespace {

double secondsOf(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// Boxes on a lattice, each turning by an animation of its own.
Scene turningBoxes(int count) {
    std::string text = "[shape.box]\nbox = { size = 0.5 }\n";
    for (int i = 0; i < count; ++i)
        text += fmt::format("[[node]]\nname='n{}'\nshape='box'\nat=[{},{},{}]\n", i, i % 20,
                            i / 20 % 20, i / 400);
    Diagnostics diagnostics;
    Scene scene = parseScene(text, "boxes", {}, diagnostics);
    diagnostics.throwIfErrors();
    for (size_t i = 0; i < scene.nodes.size(); ++i) {
        AnimationTrack track;
        track.target = {AnimationTarget::Object::kNode, i, "rotate"};
        track.times = {0, 3};
        track.values = {glm::vec4(0), glm::vec4(90, 200, 10, 0)};
        scene.animations.push_back(std::move(track));
    }
    return scene;
}

void measure(const std::string& name, const Scene& scene) {
    Diagnostics diagnostics;
    const Assets assets = loadAssets(scene, diagnostics);
    const PackedScene rest = packScene(scene, assets, diagnostics);
    diagnostics.throwIfErrors();
    std::vector<double> pose, moment, all;
    for (int round = 0; round < 15; ++round) {
        Scene posed;
        pose.push_back(secondsOf([&] { posed = poseScene(scene, 0.1 * round); }));
        moment.push_back(secondsOf([&] { (void)packMoment(posed, assets, rest, diagnostics); }));
        all.push_back(secondsOf([&] { (void)packScene(posed, assets, diagnostics); }));
    }
    fmt::print("{:<24} {:>9} {:>9} {:>9.3f} {:>9.3f} {:>9.3f} {:>9.0f}\n", name,
               rest.instances.size(), scene.animations.size(), 1e3 * median(pose),
               1e3 * median(moment), 1e3 * median(all), median(all) / median(moment));
}

}  // namespace
}  // namespace vitrine

int main(int argc, char** argv) try {
    using namespace vitrine;
    fmt::print("{:<24} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9}\n", "scene", "instances", "tracks",
               "pose ms", "pack ms", "all ms", "ratio");
    if (argc == 2) {
        Diagnostics diagnostics;
        const Scene scene = loadScene(argv[1], {}, diagnostics);
        diagnostics.throwIfErrors();
        measure(argv[1], scene);
    }
    for (const int count : {100, 1000, 10000}) measure("boxes", turningBoxes(count));
    return 0;
} catch (const std::exception& problem) {
    fmt::print(stderr, "moment_bench: {}\n", problem.what());
    return 1;
}
