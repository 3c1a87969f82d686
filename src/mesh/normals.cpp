// SPDX-License-Identifier: MIT
// Corners of triangles that meet in a point are joined across each edge that is not sharp; every
// set of joined corners gets one normal, the mean of its triangles' normals weighted by the angle
// at the point, which does not depend on how the surface was cut into triangles.
// Source: Thürmer, Wüthrich, "Computing vertex normals from polygonal facets", JGT 3(1), 1998.
#include "mesh/normals.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "mesh/vertex_arrays.hpp"

namespace vitrine {
namespace {

// Edges shared by more triangles than this join only neighbours in the list, or a fan of n
// triangles around one edge would cost n^2.
constexpr size_t kAllPairs = 8;

/// Sets of corners; corner = 3 * triangle + 0, 1, 2. The smallest corner stands for its set, so
/// the result does not depend on the order of joining.
class CornerSets {
  public:
    explicit CornerSets(size_t corners) : parent_(corners) {
        std::iota(parent_.begin(), parent_.end(), 0u);
    }
    uint32_t find(uint32_t corner) {
        while (parent_[corner] != corner) {
            parent_[corner] = parent_[parent_[corner]];
            corner = parent_[corner];
        }
        return corner;
    }
    void join(uint32_t a, uint32_t b) {
        a = find(a);
        b = find(b);
        parent_[std::max(a, b)] = std::min(a, b);
    }

  private:
    std::vector<uint32_t> parent_;
};

struct Edge {
    uint32_t low, high;  // points
    uint32_t cornerAtLow, cornerAtHigh;
    bool operator<(const Edge& o) const {
        if (low != o.low) return low < o.low;
        if (high != o.high) return high < o.high;
        return cornerAtLow < o.cornerAtLow;
    }
};

class NormalFiller {
  public:
    NormalFiller(Mesh& mesh, const Smoothing& smoothing)
        : mesh_(mesh),
          smoothing_(smoothing),
          cosCrease_(std::cos(glm::radians(double(smoothing.creaseDegrees)))),
          sets_(mesh.triangles.size() * 3) {}

    void run() {
        weld();
        computeFaceNormals();
        joinAcrossEdges();
        assign(sumSets());
    }

  private:
    /// Gives equal positions the same number.
    void weld() {
        const auto& p = mesh_.positions;
        const auto before = [&p](uint32_t a, uint32_t b) {
            if (p[a].x != p[b].x) return p[a].x < p[b].x;
            if (p[a].y != p[b].y) return p[a].y < p[b].y;
            return p[a].z < p[b].z;
        };
        std::vector<uint32_t> order(p.size());
        std::iota(order.begin(), order.end(), 0u);
        std::sort(order.begin(), order.end(), before);
        point_.resize(p.size());
        uint32_t point = 0;
        for (size_t i = 0; i < order.size(); ++i) {
            if (i > 0 && before(order[i - 1], order[i])) ++point;
            point_[order[i]] = point;
        }
    }

    void computeFaceNormals() {
        faceNormals_.reserve(mesh_.triangles.size());
        for (const glm::uvec3& v : mesh_.triangles) {
            const glm::dvec3 a(mesh_.positions[v.x]);
            faceNormals_.push_back(glm::normalize(glm::cross(
                glm::dvec3(mesh_.positions[v.y]) - a, glm::dvec3(mesh_.positions[v.z]) - a)));
        }
    }

    uint32_t vertexOf(uint32_t corner) const { return mesh_.triangles[corner / 3][corner % 3]; }

    bool isSmooth(uint32_t triangleA, uint32_t triangleB) const {
        uint32_t group = Smoothing::kByAngle;
        if (!smoothing_.groups.empty()) {
            group = smoothing_.groups[triangleA];
            if (group == Smoothing::kFlat || group != smoothing_.groups[triangleB]) return false;
        }
        return group != Smoothing::kByAngle ||
               glm::dot(faceNormals_[triangleA], faceNormals_[triangleB]) >= cosCrease_;
    }

    std::vector<Edge> sortedEdges() const {
        std::vector<Edge> edges;
        edges.reserve(mesh_.triangles.size() * 3);
        const auto corners = static_cast<uint32_t>(mesh_.triangles.size() * 3);
        for (uint32_t corner = 0; corner < corners; ++corner) {
            const uint32_t next = corner % 3 == 2 ? corner - 2 : corner + 1;
            const uint32_t from = point_[vertexOf(corner)], to = point_[vertexOf(next)];
            edges.push_back(from < to ? Edge{from, to, corner, next}
                                      : Edge{to, from, next, corner});
        }
        std::sort(edges.begin(), edges.end());
        return edges;
    }

