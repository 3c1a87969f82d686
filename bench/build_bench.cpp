// SPDX-License-Identifier: MIT
// Times the tree builder against Embree's MEDIUM builder on torus knots of growing size.
//
// Peers: rtcCommitScene (which also makes Embree's wide tree and its triangle blocks) and
// rtcBuildBVH (the builder alone, boxes made beforehand). Runs are interleaved A, B, C, A, B, C,
// ... with the same number of threads, and the ratio is the median over the rounds, so that a slow
// moment of the machine hits all of them.
//
//   build_bench [--json] [--rounds N] [--threads N]... [--triangles N]...
#include <tbb/global_control.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

#include "bvh/build.hpp"
#include "bvh/traverse.hpp"
#include "embree_binary.hpp"
#include "embree_scene.hpp"
#include "torus_knot.hpp"

namespace vitrine {
namespace {

struct Options {
    bool json = false;
    int rounds = 9;
    std::vector<int> threads;
    std::vector<uint32_t> triangles;
};

struct Time {
    double wall;  ///< seconds
    double cpu;   ///< of all threads together
};

template <typename F>
Time timed(F&& work) {
    const auto start = std::chrono::steady_clock::now();
    const std::clock_t cpuStart = std::clock();
    work();
    const std::clock_t cpuEnd = std::clock();
    const auto end = std::chrono::steady_clock::now();
    return {std::chrono::duration<double>(end - start).count(),
            double(cpuEnd - cpuStart) / CLOCKS_PER_SEC};
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const size_t half = values.size() / 2;
    return values.size() % 2 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

struct BuildResult {
    int threads;
    size_t triangles;
    double milliseconds;       ///< of ours, median wall time
    double sceneMilliseconds;  ///< of rtcCommitScene
    double treeMilliseconds;   ///< of rtcBuildBVH
    double sceneRatio;         ///< ours / rtcCommitScene, median over the rounds
    double sceneCpuRatio;
    double treeRatio;
    double sahCost;
};

BuildResult benchBuild(const KnotMesh& mesh, int threads, int rounds) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, size_t(threads));
    EmbreeScene embree(mesh.positions, mesh.triangles, threads);
    const auto primitives = embreePrimitives(mesh.positions, mesh.triangles);

