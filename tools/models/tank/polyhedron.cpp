// SPDX-License-Identifier: MIT
#include "models/tank/polyhedron.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <utility>

#include "mesh/triangulate.hpp"

namespace vitrine::tank {
namespace {

constexpr double kSame = 1e-7;

/// Newell's: right for concave polygons too.
Vec3 faceNormal(const std::vector<Vec3>& points, std::span<const uint32_t> face) {
    Vec3 sum(0.0);
    for (size_t i = 0; i < face.size(); ++i)
        sum += glm::cross(points[face[i]], points[face[(i + 1) % face.size()]]);
    return glm::normalize(sum);
}

double volume(const Polyhedron& body) {
    double sum = 0.0;
    for (const auto& face : body.faces)
        for (size_t i = 2; i < face.size(); ++i)
            sum += glm::dot(body.points[face[0]],
                            glm::cross(body.points[face[i - 1]], body.points[face[i]]));
    return sum;
}

Polyhedron outward(Polyhedron body) {
    if (volume(body) < 0.0)
        for (auto& face : body.faces) std::reverse(face.begin(), face.end());
    return body;
}

/// The face made smaller: each corner moves along both of its edges, so the edges stay parallel.
std::vector<Vec3> inset(const std::vector<Vec3>& points, std::span<const uint32_t> face,
                        const Vec3& normal, double width) {
    const size_t n = face.size();
    double shortest = 1e9;
    for (size_t i = 0; i < n; ++i)
        shortest = std::min(shortest, glm::distance(points[face[i]], points[face[(i + 1) % n]]));
    const double by = std::min(width, 0.3 * shortest);
    std::vector<Vec3> result;
    for (size_t i = 0; i < n; ++i) {
        const Vec3& p = points[face[i]];
        const Vec3 before = glm::normalize(p - points[face[(i + n - 1) % n]]);
        const Vec3 after = glm::normalize(points[face[(i + 1) % n]] - p);
        const Vec3 a = glm::cross(normal, before), b = glm::cross(normal, after);
        result.push_back(p + by * (a + b) / std::max(0.3, 1.0 + glm::dot(a, b)));
    }
    return result;
}

void addPolygon(Solid& solid, Material material, const std::vector<Corner>& rim) {
    std::vector<glm::vec3> points;
    for (const Corner& c : rim) points.emplace_back(c.at);
    std::vector<glm::uvec3> cut;
    Triangulator(1'000'000).triangulate(points, cut);
    for (const glm::uvec3& t : cut) solid.triangle(material, rim[t.x], rim[t.y], rim[t.z]);
}

}  // namespace

Polyhedron box(const Vec3& low, const Vec3& high) {
    return prism({{low.x, low.y}, {high.x, low.y}, {high.x, high.y}, {low.x, high.y}}, low.z,
                 high.z);
}

Polyhedron prism(std::vector<Vec2> outline, double low, double high) {
    std::vector<Vec3> from, to;
    for (const Vec2& p : outline) {
        from.emplace_back(p, low);
        to.emplace_back(p, high);
    }
    return loft({from, to});
}

Polyhedron loft(const std::vector<std::vector<Vec3>>& rings) {
    Polyhedron body;
    const auto n = static_cast<uint32_t>(rings[0].size());
    const auto last = static_cast<uint32_t>(rings.size() - 1) * n;
    for (const auto& ring : rings) body.points.insert(body.points.end(), ring.begin(), ring.end());
    for (uint32_t row = 0; row < last; row += n)
        for (uint32_t i = 0; i < n; ++i) {
            const uint32_t j = (i + 1) % n;
            body.faces.push_back({row + i, row + j, row + n + j, row + n + i});
        }
    std::vector<uint32_t> bottom, top;
    for (uint32_t i = 0; i < n; ++i) {
        bottom.push_back(n - 1 - i);
        top.push_back(last + i);
    }
    body.faces.push_back(bottom);
    body.faces.push_back(top);
    return outward(std::move(body));
}

Polyhedron convex(const std::vector<Plane>& planes) {
    Polyhedron body;
    std::vector<std::vector<uint32_t>> onPlane(planes.size());
    const auto inside = [&planes](const Vec3& p) {
        return std::ranges::all_of(
            planes, [&p](const Plane& s) { return glm::dot(s.normal, p) <= s.offset + kSame; });
    };
    const auto pointAt = [&body](const Vec3& p) {
        for (uint32_t i = 0; i < body.points.size(); ++i)
            if (glm::distance(body.points[i], p) < 1e-5) return i;
        body.points.push_back(p);
        return static_cast<uint32_t>(body.points.size() - 1);
    };
    for (size_t i = 0; i < planes.size(); ++i)
        for (size_t j = i + 1; j < planes.size(); ++j)
            for (size_t k = j + 1; k < planes.size(); ++k) {
                const glm::dmat3 rows(planes[i].normal, planes[j].normal, planes[k].normal);
                if (std::abs(glm::determinant(rows)) < 1e-9) continue;
                const Vec3 p = glm::inverse(glm::transpose(rows)) *
                               Vec3(planes[i].offset, planes[j].offset, planes[k].offset);
                if (!inside(p)) continue;
                const uint32_t at = pointAt(p);
                for (const size_t plane : {i, j, k})
                    if (std::ranges::find(onPlane[plane], at) == onPlane[plane].end())
                        onPlane[plane].push_back(at);
            }
    for (size_t i = 0; i < planes.size(); ++i) {
        std::vector<uint32_t>& face = onPlane[i];
        if (face.size() < 3) continue;
        Vec3 middle(0.0);
        for (const uint32_t p : face) middle += body.points[p] / double(face.size());
        const Vec3 x = glm::normalize(body.points[face[0]] - middle);
        const Vec3 y = glm::cross(planes[i].normal, x);
        std::ranges::sort(face, {}, [&](uint32_t p) {
            const Vec3 d = body.points[p] - middle;
            return std::atan2(glm::dot(d, y), glm::dot(d, x));
        });
        body.faces.push_back(face);
    }
    return body;
}

std::vector<Vec2> regularPolygon(int sides, double radius) {
    std::vector<Vec2> outline;
    for (int i = 0; i < sides; ++i) {
        const double angle = kTau * (i + 0.5) / sides;
        outline.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
    return outline;
}

Solid softBar(const std::vector<Vec2>& outline, double low, double high, double width,
              Material material) {
    Solid solid;
    const size_t n = outline.size();
    double area = 0.0;
    for (size_t i = 0; i < n; ++i) {
        const Vec2 &a = outline[i], &b = outline[(i + 1) % n];
        area += a.x * b.y - a.y * b.x;
    }
    std::vector<Vec2> rim;
    std::vector<Vec3> normals;  // of the side that begins at every second point of the rim
    for (size_t i = 0; i < n; ++i) {
        const Vec2 &a = outline[i], &b = outline[(i + 1) % n];
        const Vec2 d = glm::normalize(b - a);
        const double cut = std::min(width, 0.3 * glm::distance(a, b));
        rim.push_back(a + cut * d);
        rim.push_back(b - cut * d);
        normals.push_back((area < 0.0 ? -1.0 : 1.0) * Vec3(d.y, -d.x, 0));
    }
    for (size_t i = 0; i < 2 * n; ++i) {
        const size_t j = (i + 1) % (2 * n);
        const Vec3 &a = normals[i / 2], &b = normals[j / 2];
        solid.quad(material, {Vec3(rim[i], low), a}, {Vec3(rim[j], low), b},
                   {Vec3(rim[j], high), b}, {Vec3(rim[i], high), a});
    }
    for (const double z : {low, high}) {
        std::vector<Corner> lid;
        for (const Vec2& p : rim) lid.push_back({Vec3(p, z), Vec3(0, 0, z == low ? -1 : 1)});
        addPolygon(solid, material, lid);
    }
    return solid;
}

Solid softBar(const Vec3& low, const Vec3& high, double width, Material material) {
    return softBar({{low.x, low.y}, {high.x, low.y}, {high.x, high.y}, {low.x, high.y}}, low.z,
                   high.z, width, material);
}

Solid bevelled(const Polyhedron& body, double width, Material material) {
    Solid solid;
    // By directed edge: the face that runs along it.
    std::map<std::pair<uint32_t, uint32_t>, size_t> faceOf;
    std::vector<std::map<uint32_t, Corner>> corners(body.faces.size());
    for (size_t f = 0; f < body.faces.size(); ++f) {
        const auto& face = body.faces[f];
        const Vec3 normal = faceNormal(body.points, face);
        const std::vector<Vec3> small = inset(body.points, face, normal, width);
        std::vector<Corner> rim;
        for (size_t i = 0; i < face.size(); ++i) {
            faceOf[{face[i], face[(i + 1) % face.size()]}] = f;
            corners[f][face[i]] = {small[i], normal};
            rim.push_back({small[i], normal});
        }
        addPolygon(solid, material, rim);
    }
    for (const auto& [edge, f] : faceOf) {
        const auto [a, b] = edge;
        if (a > b) continue;
        const size_t g = faceOf.at({b, a});
        solid.quad(material, corners[f][b], corners[f][a], corners[g][a], corners[g][b]);
    }
    for (uint32_t p = 0; p < body.points.size(); ++p) {
        std::vector<Corner> rim;
        const auto start = std::ranges::find_if(
            corners, [p](const std::map<uint32_t, Corner>& face) { return face.contains(p); });
        if (start == corners.end()) continue;
        const auto first = static_cast<size_t>(start - corners.begin());
        size_t f = first;
        do {
            rim.push_back(corners[f].at(p));
            const auto& face = body.faces[f];
            const auto here = static_cast<size_t>(std::ranges::find(face, p) - face.begin());
            f = faceOf.at({p, face[(here + face.size() - 1) % face.size()]});
        } while (f != first);
        for (size_t i = 2; i < rim.size(); ++i)
            solid.triangle(material, rim[0], rim[i - 1], rim[i]);
    }
    return solid;
}

}  // namespace vitrine::tank