    void joinAcrossEdges() {
        const std::vector<Edge> edges = sortedEdges();
        for (size_t first = 0, last = 0; first < edges.size(); first = last) {
            while (last < edges.size() && edges[last].low == edges[first].low &&
                   edges[last].high == edges[first].high)
                ++last;
            const size_t reach = last - first <= kAllPairs ? kAllPairs : 1;
            for (size_t i = first; i < last; ++i)
                for (size_t j = i + 1; j < last && j <= i + reach; ++j) {
                    if (!isSmooth(edges[i].cornerAtLow / 3, edges[j].cornerAtLow / 3)) continue;
                    sets_.join(edges[i].cornerAtLow, edges[j].cornerAtLow);
                    sets_.join(edges[i].cornerAtHigh, edges[j].cornerAtHigh);
                }
        }
    }

    double angleAt(uint32_t corner) const {
        const glm::uvec3& v = mesh_.triangles[corner / 3];
        const uint32_t k = corner % 3;
        const glm::dvec3 here(mesh_.positions[v[k]]);
        const glm::dvec3 toNext = glm::dvec3(mesh_.positions[v[(k + 1) % 3]]) - here;
        const glm::dvec3 toLast = glm::dvec3(mesh_.positions[v[(k + 2) % 3]]) - here;
        return std::atan2(glm::length(glm::cross(toNext, toLast)), glm::dot(toNext, toLast));
    }

    /// Indexed by the corner that stands for a set.
    std::vector<glm::dvec3> sumSets() {
        std::vector<glm::dvec3> sums(mesh_.triangles.size() * 3, glm::dvec3(0.0));
        for (uint32_t corner = 0; corner < sums.size(); ++corner)
            sums[sets_.find(corner)] += angleAt(corner) * faceNormals_[corner / 3];
        return sums;
    }

    /// The first set at a vertex takes the vertex, each further one a copy of it.
    void assign(const std::vector<glm::dvec3>& sums) {
        struct Use {
            uint32_t vertex, set, corner;
        };
        std::vector<Use> uses;
        for (uint32_t corner = 0; corner < sums.size(); ++corner)
            if (mesh_.normals[vertexOf(corner)] == glm::vec3(0.0f))
                uses.push_back({vertexOf(corner), sets_.find(corner), corner});
        std::sort(uses.begin(), uses.end(), [](const Use& a, const Use& b) {
            return a.vertex != b.vertex ? a.vertex < b.vertex
                   : a.set != b.set     ? a.set < b.set
                                        : a.corner < b.corner;
        });
        uint32_t target = 0;
        for (size_t i = 0; i < uses.size(); ++i) {
            const Use& use = uses[i];
            const bool newVertex = i == 0 || use.vertex != uses[i - 1].vertex;
            if (newVertex || use.set != uses[i - 1].set) {
                target = newVertex ? use.vertex : copyVertex(use.vertex);
                // Faces back to back cancel; then any of them is as good.
                const double length = glm::length(sums[use.set]);
                mesh_.normals[target] = glm::vec3(length > 1e-6 ? sums[use.set] / length
                                                                : faceNormals_[use.corner / 3]);
            }
            mesh_.triangles[use.corner / 3][use.corner % 3] = target;
        }
    }

    uint32_t copyVertex(uint32_t vertex) {
        forEachVertexArray(mesh_, [vertex](auto& array) {
            const auto value = array[vertex];  // a reference would dangle when the array grows
            array.push_back(value);
        });
        return static_cast<uint32_t>(mesh_.positions.size() - 1);
    }

    Mesh& mesh_;
    const Smoothing& smoothing_;
    double cosCrease_;
    CornerSets sets_;
    std::vector<uint32_t> point_;  // of each vertex
    std::vector<glm::dvec3> faceNormals_;
};

}  // namespace

void fillMissingNormals(Mesh& mesh, const Smoothing& smoothing) {
    const bool missing = std::any_of(mesh.normals.begin(), mesh.normals.end(),
                                     [](const glm::vec3& n) { return n == glm::vec3(0.0f); });
    if (missing) NormalFiller(mesh, smoothing).run();
}

}  // namespace vitrine
