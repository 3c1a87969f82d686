// SPDX-License-Identifier: MIT
// What many distance fields cost. Instances of two snippets (a ball, a rounded box) are scattered
// in a cube, the more the smaller, so that they cover about the same part of the picture; camera
// rays, a sun's shadow rays and one mirror bounce. Against it: one snippet that is the union of as
// many primitives, written out. Then the same number of instances of more and more different
// snippets.
//
// The time is that of the processor on a software driver, with one thread (LP_NUM_THREADS=1), else
// wall time; runs alternate, medians count.
//
// With --first-hits only the finders of first hits are compared.
//
//   field_bench [--runs N] [--most N] [--first-hits]
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "first_hits.hpp"
#include "frame/frame.hpp"

namespace vitrine {
namespace {

constexpr int kWidth = 240, kHeight = 150;

std::shared_ptr<const Snippet> parse(const std::string& text) {
    Diagnostics diagnostics;
    auto snippet = parseSnippet(text, "bench.sdf.glsl", SnippetKind::kField, diagnostics);
    diagnostics.throwIfErrors();
    return std::make_shared<const Snippet>(std::move(*snippet));
}

struct Placed {
    glm::vec3 at;
    float size;
    bool box;
};

/// Radii such that the sum of all cross sections stays the same.
std::vector<Placed> scatter(int count) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> unit(-1, 1);
    const float size = 1.0f / std::sqrt(static_cast<float>(count));
    std::vector<Placed> placed;
    for (int i = 0; i < count; ++i) {
        const float x = unit(random), y = unit(random), z = unit(random);
        placed.push_back({{x, y, z}, size, i % 2 == 1});
    }
    return placed;
}

constexpr const char* kBall =
    "// bounds[-1, -1, -1,  1, 1, 1]\nfloat sdf(vec3 p) { return length(p) - 1.0; }\n";
constexpr const char* kBox =
    "// bounds[-0.8, -0.8, -0.8,  0.8, 0.8, 0.8]\n"
    "float sdf(vec3 p) {\n"
    "    vec3 q = abs(p) - 0.6;\n"
    "    return length(max(q, 0.0)) + min(max(q.x, max(q.y, q.z)), 0.0) - 0.2;\n"
    "}\n";

/// A box of its own: the number makes it a snippet like no other.
std::string boxOfItsOwn(int number) {
    return fmt::format(
        "// bounds[-0.85, -0.85, -0.85,  0.85, 0.85, 0.85]\n"
        "float sdf(vec3 p) {{\n"
        "    vec3 q = abs(p) - vec3(0.6, {:.3f}, 0.6);\n"
        "    float bumps = 0.01 * sin({:.1f} * p.x) * sin(11.0 * p.y) * sin(13.0 * p.z);\n"
        "    return 0.8 * (length(max(q, 0.0)) + min(max(q.x, max(q.y, q.z)), 0.0) - 0.2 + "
        "bumps);\n"
        "}}\n",
        0.6 - 0.005 * number, 10.0 + number);
}

struct FieldScene {
    Scene scene;
    Assets assets;