    std::vector<double> ours, scenes, trees, sceneRatios, sceneCpuRatios, treeRatios;
    Bvh bvh;
    for (int round = -1; round < rounds; ++round) {
        const Time a = timed([&] { bvh = buildTriangleBvh(mesh.positions, mesh.triangles); });
        const RTCScene scene = embree.newScene();
        const Time b = timed([&] { embree.commit(scene); });
        auto shuffled = primitives;
        const RTCBVH tree = rtcNewBVH(embree.device());
        const Time c = timed([&] { embreeBuildBinary(tree, shuffled); });
        rtcReleaseBVH(tree);
        if (round < 0) continue;  // the first of each wakes caches and threads
        ours.push_back(a.wall);
        scenes.push_back(b.wall);
        trees.push_back(c.wall);
        sceneRatios.push_back(a.wall / b.wall);
        sceneCpuRatios.push_back(a.cpu / b.cpu);
        treeRatios.push_back(a.wall / c.wall);
    }
    return {threads,
            mesh.triangles.size(),
            1e3 * median(ours),
            1e3 * median(scenes),
            1e3 * median(trees),
            median(sceneRatios),
            median(sceneCpuRatios),
            median(treeRatios),
            measure(bvh).sahCost};
}

/// Slope of ln y over ln x.
double exponent(const std::vector<double>& x, const std::vector<double>& y) {
    double sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (size_t i = 0; i < x.size(); ++i) {
        const double lx = std::log(x[i]);
        const double ly = std::log(y[i]);
        sx += lx, sy += ly, sxx += lx * lx, sxy += lx * ly;
    }
    const auto n = double(x.size());
    return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

struct RayResult {
    double oursMillions;  ///< rays per second, one thread
    double embreeMillions;
    double nodesPerRay;
    double trianglesPerRay;
};

/// Rays between random points around the mesh. For information: the oracle is not tuned.
RayResult benchRays(const KnotMesh& mesh) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> position(-3.5f, 3.5f);
    const auto point = [&] {
        return glm::vec3(position(random), position(random), position(random));
    };
    std::vector<Ray> rays(50000);
    for (Ray& ray : rays) {
        ray.origin = point();
        ray.direction = glm::normalize(point() - ray.origin);
    }
    const Bvh bvh = buildTriangleBvh(mesh.positions, mesh.triangles);
    const EmbreeScene embree(mesh.positions, mesh.triangles, 1);
    TraversalCounters counters;
    const Time ours = timed([&] {
        for (const Ray& ray : rays) closestHit(bvh, mesh.positions, mesh.triangles, ray, &counters);
    });
    std::vector<EmbreeHit> hits(rays.size());
    const Time theirs = timed([&] { embree.closest(rays, hits); });
    const auto count = double(rays.size());
    return {1e-6 * count / ours.wall, 1e-6 * count / theirs.wall, double(counters.nodes) / count,
            double(counters.triangles) / count};
}

nlohmann::json toJson(const BuildResult& r) {
    return {{"threads", r.threads},
            {"triangles", r.triangles},
            {"ms", r.milliseconds},
            {"embree_scene_ms", r.sceneMilliseconds},
            {"embree_tree_ms", r.treeMilliseconds},
            {"ratio_to_scene", r.sceneRatio},
            {"cpu_ratio_to_scene", r.sceneCpuRatio},
            {"ratio_to_tree", r.treeRatio},
            {"sah_cost", r.sahCost}};
}

int run(const Options& options) {
    nlohmann::json report;
    const auto say = [&options](const std::string& line) {
        if (!options.json) std::printf("%s\n", line.c_str());
    };
    std::vector<KnotMesh> meshes;
    for (const uint32_t count : options.triangles) meshes.push_back(makeTorusKnot(count));

    say("threads triangles     ms  commit ms  tree ms  /commit  cpu/commit  /tree     SAH");
    for (const int threads : options.threads) {
        std::vector<double> counts, times;
        for (const KnotMesh& mesh : meshes) {
            const BuildResult r = benchBuild(mesh, threads, options.rounds);
            char line[200];
            std::snprintf(line, sizeof line, "%7d %9zu %6.1f %10.1f %8.1f %8.2f %11.2f %6.2f %7.2f",
                          r.threads, r.triangles, r.milliseconds, r.sceneMilliseconds,
                          r.treeMilliseconds, r.sceneRatio, r.sceneCpuRatio, r.treeRatio,
                          r.sahCost);
            say(line);
            report["build"].push_back(toJson(r));
            counts.push_back(double(r.triangles));
            times.push_back(r.milliseconds);
        }
        if (counts.size() < 2) continue;
        const double slope = exponent(counts, times);
        say("time grows as N^" + std::to_string(slope));
        report["exponents"].push_back({{"threads", threads}, {"exponent", slope}});
    }
    for (const KnotMesh& mesh : meshes) {
        const RayResult r = benchRays(mesh);
        char line[200];
        std::snprintf(line, sizeof line,
                      "%9zu triangles: oracle %.2f Mrays/s, Embree %.2f; %.1f boxes and %.1f "
                      "triangles per ray",
                      mesh.triangles.size(), r.oursMillions, r.embreeMillions, r.nodesPerRay,
                      r.trianglesPerRay);
        say(line);
        report["rays"].push_back({{"triangles", mesh.triangles.size()},
                                  {"mrays_per_second", r.oursMillions},
                                  {"embree_mrays_per_second", r.embreeMillions},
                                  {"boxes_per_ray", r.nodesPerRay},
                                  {"triangles_per_ray", r.trianglesPerRay}});
    }
    if (options.json) std::printf("%s\n", report.dump(2).c_str());
    return 0;
}

}  // namespace
}  // namespace vitrine

int main(int argc, char** argv) {
    vitrine::Options options;
    for (int i = 1; i < argc; ++i) {
        const std::string argument = argv[i];
        const bool valued = i + 1 < argc;
        if (argument == "--json") {
            options.json = true;
        } else if (argument == "--rounds" && valued) {
            options.rounds = std::max(1, std::atoi(argv[++i]));
        } else if (argument == "--threads" && valued) {
            options.threads.push_back(std::max(1, std::atoi(argv[++i])));
        } else if (argument == "--triangles" && valued) {
            options.triangles.push_back(uint32_t(std::max(64, std::atoi(argv[++i]))));
        } else {
            std::fprintf(stderr,
                         "usage: build_bench [--json] [--rounds N] [--threads N]... "
                         "[--triangles N]...\n");
            return 2;
        }
    }
    if (options.threads.empty()) options.threads = {1, 2};
    if (options.triangles.empty()) options.triangles = {20000, 70000, 200000, 1000000};
    return vitrine::run(options);
}
