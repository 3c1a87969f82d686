// SPDX-License-Identifier: MIT
#include "models/tank/round.hpp"

#include <algorithm>
#include <cmath>

#include "models/tank/polyhedron.hpp"

namespace vitrine::tank {
namespace {

Vec3 onAxis(Axis axis, double along, double side, double up) {
    switch (axis) {
        case Axis::kX:
            return {along, side, up};
        case Axis::kY:
            return {up, along, side};
        default:
            return {side, up, along};
    }
}

/// A point of the profile with the normal that the surface has there.
struct Station {
    Vec2 at, normal;
};

/// Splits the profile's sharp corners in two.
std::vector<Station> stationsOf(const std::vector<Vec2>& profile, double bevel, bool ring) {
    const size_t n = profile.size();
    const size_t segments = ring ? n : n - 1;
    const auto direction = [&](size_t s) {
        return glm::normalize(profile[(s + 1) % n] - profile[s]);
    };
    const auto length = [&](size_t s) { return glm::distance(profile[(s + 1) % n], profile[s]); };
    std::vector<Station> stations;
    for (size_t i = 0; i < n; ++i) {
        const bool first = !ring && i == 0, last = !ring && i == n - 1;
        const size_t before = (i + segments - 1) % segments, after = i % segments;
        const Vec2 in = direction(last ? segments - 1 : first ? 0 : before);
        const Vec2 out = direction(last ? segments - 1 : after);
        const Vec2 inNormal(-in.y, in.x), outNormal(-out.y, out.x);
        if (glm::dot(in, out) > 0.866) {
            // The end of a dome on the axis looks straight along it.
            const bool tip = (first || last) && profile[i].y == 0.0;
            const Vec2 axial(inNormal.x < 0.0 ? -1.0 : 1.0, 0.0);
            stations.push_back({profile[i], tip ? axial : glm::normalize(inNormal + outNormal)});
            continue;
        }
        // Only what stands out catches light; inner corners stay sharp.
        const bool standsOut = in.x * out.y - in.y * out.x < 0.0;
        const double cut =
            standsOut ? std::min({bevel, 0.4 * length(before), 0.4 * length(after)}) : 0.0;
        stations.push_back({profile[i] - cut * in, inNormal});
        stations.push_back({profile[i] + cut * out, outNormal});
    }
    if (ring) stations.push_back(stations.front());
    return stations;
}

Vec3 anyAcross(const Vec3& d) {
    const Vec3 helper = std::abs(d.y) < 0.9 ? Vec3(0, 1, 0) : Vec3(1, 0, 0);
    return glm::normalize(glm::cross(helper, d));
}

void addLid(Solid& solid, Material material, const std::vector<Vec3>& rim, const Vec3& normal) {
    for (size_t i = 2; i < rim.size(); ++i)
        solid.triangle(material, {rim[0], normal}, {rim[i - 1], normal}, {rim[i], normal});
}

}  // namespace

Solid turnedOnLathe(const std::vector<Vec2>& profile, const Lathe& how) {
    Solid solid;
    const std::vector<Station> stations = stationsOf(profile, how.bevel, how.ring);
    const auto corner = [&how](const Station& s, int i) {
        const double angle = kTau * (i % how.segments) / how.segments;
        const double c = std::cos(angle), e = std::sin(angle);
        return Corner{onAxis(how.axis, s.at.x, s.at.y * c, s.at.y * e),
                      onAxis(how.axis, s.normal.x, s.normal.y * c, s.normal.y * e)};
    };
    for (size_t row = 1; row < stations.size(); ++row)
        for (int i = 0; i < how.segments; ++i)
            solid.quad(how.material, corner(stations[row - 1], i), corner(stations[row - 1], i + 1),
                       corner(stations[row], i + 1), corner(stations[row], i));
    return solid;
}

Solid bentTube(const std::vector<Vec3>& path, const Tube& how) {
    Solid solid;
    const size_t n = path.size();
    std::vector<std::vector<Corner>> rings;
    Vec3 across = anyAcross(glm::normalize(path[1] - path[0])), before(0.0);
    for (size_t i = 0; i < n; ++i) {
        const bool first = !how.loop && i == 0, last = !how.loop && i == n - 1;
        const Vec3 in = glm::normalize(path[i] - path[(i + n - 1) % n]);
        const Vec3 out = glm::normalize(path[(i + 1) % n] - path[i]);
        const Vec3 along = first ? out : last ? in : glm::normalize(in + out);
        // The frame is carried along without twist, by the least turn from one direction to the
        // next.
        if (i > 0) {
            const Vec3 c = glm::cross(before, along);
            across += glm::cross(c, across) +
                      glm::cross(c, glm::cross(c, across)) / (1.0 + glm::dot(before, along));
        }
        across = glm::normalize(across - along * glm::dot(across, along));
        before = along;
        const Vec3 other = glm::cross(along, across);
        std::vector<Corner> ring;
        for (int k = 0; k < how.sides; ++k) {
            const double angle = kTau * (k + 0.5) / how.sides;
            const Vec3 d = std::cos(angle) * across + std::sin(angle) * other;
            ring.push_back({path[i] + how.radius * d, d});
        }
        rings.push_back(ring);
    }
    const auto sides = static_cast<size_t>(how.sides);
    const auto join = [&](const std::vector<Corner>& a, const std::vector<Corner>& b,
                          size_t twist) {
        for (size_t k = 0; k < sides; ++k) {
            const size_t l = (k + 1) % sides;
            solid.quad(how.material, a[k], a[l], b[(l + twist) % sides], b[(k + twist) % sides]);
        }
    };
    for (size_t i = 1; i < n; ++i) join(rings[i - 1], rings[i], 0);
    if (how.loop) {
        // A frame that went around may come back turned: join the corners that are nearest.
        size_t best = 0;
        for (size_t k = 1; k < sides; ++k)
            if (glm::distance(rings[n - 1][0].at, rings[0][k].at) <
                glm::distance(rings[n - 1][0].at, rings[0][best].at))
                best = k;
        join(rings[n - 1], rings[0], best);
        return solid;
    }
    if (how.open) return solid;
    std::vector<Vec3> start, end;
    for (size_t k = 0; k < sides; ++k) {
        start.push_back(rings[0][k].at);
        end.push_back(rings[n - 1][k].at);
    }
    addLid(solid, how.material, start, glm::normalize(path[0] - path[1]));
    addLid(solid, how.material, end, glm::normalize(path[n - 1] - path[n - 2]));
    return solid;
}

std::vector<Vec3> rounded(const std::vector<Vec3>& path, double radius, int steps, bool loop) {
    std::vector<Vec3> result;
    const size_t n = path.size();
    for (size_t i = 0; i < n; ++i) {
        if (!loop && (i == 0 || i == n - 1)) {
            result.push_back(path[i]);
            continue;
        }
        const Vec3 back = path[(i + n - 1) % n] - path[i], on = path[(i + 1) % n] - path[i];
        const double reach = std::min({radius, 0.45 * glm::length(back), 0.45 * glm::length(on)});
        const Vec3 from = path[i] + reach * glm::normalize(back);
        const Vec3 to = path[i] + reach * glm::normalize(on);
        for (int k = 0; k <= steps; ++k) {
            const double t = double(k) / steps;
            result.push_back((1 - t) * (1 - t) * from + 2 * t * (1 - t) * path[i] + t * t * to);
        }
    }
    return result;
}

Solid skinned(const std::vector<std::vector<Vec3>>& rings, Material material) {
    Solid solid;
    const size_t rows = rings.size(), n = rings[0].size();
    Vec3 inside(0.0);
    for (const auto& ring : rings)
        for (const Vec3& p : ring) inside += p / double(rows * n);
    // Normals from the quads around a point, by their area; all quads turn the same way.
    std::vector<std::vector<Vec3>> normals(rows, std::vector<Vec3>(n, Vec3(0.0)));
    double outward = 0.0;
    for (size_t r = 1; r < rows; ++r)
        for (size_t i = 0; i < n; ++i) {
            const size_t j = (i + 1) % n;
            const Vec3 flat =
                glm::cross(rings[r][j] - rings[r - 1][i], rings[r][i] - rings[r - 1][j]);
            outward += glm::dot(flat, rings[r][i] - inside);
            for (Vec3* corner :
                 {&normals[r - 1][i], &normals[r - 1][j], &normals[r][i], &normals[r][j]})
                *corner += flat;
        }
    const double sign = outward < 0.0 ? -1.0 : 1.0;
    const auto isPoint = [](const std::vector<Vec3>& ring) {
        return glm::distance(ring[0], ring[ring.size() / 2]) < 1e-6;
    };
    for (size_t r = 0; r < rows; ++r) {
        Vec3 sum(0.0);
        for (const Vec3& each : normals[r]) sum += each;
        for (Vec3& each : normals[r]) each = sign * glm::normalize(isPoint(rings[r]) ? sum : each);
    }
    for (size_t r = 1; r < rows; ++r)
        for (size_t i = 0; i < n; ++i) {
            const size_t j = (i + 1) % n;
            solid.quad(material, {rings[r - 1][i], normals[r - 1][i]},
                       {rings[r - 1][j], normals[r - 1][j]}, {rings[r][j], normals[r][j]},
                       {rings[r][i], normals[r][i]});
        }
    for (const size_t r : {size_t{0}, rows - 1}) {
        if (isPoint(rings[r])) continue;
        const size_t next = r == 0 ? 1 : r - 1;
        Vec3 middle(0.0), nextMiddle(0.0);
        for (size_t i = 0; i < n; ++i) {
            middle += rings[r][i] / double(n);
            nextMiddle += rings[next][i] / double(n);
        }
        addLid(solid, material, rings[r], glm::normalize(middle - nextMiddle));
    }
    return solid;
}

Solid hexBolt(double radius, double height, Material material) {
    Solid solid;
    const double shoulder = 0.75 * height, top = 0.8 * radius;
    std::vector<Vec3> lid;
    for (int i = 0; i < 6; ++i) {
        const auto at = [i](int k, double r, double y) {
            const double angle = kTau * (i + k) / 6.0;
            return Vec3(r * std::cos(angle), y, r * std::sin(angle));
        };
        const double middle = kTau * (i + 0.5) / 6.0;
        const Vec3 side(std::cos(middle), 0, std::sin(middle)), up(0, 1, 0);
        solid.quad(material, {at(0, radius, 0), side}, {at(1, radius, 0), side},
                   {at(1, radius, shoulder), side}, {at(0, radius, shoulder), side});
        solid.quad(material, {at(0, radius, shoulder), side}, {at(1, radius, shoulder), side},
                   {at(1, top, height), up}, {at(0, top, height), up});
        lid.push_back(at(0, top, height));
    }
    addLid(solid, material, lid, {0, 1, 0});
    return solid;
}

Solid rivet(double radius, Material material) {
    return turnedOnLathe({{0, radius}, {0.4 * radius, 0.72 * radius}, {0.55 * radius, 0}},
                         {Axis::kY, 5, 0.0, false, material});
}

Solid handle(double length, double height, double radius, Material material) {
    const double x = 0.5 * length;
    return bentTube(
        rounded({{-x, 0, 0}, {-x, height, 0}, {x, height, 0}, {x, 0, 0}}, 2.5 * radius, 1),
        {radius, 4, false, material});
}

}  // namespace vitrine::tank