    FieldScene() {
        scene.file = "bench";
        scene.render.ao = 0;
        Material& mirror = scene.materials.emplace_back();
        mirror.name = "mirror";
        mirror.metallic = 1;
        mirror.roughness = 0;
        assets.materials.emplace_back();
        assets.pictures.emplace_back(VITRINE_SLOT_COUNT);
        scene.lights.emplace_back();
    }
    void addShape(std::shared_ptr<const Snippet> field) {
        scene.shapes.emplace_back().name = fmt::format("shape{}", scene.shapes.size() - 1);
        assets.meshes.emplace_back();
        assets.fields.push_back(std::move(field));
    }
    void addNode(size_t shape, const glm::vec3& at, float size) {
        Node& node = scene.nodes.emplace_back();
        node.name = fmt::format("node{}", scene.nodes.size() - 1);
        node.shape.name = scene.shapes[shape].name;
        node.material.name = "mirror";
        node.at = at;
        node.scale = glm::vec3(size);
    }
    [[nodiscard]] PackedScene pack() const {
        Diagnostics diagnostics;
        PackedScene packed = packScene(scene, assets, diagnostics);
        diagnostics.throwIfErrors();
        return packed;
    }
};

/// `size`: of each, instead of such that the sum of all cross sections stays the same.
FieldScene instances(int count, float size = 0) {
    FieldScene s;
    s.addShape(parse(kBall));
    s.addShape(parse(kBox));
    for (const Placed& p : scatter(count)) s.addNode(p.box ? 1 : 0, p.at, size > 0 ? size : p.size);
    return s;
}

FieldScene bruteForce(int count) {
    std::string text =
        "// bounds[-2, -2, -2,  2, 2, 2]\n"
        "float ball(vec3 p, float s) { return length(p) - s; }\n"
        "float box(vec3 p, float s) {\n"
        "    vec3 q = abs(p) - 0.6 * s;\n"
        "    return length(max(q, 0.0)) + min(max(q.x, max(q.y, q.z)), 0.0) - 0.2 * s;\n"
        "}\n"
        "float sdf(vec3 p) {\n    float d = 1e9;\n";
    for (const Placed& p : scatter(count))
        text += fmt::format("d=min(d,{}(p-vec3({:.4f},{:.4f},{:.4f}),{:.4f}));\n",
                            p.box ? "box" : "ball", p.at.x, p.at.y, p.at.z, p.size);
    FieldScene s;
    s.addShape(parse(text + "    return d;\n}\n"));
    s.addNode(0, glm::vec3(0), 1);
    return s;
}

FieldScene different(int snippets, int count, float size = 0) {
    FieldScene s;
    for (int i = 0; i < snippets; ++i) s.addShape(parse(boxOfItsOwn(i)));
    const std::vector<Placed> placed = scatter(count);
    for (size_t i = 0; i < placed.size(); ++i)
        s.addNode(i % static_cast<size_t>(snippets), placed[i].at,
                  size > 0 ? size : placed[i].size);
    return s;
}

struct Cost {
    double seconds = 0, compile = 0;
    double evaluations = 0, nodes = 0;  // a ray
};

FrameRequest request() {
    FrameRequest r;
    r.width = kWidth;
    r.height = kHeight;
    r.camera.eye = {1.5f, 2, 3.6f};
    r.camera.target = {0, 0, 0};
    r.camera.fov = 38;
    r.bounces = 1;
    r.primary = Primary::kTrace;
    return r;
}

Cost measure(const Context& context, const FieldScene& scene, int runs) {
    const bool software = context.info().software;
    const auto secondsOf = [&](const std::function<void()>& work) {
        const auto start = std::chrono::steady_clock::now();
        const std::clock_t cpu = std::clock();
        work();
        if (software) return static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC;
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    const PackedScene packed = scene.pack();
    Cost cost;
    {
        Frame counting(context, packed, Backend::kAuto, true);
        counting.begin(request());
        counting.drawSample();
        const FrameStatistics s = counting.statistics();
        const auto rays = static_cast<double>(s.primaryRays + s.shadowRays + s.bounceRays);
        cost.evaluations = static_cast<double>(s.steps) / rays;
        cost.nodes = static_cast<double>(s.nodes) / rays;
    }
    Frame frame(context, packed, Backend::kAuto, false);
    const auto draw = [&] {
        frame.begin(request());
        frame.drawSample();
        finishGpu();
    };
    const double first = secondsOf(draw);
    std::vector<double> seconds;
    for (int i = 0; i < runs; ++i) seconds.push_back(secondsOf(draw));
    std::sort(seconds.begin(), seconds.end());
    cost.seconds = seconds[seconds.size() / 2];
    cost.compile = first - cost.seconds;
    return cost;
}

/// Slope of ln y over ln x by least squares.
double exponent(const std::vector<double>& x, const std::vector<double>& y) {
    double sx = 0, sy = 0, sxx = 0, sxy = 0;
    const auto n = static_cast<double>(x.size());
    for (size_t i = 0; i < x.size(); ++i) {
        const double a = std::log(x[i]), b = std::log(y[i]);
        sx += a;
        sy += b;
        sxx += a * a;
        sxy += a * b;
    }
    return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

void print(int count, const char* what, const Cost& c) {
    fmt::print("{:6} {:<22} {:8.1f} {:10.1f} {:8.1f} {:10.0f}\n", count, what, 1e3 * c.seconds,
               c.evaluations, c.nodes, 1e3 * c.compile);
    std::fflush(stdout);
}

void printFirstHits(const Context& context, int count, const std::string& what,
                    const FieldScene& scene, int runs) {
    FirstHits finders(context, scene.pack(), request().camera, 2 * kWidth, 2 * kHeight);
    const FirstHits::Result r = finders.compare(runs);
    fmt::print("{:6} {:<18} {:7.2f} {:8.1f} {:8.1f} {:6.2f} {:8.1f} {:6.2f} {:9.0f} {:9.0f}\n",
               count, what, finders.cover(), 1e3 * r.boxes, 1e3 * r.tree, r.treeRatio,
               1e3 * r.trace, r.traceRatio, 1e3 * r.boxesFirst, 1e3 * r.treeFirst);
    std::fflush(stdout);
}

/// Who finds the first hits: the boxes of the fields, the tree over them, or the tracer.
void runFirstHits(int runs, int most) {
    setenv("LP_NUM_THREADS", "1", 1);
    setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
    const auto context = Context::createHeadless();
    fmt::print("{}, {} x {}, ms\n{:>6} {:<18} {:>7} {:>8} {:>8} {:>6} {:>8} {:>6} {:>9} {:>9}\n",
               context->info().renderer, 2 * kWidth, 2 * kHeight, "N", "", "cover", "boxes", "tree",
               "ratio", "trace", "ratio", "1st boxes", "1st tree");
    for (int count = 8; count <= most; count *= 8)
        printFirstHits(*context, count, "instances", instances(count), runs);
    for (const int count : {8, 64, 512})
        for (const float size : {0.1f, 0.2f, 0.4f})
            printFirstHits(*context, count, fmt::format("of size {}", size), instances(count, size),
                           runs);
    for (const int snippets : {1, 2, 4, 8, 16})
        for (const float size : {0.0f, 0.35f, 0.5f})
            printFirstHits(*context, 64, fmt::format("{} snippets, {}", snippets, size),
                           different(snippets, 64, size), runs);
}

void run(int runs, int most) {
    setenv("LP_NUM_THREADS", "1", 1);  // read by llvmpipe when it makes its first context
    setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
    const auto context = Context::createHeadless();
    fmt::print("{}, {} x {}\n{:>6} {:<22} {:>8} {:>10} {:>8} {:>10}\n", context->info().renderer,
               kWidth, kHeight, "N", "", "ms", "evals/ray", "nodes", "compile");
    std::vector<double> counts, ours, bruteCounts, brute;
    for (int count = 8; count <= most; count *= 8) {
        const Cost c = measure(*context, instances(count), runs);
        print(count, "instances", c);
        counts.push_back(count);
        ours.push_back(c.seconds);
        if (count > 512) continue;
        const Cost b = measure(*context, bruteForce(count), runs);
        print(count, "one snippet of all", b);
        bruteCounts.push_back(count);
        brute.push_back(b.seconds);
    }
    fmt::print("exponent: instances {:.2f}, one snippet of all {:.2f}\n\n", exponent(counts, ours),
               exponent(bruteCounts, brute));
    std::vector<double> kinds, seconds;
    for (const int snippets : {1, 2, 4, 8, 16}) {
        const Cost c = measure(*context, different(snippets, 64), runs);
        print(64, fmt::format("of {} snippets", snippets).c_str(), c);
        kinds.push_back(snippets);
        seconds.push_back(c.seconds);
    }
    fmt::print("exponent over the snippets: {:.2f}\n", exponent(kinds, seconds));
}

}  // namespace
}  // namespace vitrine

int main(int argc, char** argv) {
    int runs = 5, most = 4096;
    bool firstHits = false;
    for (int i = 1; i < argc; ++i) {
        const std::string argument = argv[i];
        const bool valued = i + 1 < argc;
        firstHits |= argument == "--first-hits";
        if (argument == "--runs" && valued) runs = std::max(1, std::atoi(argv[++i]));
        if (argument == "--most" && valued) most = std::max(8, std::atoi(argv[++i]));
    }
    try {
        firstHits ? vitrine::runFirstHits(runs, most) : vitrine::run(runs, most);
        return 0;
    } catch (const std::exception& error) {
        fmt::print(stderr, "field_bench: {}\n", error.what());
        return 1;
    }
}
