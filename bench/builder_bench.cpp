// SPDX-License-Identifier: MIT
// The three builders against Embree's three qualities, on the tank and on the torus knot: cost by
// the surface area heuristic, what rays visit, and build time; then whether the shaders' tracer
// gains.
//
// Embree's trees come from rtcBuildBVH with our leaf size and are walked by our traversal, so that
// visits compare trees and nothing else. Times are processor time on one thread, in rounds of all
// candidates, against rtcCommitScene at MEDIUM quality of the same round; the ratio is the median
// over the rounds. The tracer's times alternate in the same way, against the binned tree.
//
//   builder_bench [--json FILE] [--rounds N] [--no-gl]
#include <tbb/global_control.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

#include "base/file.hpp"
#include "bvh/build.hpp"
#include "bvh/traverse.hpp"
#include "embree_binary.hpp"
#include "embree_scene.hpp"
#include "frame/pass_query.hpp"
#include "mesh/obj.hpp"
#include "mesh_scene.hpp"
#include "torus_knot.hpp"

namespace vitrine {
namespace {

constexpr int kSide = 192;  // camera rays a side

struct Model {
    std::string name;
    std::vector<glm::vec3> positions;
    std::vector<glm::uvec3> triangles;
    glm::vec3 eye, target, light;
};

Model knot() {
    KnotMesh mesh = makeTorusKnot(70000);
    return {"torus knot",
            std::move(mesh.positions),
            std::move(mesh.triangles),
            {1.5f, -2, 8},
            {0, 0, 0},
            {6, 5, 7}};
}

/// All four meshes as one; the turret stands where the scene puts it.
Model tank() {
    Model model{"tank", {}, {}, {10.4f, 2.3f, 7.6f}, {0.5f, 1.2f, 0}, {4, 9, 10}};
    const std::pair<const char*, glm::vec3> parts[] = {{"chassis", {0, 0, 0}},
                                                       {"hull", {0, 0, 0}},
                                                       {"turret", {0.15f, 1.62f, 0}},
                                                       {"gun", {1.15f, 2.01f, 0}}};
    for (const auto& [part, at] : parts) {
        const std::string file = std::string(VITRINE_ROOT "/scenes/models/tank/") + part + ".obj";
        Diagnostics diagnostics;
        const auto mesh = readObj(readFile(file, kMaxObjBytes), file, diagnostics);
        diagnostics.throwIfErrors();
        const auto first = uint32_t(model.positions.size());
        for (const glm::vec3& p : mesh->positions) model.positions.push_back(p + at);
        for (const glm::uvec3& t : mesh->triangles) model.triangles.push_back(t + first);
    }
    return model;
}

struct RayClass {
    std::string name;
    bool any;
    std::vector<Ray> rays;
};

std::vector<RayClass> rayClasses(const Model& m) {
    const Bvh bvh = buildTriangleBvh(m.positions, m.triangles);
    std::vector<RayClass> classes{
        {"primary", false, {}}, {"shadow", true, {}}, {"diffuse", false, {}}};
    std::mt19937 random(1);
    std::normal_distribution<float> normal;
    const glm::vec3 forward = glm::normalize(m.target - m.eye);
    const glm::vec3 right = glm::normalize(glm::cross(forward, {0, 1, 0}));
    const glm::vec3 up = glm::cross(right, forward);
    for (int i = 0; i < kSide * kSide; ++i) {
        const float u = (float(i % kSide) + 0.5f) / kSide - 0.5f;
        const float v = (float(i / kSide) + 0.5f) / kSide - 0.5f;
        const glm::vec3 d = glm::normalize(forward + 0.8f * (u * right + v * up));
        classes[0].rays.push_back({m.eye, d});
        const auto hit = closestHit(bvh, m.positions, m.triangles, {m.eye, d});
        if (!hit) continue;
        const glm::uvec3 t = m.triangles[hit->triangle];
        const glm::vec3 a = m.positions[t.x];
        glm::vec3 n = glm::normalize(glm::cross(m.positions[t.y] - a, m.positions[t.z] - a));
        if (glm::dot(n, d) > 0) n = -n;
        const glm::vec3 p = m.eye + hit->t * d + 1e-4f * n;
        const glm::vec3 toLight = m.light - p;
        classes[1].rays.push_back({p, glm::normalize(toLight), 0, glm::length(toLight)});
        const glm::vec3 sphere(normal(random), normal(random), normal(random));
        classes[2].rays.push_back({p, glm::normalize(n + 0.999f * glm::normalize(sphere))});
    }
    return classes;
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const size_t half = values.size() / 2;
    return values.size() % 2 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

double processorSeconds(const std::function<void()>& work) {
    const std::clock_t start = std::clock();
    work();
    return double(std::clock() - start) / CLOCKS_PER_SEC;
}

/// A tree, and a way to build it that is timed.
struct Candidate {
    std::string name;
    Bvh bvh;
    std::function<void()> build;
    std::vector<double> seconds;
};

Bvh embreeTree(const Model& m, RTCDevice device, RTCBuildQuality quality) {
    std::vector<RTCBuildPrimitive> primitives = embreePrimitives(m.positions, m.triangles);
    EmbreeMesh mesh{m.positions, m.triangles};
    RTCBVH tree = rtcNewBVH(device);
    void* root = embreeBuildBinary(tree, primitives, quality, &mesh);
    Aabb box;
    for (const glm::uvec3& t : m.triangles)
        for (int c = 0; c < 3; ++c) box.grow(m.positions[t[c]]);
    Bvh result;
    result.nodes.resize(1);
    convertEmbree(root, box, 0, result);
    rtcReleaseBVH(tree);
    return result;
}

std::vector<Candidate> candidatesOf(const Model& m, EmbreeScene& embree) {
    std::vector<Candidate> list;
    for (const auto& [name, method] : {std::pair{"nine", BuildMethod::kNine},
                                       {"binned", BuildMethod::kBinned},
                                       {"spatial", BuildMethod::kSpatial}}) {
        BuildOptions options;
        options.method = method;
        list.push_back({name,
                        buildTriangleBvh(m.positions, m.triangles, options),
                        [&m, options] { buildTriangleBvh(m.positions, m.triangles, options); },
                        {}});
    }
    for (const auto& [name, quality] : {std::pair{"Embree LOW", RTC_BUILD_QUALITY_LOW},
                                        {"Embree MEDIUM", RTC_BUILD_QUALITY_MEDIUM},
                                        {"Embree HIGH", RTC_BUILD_QUALITY_HIGH}})
        list.push_back({name,
                        embreeTree(m, embree.device(), quality),
                        [&embree, q = quality] { embree.commit(embree.newScene(q)); },
                        {}});
    return list;
}

nlohmann::json benchTrees(const Model& m, const std::vector<RayClass>& classes, int rounds) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
    EmbreeScene embree(m.positions, m.triangles, 1);
    std::vector<Candidate> list = candidatesOf(m, embree);
    for (int round = -1; round < rounds; ++round)
        for (Candidate& c : list) {
            const double seconds = processorSeconds(c.build);
            if (round >= 0) c.seconds.push_back(seconds);
        }
    const Candidate& peer = list[4];
    std::printf(
        "\n%s, %zu triangles; visits a ray are boxes tested + triangles tested\n%-14s %8s "
        "%8s %6s %6s %14s %14s %14s %9s %10s\n",
        m.name.c_str(), m.triangles.size(), "builder", "SAH", "nodes", "depth", "refs", "primary",
        "shadow", "diffuse", "build ms", "/ MEDIUM");
    nlohmann::json rows = nlohmann::json::array();
    for (const Candidate& c : list) {
        const BvhStatistics s = measure(c.bvh);
        std::vector<double> ratios;
        for (size_t i = 0; i < c.seconds.size(); ++i)
            ratios.push_back(c.seconds[i] / peer.seconds[i]);
        const double refs = double(s.references) / double(m.triangles.size());
        nlohmann::json row{{"model", m.name},
                           {"builder", c.name},
                           {"sah_cost", s.sahCost},
                           {"nodes", s.nodes},
                           {"depth", s.depth},
                           {"references_per_triangle", refs},
                           {"build_ms", 1e3 * median(c.seconds)},
                           {"build_over_embree_medium", median(ratios)}};
        std::printf("%-14s %8.2f %8zu %6d %6.3f", c.name.c_str(), s.sahCost, s.nodes, s.depth,
                    refs);
        for (const RayClass& rays : classes) {
            TraversalCounters counters;
            for (const Ray& ray : rays.rays)
                if (rays.any)
                    anyHit(c.bvh, m.positions, m.triangles, ray, &counters);
                else
                    closestHit(c.bvh, m.positions, m.triangles, ray, &counters);
            const auto count = double(rays.rays.size());
            const double boxes = double(counters.nodes) / count;
            const double triangles = double(counters.triangles) / count;
            std::printf(" %7.1f + %4.1f", boxes, triangles);
            row[rays.name] = {{"boxes", boxes}, {"triangles", triangles}};
        }
        std::printf(" %9.1f %10.2f\n", 1e3 * median(c.seconds), median(ratios));
        rows.push_back(row);
    }
    return rows;
}

nlohmann::json benchTracer(const Context& context, const Model& m,
                           const std::vector<RayClass>& classes, int rounds) {
    constexpr std::array kMethods{BuildMethod::kBinned, BuildMethod::kNine, BuildMethod::kSpatial};
    constexpr std::array kNames{"binned", "nine", "spatial"};
    std::printf("\n%s, shaders' tracer: nodes and triangles a ray, time against binned\n",
                m.name.c_str());
    nlohmann::json rows = nlohmann::json::array();
    std::vector<PackedScene> scenes;
    for (const BuildMethod method : kMethods)
        scenes.push_back(packTree(m.positions, m.triangles,
                                  buildTriangleBvh(m.positions, m.triangles, {.method = method})));
    for (const RayClass& c : classes) {
        std::vector<QueryRay> rays;
        for (const Ray& r : c.rays) rays.push_back({r.origin, 0, r.direction, r.tMax});
        std::array<double, 3> nodes{};
        std::vector<std::unique_ptr<RayQuery>> queries;
        for (size_t i = 0; i < scenes.size(); ++i) {
            RayQuery counting(context, scenes[i], Backend::kFragment, true);
            counting.prepare(rays);
            counting.repeat(c.any);
            nodes[i] = double(counting.counts().nodes) / double(rays.size());
            queries.push_back(std::make_unique<RayQuery>(context, scenes[i], Backend::kFragment));
            queries.back()->prepare(rays);
        }
        std::array<std::vector<double>, 3> seconds;
        for (int round = -1; round < rounds; ++round)
            for (size_t i = 0; i < queries.size(); ++i) {
                const double s = processorSeconds([&] { queries[i]->repeat(c.any); });
                if (round >= 0) seconds[i].push_back(s);
            }
        std::printf("%-9s", c.name.c_str());
        for (size_t i = 0; i < queries.size(); ++i) {
            std::vector<double> ratios;
            for (size_t k = 0; k < seconds[i].size(); ++k)
                ratios.push_back(seconds[i][k] / seconds[0][k]);
            std::printf("   %s %5.1f, x%.3f", kNames[i], nodes[i], median(ratios));
            rows.push_back({{"model", m.name},
                            {"rays", c.name},
                            {"builder", kNames[i]},
                            {"visits_per_ray", nodes[i]},
                            {"milliseconds", 1e3 * median(seconds[i])},
                            {"time_over_binned", median(ratios)}});
        }
        std::printf("\n");
    }
    return rows;
}

int run(const std::string& json, int rounds, bool gl) {
    setenv("LP_NUM_THREADS", "1", 1);  // read by llvmpipe when it makes its first context
    nlohmann::json report;
    const auto context = gl ? Context::createHeadless() : nullptr;
    for (const Model& m : {tank(), knot()}) {
        const std::vector<RayClass> classes = rayClasses(m);
        report["trees"].push_back(benchTrees(m, classes, rounds));
        if (gl) report["tracer"].push_back(benchTracer(*context, m, classes, rounds));
    }
    if (!json.empty()) writeFileAtomically(json, report.dump(2) + "\n");
    return 0;
}

}  // namespace
}  // namespace vitrine

int main(int argc, char** argv) {
    std::string json;
    int rounds = 9;
    bool gl = true;
    for (int i = 1; i < argc; ++i) {
        const std::string argument = argv[i];
        const bool valued = i + 1 < argc;
        if (argument == "--json" && valued) {
            json = argv[++i];
        } else if (argument == "--rounds" && valued) {
            rounds = std::max(1, std::atoi(argv[++i]));
        } else if (argument == "--no-gl") {
            gl = false;
        } else {
            std::fprintf(stderr, "usage: builder_bench [--json FILE] [--rounds N] [--no-gl]\n");
            return 2;
        }
    }
    try {
        return vitrine::run(json, rounds, gl);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "builder_bench: %s\n", error.what());
        return 1;
    }
}
