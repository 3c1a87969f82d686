// SPDX-License-Identifier: MIT
#include "app/cli/describe_tree.hpp"

#include <fmt/format.h>

#include <chrono>

#include "pack/bvh_layout.hpp"
#include "pack/tree_options.hpp"

namespace vitrine {
namespace {

using Json = nlohmann::ordered_json;

/// `leaf_sizes[i]`: leaves of i triangles; the last entry counts all larger ones as well.
Json describeTree(const Bvh& bvh, const Mesh& mesh, float traversalCost, double buildSeconds) {
    const BvhStatistics s = measure(bvh, traversalCost);
    BvhLayout layout;
    (void)layout.addMesh(bvh, mesh.positions, mesh.triangles);
    return {{"sah_cost", s.sahCost},
            {"tree_nodes", s.nodes},
            {"tree_depth", s.depth},
            {"leaves", s.leaves},
            {"mean_leaf", s.meanLeaf},
            {"leaf_sizes", s.leafSizes},
            {"references", s.references},
            {"duplicates", s.references - mesh.triangles.size()},
            {"tree_bytes", layout.texels().size() * sizeof(glm::uvec4)},
            {"stack_entries", layout.stackBound()},
            {"build_seconds", buildSeconds}};
}

std::string histogramOf(const Json& tree) {
    std::string text;
    const Json& sizes = tree["leaf_sizes"];
    for (size_t i = 1; i < sizes.size(); ++i)
        if (sizes[i].get<size_t>() > 0)
            text += fmt::format("{}{}{}: {}", text.empty() ? "" : ", ", i,
                                i + 1 == sizes.size() ? "+" : "", sizes[i].get<size_t>());
    return text;
}

}  // namespace

Json describeMesh(const std::string& shape, const MeshAsset& asset, const TreeSettings& settings,
                  bool builders) {
    const Mesh& mesh = *asset.mesh;
    Json json{{"shape", shape},
              {"triangles", mesh.triangles.size()},
              {"vertices", mesh.positions.size()},
              {"parts", mesh.partNames},
              {"builder", kTreeBuilderNames[static_cast<size_t>(settings.builder)]}};
    json.update(describeTree(asset.bvh, mesh, settings.traversalCost, asset.buildSeconds));
    for (size_t i = 0; builders && i < kTreeBuilderNames.size(); ++i) {
        TreeSettings other = settings;
        other.builder = static_cast<TreeBuilder>(i);
        const auto start = std::chrono::steady_clock::now();
        const Bvh bvh = buildTriangleBvh(mesh.positions, mesh.triangles, buildOptions(other));
        const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
        json["builders"][kTreeBuilderNames[i]] =
            describeTree(bvh, mesh, settings.traversalCost, elapsed.count());
    }
    return json;
}

void printMesh(const Json& m) {
    fmt::print(
        "mesh {}: {} triangles, {} tree of {} nodes, depth {}, SAH cost {:.1f}, built in {:.1f} "
        "ms\n",
        m["shape"].get<std::string>(), m["triangles"].get<size_t>(),
        m["builder"].get<std::string>(), m["tree_nodes"].get<size_t>(), m["tree_depth"].get<int>(),
        m["sah_cost"].get<double>(), 1e3 * m["build_seconds"].get<double>());
    if (!m.contains("builders")) {
        fmt::print("  {} references ({} duplicates), {} bytes, leaves by size {}\n",
                   m["references"].get<size_t>(), m["duplicates"].get<size_t>(),
                   m["tree_bytes"].get<size_t>(), histogramOf(m));
        return;
    }
    fmt::print("  {:8} {:>9} {:>9} {:>6} {:>11} {:>11} {:>9}  {}\n", "builder", "SAH cost", "nodes",
               "depth", "references", "bytes", "ms", "leaves by size");
    for (const auto& [name, tree] : m["builders"].items())
        fmt::print("  {:8} {:9.2f} {:9} {:6} {:11} {:11} {:9.1f}  {}\n", name,
                   tree["sah_cost"].get<double>(), tree["tree_nodes"].get<size_t>(),
                   tree["tree_depth"].get<int>(), tree["references"].get<size_t>(),
                   tree["tree_bytes"].get<size_t>(), 1e3 * tree["build_seconds"].get<double>(),
                   histogramOf(tree));
}

}  // namespace vitrine
