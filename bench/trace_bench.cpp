// SPDX-License-Identifier: MIT
// Rays per second of the shaders' tracer against Embree's single-ray calls, on one core each: the
// same mesh, the same rays. For a software driver; a GPU has no cores to compare with, there the
// ratio says nothing and the rate does.
//
// Runs alternate, tracer, Embree, tracer, ..., so that a slow moment of the machine hits both; the
// ratio is the median over the pairs. On a software driver the time is that of the processor, which
// counts no waiting for other programs; LP_NUM_THREADS=1 is set here, so that one core draws. On a
// GPU it is wall time.
//
//   trace_bench [--json FILE] [--pairs N] [--triangles N | --scene FILE]
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

#include "app/session/session.hpp"
#include "base/file.hpp"
#include "bvh/build.hpp"
#include "bvh/traverse.hpp"
#include "embree_scene.hpp"
#include "frame/pass_query.hpp"
#include "stopwatch.hpp"
#include "torus_knot.hpp"

namespace vitrine {
namespace {

constexpr int kSide = 512;  // rays a side

struct Options {
    std::string json;
    int pairs = 9;
    uint32_t triangles = 70000;
    std::string scene;  // instead of the knot: all meshes of a scene, as one
};

struct RayClass {
    std::string name;
    bool any;
    std::vector<QueryRay> rays;
};

glm::vec3 cosineDirection(const glm::vec3& n, std::mt19937& random) {
    std::uniform_real_distribution<float> unit(-1, 1);
    glm::vec3 p;
    do p = {unit(random), unit(random), unit(random)};
    while (glm::dot(p, p) > 1 || glm::dot(p, p) < 1e-6f);
    return glm::normalize(n + 0.999f * glm::normalize(p));
}

struct Viewpoint {
    glm::vec3 eye{1.5f, -2, 8}, target{0}, light{6, 5, 7};
    float width = 1;  // of the image plane at distance 1
};

/// All meshes of a scene in world space; what its first camera sees by its first light.
KnotMesh flattenScene(const std::string& file, Viewpoint& view) {
    Diagnostics diagnostics;
    const LoadedScene loaded = loadAll(file, {}, diagnostics);
    diagnostics.throwIfErrors();
    KnotMesh mesh;
    for (const PackedInstance& instance : loaded.packed.instances) {
        if (instance.field) continue;
        for (size_t i = 0; i < instance.triangles; ++i) {
            const glm::uvec4& t = loaded.packed.triangles[instance.firstTriangle + i];
            const auto first = static_cast<uint32_t>(mesh.positions.size());
            mesh.triangles.emplace_back(first, first + 1, first + 2);
            for (const uint32_t v : {t.x, t.y, t.z}) {
                const glm::vec4& p = loaded.packed.vertices[v * VITRINE_VERTEX_TEXELS];
                mesh.positions.emplace_back(instance.worldFromObject * glm::vec4(p.x, p.y, p.z, 1));
            }
        }
    }
    const Camera& camera = loaded.scene.cameras.front();
    view.eye = camera.eye;
    view.target = camera.target;
    view.width =
        camera.fov > 0 ? 2 * std::tan(glm::radians(camera.fov) / 2) : 36 / camera.focalLength;
    if (!loaded.scene.lights.empty())
        view.light = camera.target - 100.0f * glm::normalize(loaded.scene.lights[0].direction);
    return mesh;
}

/// Camera rays, and from where they hit: to a light, mirrored, and in all directions.
std::vector<RayClass> rayClasses(const KnotMesh& mesh, const Viewpoint& view) {
    const Bvh bvh = buildTriangleBvh(mesh.positions, mesh.triangles);
    std::vector<RayClass> classes{{"primary", false, {}},
                                  {"shadow", true, {}},
                                  {"mirror", false, {}},
                                  {"diffuse", false, {}}};
    std::mt19937 random(1);
    const glm::vec3 eye = view.eye, light = view.light;
    const glm::vec3 forward = glm::normalize(view.target - eye),
                    right = glm::normalize(glm::cross(forward, {0, 1, 0}));
    const glm::vec3 up = glm::cross(right, forward);
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            const float u = (static_cast<float>(x) + 0.5f) / kSide - 0.5f;
            const float v = (static_cast<float>(y) + 0.5f) / kSide - 0.5f;
            const glm::vec3 d = glm::normalize(forward + view.width * (u * right + v * up));
            classes[0].rays.push_back({eye, 0, d});
            const auto hit = closestHit(bvh, mesh.positions, mesh.triangles, {eye, d});
            if (!hit) continue;
            const glm::uvec3 t = mesh.triangles[hit->triangle];
            const glm::vec3 a = mesh.positions[t.x];
            glm::vec3 n =
                glm::normalize(glm::cross(mesh.positions[t.y] - a, mesh.positions[t.z] - a));
            if (glm::dot(n, d) > 0) n = -n;
            const glm::vec3 p = eye + hit->t * d + 1e-4f * n;
            const float distance = glm::length(light - p);
            classes[1].rays.push_back({p, 0, (light - p) / distance, distance});
            classes[2].rays.push_back({p, 0, glm::reflect(d, n)});
            classes[3].rays.push_back({p, 0, cosineDirection(n, random)});
        }
    // Rays that start on the mesh are fewer than pixels: repeated until they fill the image.
    for (RayClass& c : classes)
        for (size_t i = 0; c.rays.size() < size_t(kSide) * kSide; ++i) c.rays.push_back(c.rays[i]);
    return classes;
}

PackedScene packMesh(const KnotMesh& mesh) {
    auto whole = std::make_shared<Mesh>();
    whole->positions = mesh.positions;
    whole->triangles = mesh.triangles;
    whole->normals.assign(mesh.positions.size(), glm::vec3(0, 1, 0));
    whole->uvs.assign(mesh.positions.size(), glm::vec2(0));
    whole->triangleParts.assign(mesh.triangles.size(), 0);
    whole->partNames = {"default"};
    auto asset = std::make_shared<MeshAsset>();
    asset->mesh = whole;
    asset->bvh = buildTriangleBvh(mesh.positions, mesh.triangles);
    Scene scene;
    scene.shapes.emplace_back().name = "shape";
    scene.nodes.emplace_back().shape.name = "shape";
    Assets assets{{asset}, {nullptr}, {}, {}, {}};
    Diagnostics diagnostics;
    PackedScene packed = packScene(scene, assets, diagnostics);
    diagnostics.throwIfErrors();
    return packed;
}

PackedScene packField(const std::string& file) {
    Diagnostics diagnostics;
    auto snippet = parseSnippet(readFile(file, 1 << 16), file, SnippetKind::kField, diagnostics);
    diagnostics.throwIfErrors();
    Scene scene;
    scene.shapes.emplace_back().name = "shape";
    scene.nodes.emplace_back().shape.name = "shape";
    Assets assets{{nullptr}, {std::make_shared<Snippet>(std::move(*snippet))}, {}, {}, {}};
    PackedScene packed = packScene(scene, assets, diagnostics);
    diagnostics.throwIfErrors();
    return packed;
}

std::string nameOf(Backend backend) {
    return backend == Backend::kCompute ? "compute" : "fragment";
}

constexpr double kMillion = 1e-6;

nlohmann::json benchMesh(const Context& context, const Options& options) {
    Viewpoint view;
    const KnotMesh mesh = options.scene.empty() ? makeTorusKnot(options.triangles)
                                                : flattenScene(options.scene, view);
    const PackedScene packed = packMesh(mesh);
    const EmbreeScene embree(mesh.positions, mesh.triangles, 1);
    const Stopwatch watch(context.info().software);
    std::printf("%zu triangles, %d x %d rays, %d pairs\n", mesh.triangles.size(), kSide, kSide,
                options.pairs);
    std::printf("%-9s %-9s %9s %9s %8s %11s\n", "rays", "back end", "Mrays/s", "Embree", "ratio",
                "nodes/ray");
    nlohmann::json rows = nlohmann::json::array();
    for (const RayClass& c : rayClasses(mesh, view)) {
        std::vector<Ray> rays;
        for (const QueryRay& r : c.rays) rays.push_back({r.origin, r.direction, 0, r.length});
        std::vector<EmbreeHit> hits(rays.size());
        std::vector<uint8_t> flags(rays.size());
        for (const Backend backend : {Backend::kFragment, Backend::kCompute}) {
            RayQuery counting(context, packed, backend, true);
            counting.prepare(c.rays);
            counting.repeat(c.any);
            const auto count = double(c.rays.size());
            const double nodes = double(counting.counts().nodes) / count;
            RayQuery query(context, packed, backend);
            query.prepare(c.rays);
            std::vector<double> ours, theirs, ratios;
            for (int pair = -1; pair < options.pairs; ++pair) {
                const double a = watch.secondsOf([&] { query.repeat(c.any); });
                const double b = watch.secondsOf(
                    [&] { c.any ? embree.any(rays, flags) : embree.closest(rays, hits); });
                if (pair < 0) continue;  // compiles, and wakes the caches
                ours.push_back(kMillion * count / a);
                theirs.push_back(kMillion * count / b);
                ratios.push_back(b / a);
            }
            std::printf("%-9s %-9s %9.2f %9.2f %8.3f %11.1f\n", c.name.c_str(),
                        nameOf(backend).c_str(), median(ours), median(theirs), median(ratios),
                        nodes);
            rows.push_back({{"rays", c.name},
                            {"backend", nameOf(backend)},
                            {"mrays_per_second", median(ours)},
                            {"embree_mrays_per_second", median(theirs)},
                            {"ratio", median(ratios)},
                            {"nodes_per_ray", nodes}});
        }
    }
    return rows;
}

nlohmann::json benchField(const Context& context, const Options& options) {
    const std::string file = "scenes/fields/sphere-and-ring.sdf.glsl";
    const PackedScene packed = packField(VITRINE_ROOT "/" + file);
    std::vector<QueryRay> rays;
    const glm::vec3 eye(0.6f, 0.9f, 3), forward = glm::normalize(glm::vec3(-0.2f, 0, 0) - eye);
    const glm::vec3 right = glm::normalize(glm::cross(forward, {0, 1, 0}));
    const glm::vec3 up = glm::cross(right, forward);
    for (int i = 0; i < kSide * kSide; ++i) {
        const float u = (float(i % kSide) + 0.5f) / kSide - 0.5f;
        const float v = (float(i / kSide) + 0.5f) / kSide - 0.5f;
        rays.push_back({eye, 5e-4f, glm::normalize(forward + 0.7f * (u * right + v * up))});
    }
    std::printf("\n%s\n%-9s %9s %17s %16s\n", file.c_str(), "back end", "Mrays/s",
                "evaluations/ray", "Mevaluations/s");
    nlohmann::json rows = nlohmann::json::array();
    for (const Backend backend : {Backend::kFragment, Backend::kCompute}) {
        RayQuery counting(context, packed, backend, true);
        counting.prepare(rays);
        counting.repeat(false);
        const auto count = double(rays.size());
        const double evaluations = double(counting.counts().steps) / count;
        RayQuery query(context, packed, backend);
        query.prepare(rays);
        query.repeat(false);
        const Stopwatch watch(context.info().software);
        std::vector<double> rates;
        for (int i = 0; i < options.pairs; ++i)
            rates.push_back(kMillion * count / watch.secondsOf([&] { query.repeat(false); }));
        const double rate = median(rates);
        std::printf("%-9s %9.2f %17.1f %16.1f\n", nameOf(backend).c_str(), rate, evaluations,
                    rate * evaluations);
        rows.push_back({{"field", file},
                        {"backend", nameOf(backend)},
                        {"mrays_per_second", rate},
                        {"evaluations_per_ray", evaluations},
                        {"mevaluations_per_second", rate * evaluations}});
    }
    return rows;
}

int run(const Options& options) {
    setenv("LP_NUM_THREADS", "1", 1);  // read by llvmpipe when it makes its first context
    const auto context = Context::createHeadless();
    std::printf("%s\n", context->info().renderer.c_str());
    nlohmann::json report{{"renderer", context->info().renderer}};
    report["mesh"] = benchMesh(*context, options);
    report["field"] = benchField(*context, options);
    if (!options.json.empty()) writeFileAtomically(options.json, report.dump(2) + "\n");
    return 0;
}

}  // namespace
}  // namespace vitrine

int main(int argc, char** argv) {
    vitrine::Options options;
    for (int i = 1; i < argc; ++i) {
        const std::string argument = argv[i];
        const bool valued = i + 1 < argc;
        if (argument == "--json" && valued) {
            options.json = argv[++i];
        } else if (argument == "--pairs" && valued) {
            options.pairs = std::max(1, std::atoi(argv[++i]));
        } else if (argument == "--scene" && valued) {
            options.scene = argv[++i];
        } else if (argument == "--triangles" && valued) {
            options.triangles = uint32_t(std::max(64, std::atoi(argv[++i])));
        } else {
            std::fprintf(stderr,
                         "usage: trace_bench [--json FILE] [--pairs N] "
                         "[--triangles N | --scene FILE]\n");
            return 2;
        }
    }
    try {
        return vitrine::run(options);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "trace_bench: %s\n", error.what());
        return 1;
    }
}
