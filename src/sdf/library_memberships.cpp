// SPDX-License-Identifier: MIT
#include "sdf/library_memberships.hpp"

#include <cmath>
#include <vector>

namespace vitrine {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr double kPi2 = 6.283185307179586;

double sq(double x) {
    return x * x;
}
double radial(const dvec3& p) {
    return std::hypot(p.x, p.z);
}
double fromTop(const dvec3& p) {  // the angle from +y in the plane z = 0
    return std::abs(std::atan2(p.x, p.y));
}

/// Crossings of a ray to the right with a polygon's edges.
bool inPolygon(const dvec2& p, const std::vector<dvec2>& corners) {
    bool inside = false;
    for (size_t i = 0; i < corners.size(); ++i) {
        const dvec2 a = corners[i], b = corners[(i + 1) % corners.size()];
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x))
            inside = !inside;
    }
    return inside;
}

Inside polygon(std::vector<dvec2> corners) {
    return [corners = std::move(corners)](const dvec3& p) { return inPolygon(dvec2(p), corners); };
}

std::vector<dvec2> around(int count, double first, double outer, double inner) {
    std::vector<dvec2> corners;
    for (int i = 0; i < count; ++i) {
        const double angle = first + kPi2 * i / count;
        corners.push_back((i % 2 == 0 ? outer : inner) * dvec2(std::sin(angle), std::cos(angle)));
    }
    return corners;
}

/// All in front of no plane dot(p, normal) = radius.
Inside planes(const std::vector<dvec3>& normals, double radius) {
    return [=](const dvec3& p) {
        for (const dvec3& n : normals)
            if (glm::dot(p, glm::normalize(n)) > radius) return false;
        return true;
    };
}

/// The vectors made from v by cyclic permutation and any signs.
std::vector<dvec3> cyclic(const dvec3& v) {
    std::vector<dvec3> all;
    for (int i = 0; i < 3; ++i)
        for (int s = 0; s < 8; ++s) {
            const dvec3 w(v[i], v[(i + 1) % 3], v[(i + 2) % 3]);
            all.push_back(w * dvec3(s & 1 ? -1 : 1, s & 2 ? -1 : 1, s & 4 ? -1 : 1));
        }
    return all;
}

std::vector<dvec3> both(std::vector<dvec3> a, const std::vector<dvec3>& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

/// Within `radius` of the curve, of which 20,000 points are tried.
Inside nearCurve(const std::function<dvec3(double)>& curve, double radius) {
    auto points = std::make_shared<std::vector<dvec3>>();
    for (int i = 0; i <= 20000; ++i) points->push_back(curve(i / 20000.0));
    return [points, radius](const dvec3& p) {
        for (const dvec3& q : *points)
            if (glm::dot(p - q, p - q) < radius * radius) return true;
        return false;
    };
}

Inside nearLine(const dvec3& a, const dvec3& b, double radius) {
    return nearCurve([=](double t) { return glm::mix(a, b, t); }, radius);
}

/// Along an axis from a to b: (way from a, distance from the axis, length), by cross products.
struct Along {
    double way, away, size;
};
Along along(const dvec3& p, const dvec3& a, const dvec3& b) {
    const double size = glm::length(b - a);
    return {glm::dot(p - a, b - a) / size, glm::length(glm::cross(p - a, b - a)) / size, size};
}

bool inBox(const dvec3& p, const dvec3& h) {
    return std::abs(p.x) < h.x && std::abs(p.y) < h.y && std::abs(p.z) < h.z;
}
bool inRoundedBox(const dvec3& p, const dvec3& h, double r) {
    if (!inBox(p, h)) return false;
    const dvec3 c = glm::clamp(p, r - h, h - r);
    return glm::dot(p - c, p - c) < r * r;
}

/// The hull of balls about a and b: some ball of the family between them holds the point.
bool inBalls(const dvec3& p, const dvec3& a, const dvec3& b, double ra, double rb) {
    for (int i = 0; i <= 4000; ++i) {
        const double t = i / 4000.0;
        if (glm::length(p - glm::mix(a, b, t)) < ra + t * (rb - ra)) return true;
    }
    return false;
}

bool inEgg(double x, double y) {  // bottom 0.6, top 0.25, stretch 0.35
    const double k = 0.35, h = 0.7, m = (h * h - k * k) / (2 * k);
    if (y < 0) return x * x + y * y < 0.36;
    const bool cap = x * x + sq(y - h) < 0.0625;
    const double endY = h * (0.6 + m) / std::hypot(h, m);  // where arc and cap meet
    return cap || (y < endY && sq(std::abs(x) + m) + y * y < sq(0.6 + m));
}

const dvec3 kIcosahedralFace(0, 1, 2.618033988749895);  // and cyclic; with (1, 1, 1)
const dvec3 kDodecahedralFace(1, 0, 1.618033988749895);

}  // namespace

std::map<std::string, Inside> memberships() {
    std::map<std::string, Inside> in;
    // ---- plane shapes ----
    in["sd2HalfPlane"] = [](auto p) { return p.y < 0; };
    in["sd2Box"] = [](auto p) { return inBox(p, {0.8, 0.5, 1}); };
    in["sd2RoundedBox"] = [](auto p) { return inRoundedBox(p, {0.8, 0.5, 1}, 0.2); };
    in["sd2Segment"] = nearLine({-0.6, -0.4, 0}, {0.7, 0.3, 0}, 0.1);
    in["sd2OrientedBox"] = [](auto p) {
        const Along c = along(p, {-0.5, -0.4, 0}, {0.6, 0.4, 0});
        return c.way > 0 && c.way < c.size && c.away < 0.3;
    };
    in["sd2PolygonEnd"] = polygon({{-0.7, -0.5}, {0.8, -0.2}, {0, 0.7}});
    in["sd2Triangle"] = polygon({{-0.7, -0.5}, {0.8, -0.2}, {0.1, 0.7}});
    in["sd2Quad"] = polygon({{-0.7, -0.5}, {0.8, -0.3}, {0.3, 0}, {0.4, 0.7}});
    in["sd2Trapezoid"] = polygon({{-0.8, -0.5}, {0.8, -0.5}, {0.4, 0.5}, {-0.4, 0.5}});
    in["sd2Isosceles"] = polygon({{-0.6, -0.5}, {0.6, -0.5}, {0, 0.6}});
    in["sd2Parallelogram"] = polygon({{-0.2, 0.5}, {0.8, 0.5}, {0.2, -0.5}, {-0.8, -0.5}});
    in["sd2Rhombus"] = polygon({{0.8, 0}, {0, 0.5}, {-0.8, 0}, {0, -0.5}});
    in["sd2ChamferBox"] = polygon({{0.8, 0.3},
                                   {0.6, 0.5},
                                   {-0.6, 0.5},
                                   {-0.8, 0.3},
                                   {-0.8, -0.3},
                                   {-0.6, -0.5},
                                   {0.6, -0.5},
                                   {0.8, -0.3}});
    in["sd2Polygon"] = [](auto p) {
        std::vector<dvec2> turned;
        for (int i = 0; i < 5; ++i) {
            const double angle = kPi2 / 2 + kPi2 * (i + 0.5) / 5;
            turned.push_back(0.6 / std::cos(kPi2 / 10) * dvec2(std::sin(angle), std::cos(angle)));
        }
        return inPolygon(dvec2(p), turned);
    };
    in["sd2Star"] = polygon(around(10, 0, 0.9, 0.4));
    in["sd2Cross"] = [](auto p) { return inBox(p, {0.8, 0.25, 1}) || inBox(p, {0.25, 0.8, 1}); };
    in["sd2RoundedX"] = [a = nearLine({-0.6, -0.6, 0}, {0.6, 0.6, 0}, 0.15),
                         b = nearLine({-0.6, 0.6, 0}, {0.6, -0.6, 0}, 0.15)](auto p) {
        return a(p) || b(p);
    };
    in["sd2Stairs"] = [](auto p) {
        const double x = p.x + 0.8, y = p.y + 0.6;
        for (int i = 0; i < 5; ++i)
            if (x > 0.3 * i && x < 1.5 && y > 0 && y < 0.22 * (i + 1)) return true;
        return false;
    };
    in["sd2Circle"] = [](auto p) { return p.x * p.x + p.y * p.y < 0.49; };
    in["sd2Ring"] = [](auto p) {
        const double rr = p.x * p.x + p.y * p.y;
        return rr > sq(0.45) && rr < sq(0.75);
    };
    in["sd2Arc"] = nearCurve(
        [](double t) {
            const double a = 2 * (2 * t - 1);
            return 0.6 * dvec3(std::sin(a), std::cos(a), 0);
        },
        0.12);
    in["sd2Pie"] = [](auto p) { return fromTop(p) < 0.8 && p.x * p.x + p.y * p.y < 0.64; };
    in["sd2CutDisc"] = [](auto p) { return p.y > -0.3 && p.x * p.x + p.y * p.y < 0.64; };
    in["sd2Vesica"] = [](auto p) {
        return sq(p.x - 0.5) + p.y * p.y < 1 && sq(p.x + 0.5) + p.y * p.y < 1;
    };
    in["sd2Moon"] = [](auto p) {
        return p.x * p.x + p.y * p.y < 0.64 && sq(p.x - 0.4) + p.y * p.y > sq(0.65);
    };
    in["sd2Drop"] = [](auto p) {
        return inBalls(p + dvec3(0, 0.3, 0), dvec3(0), {0, 0.7, 0}, 0.45, 0.2);
    };
    in["sd2Egg"] = [](auto p) { return inEgg(p.x, p.y + 0.15); };
    in["sd2Heart"] = [](auto p) {
        const double x = std::abs(p.x) / 1.3, y = (p.y + 0.7) / 1.3;
        return (x + y < 1 && y > x) || sq(x - 0.25) + sq(y - 0.75) < 0.125 ||
               (x + std::abs(y - 0.5) < 0.5);
    };
    in["sd2Horseshoe"] = [](auto p) {
        const double x = std::abs(p.x), y = p.y + 0.1, r = std::hypot(x, y);
        if (std::atan2(x, y) > 0.6) return r > 0.48 && r < 0.72;
        // Turned so that the leg stands upright.
        const double u = x * std::sin(0.6) + y * std::cos(0.6);
        const double v = y * std::sin(0.6) - x * std::cos(0.6);
        return u > 0.48 && u < 0.72 && v < 0.25;
    };
    in["sd2Tunnel"] = [](auto p) {
        return std::abs(p.x) < 0.5 && p.y > -0.6 && (p.y < 0 || p.x * p.x + p.y * p.y < 0.25);
    };
    in["sd2HollowSquare"] = [](auto p) {
        const double rr = sq(0.1) + sq(0.9);
        return std::abs(p.x) < 0.8 && std::abs(p.y) < 0.8 &&
               sq(std::abs(p.x) - 0.9) + sq(std::abs(p.y) - 0.9) > rr;
    };
    in["sd2CircleWave"] = nearCurve(
        [](double t) {
            // Six arcs, every other one turned around, from left to right.
            const int n = std::min(5, static_cast<int>(6 * t)) - 3;
            const double a = 1.1 * (2 * (6 * t - (n + 3)) - 1);
            const double up = n % 2 == 0 ? 1 : -1;
            return dvec3(0.6 * std::sin(1.1) * n + 0.3 * std::sin(a),
                         up * 0.3 * (std::cos(a) - std::cos(1.1)), 0);
        },
        0.06);
    in["sd2Ellipse"] = [](auto p) { return sq(p.x / 0.9) + sq(p.y / 0.45) < 1; };
    in["sd2Parabola"] = [](auto p) { return p.y + 0.5 > 1.5 * p.x * p.x; };
    in["sd2Bezier"] = nearCurve(
        [](double t) {
            const dvec3 a(-0.8, -0.5, 0), b(0.1, 1.3, 0), c(0.7, -0.4, 0);
            return sq(1 - t) * a + 2 * t * (1 - t) * b + t * t * c;
        },
        0.08);
    // ---- solids ----
    in["sdSphere"] = [](auto p) { return glm::dot(p, p) < 0.49; };
    in["sdPlane"] = [](auto p) { return 0.8 * p.y + 0.6 * p.z < 0.1; };
    in["sdCorner"] = [](auto p) { return p.x < 0 && p.y < 0 && p.z < 0; };
    in["sdBox"] = [](auto p) { return inBox(p, {0.7, 0.4, 0.5}); };
    in["sdRoundedBox"] = [](auto p) { return inRoundedBox(p, {0.7, 0.4, 0.5}, 0.15); };
    in["sdBoxFrame"] = [](auto p) {
        const dvec3 q = glm::abs(p);
        const int edges = (q.x > 0.6) + (q.y > 0.4) + (q.z > 0.5);
        return inBox(p, {0.7, 0.5, 0.6}) && edges >= 2;
    };
    in["sdTorus"] = [](auto p) {
        const double s = glm::dot(p, p) + sq(0.6) - sq(0.22);
        return s * s < 4 * sq(0.6) * (p.x * p.x + p.z * p.z);
    };
    in["sdCappedTorus"] = nearCurve(
        [](double t) {
            const double a = 2.2 * (2 * t - 1);
            return 0.6 * dvec3(std::sin(a), 0, std::cos(a));
        },
        0.18);
    in["sdLink"] = nearCurve(
        [](double t) {
            const double a = kPi2 * std::min(2 * t, 1.0);
            const double y = 0.3 * (1 - 2 * std::max(2 * t - 1, 0.0));
            if (t > 0.5) return dvec3(std::fmod(40000 * t, 2) < 1 ? 0.35 : -0.35, y, 0);
            return dvec3(0.35 * std::cos(a), 0.35 * std::sin(a) + (a < kPi2 / 2 ? 0.3 : -0.3), 0);
        },
        0.14);
    in["sdCylinderInfinite"] = [](auto p) { return radial(p) < 0.5; };
    in["sdCylinder"] = [](auto p) { return radial(p) < 0.5 && std::abs(p.y) < 0.6; };
    in["sdRoundedCylinder"] = [](auto p) {
        return inRoundedBox({radial(p), p.y, 0}, {0.6, 0.5, 1}, 0.15);
    };
    in["sdCylinderBetween"] = [](auto p) {
        const Along c = along(p, {-0.5, -0.4, 0.1}, {0.5, 0.4, -0.1});
        return c.way > 0 && c.way < c.size && c.away < 0.35;
    };
    in["sdTube"] = [](auto p) {
        return radial(p) > 0.47 && radial(p) < 0.63 && std::abs(p.y) < 0.5;
    };
    in["sdDisc"] = [](auto p) {
        const double beyond = std::max(radial(p) - 0.7, 0.0);
        return beyond * beyond + p.y * p.y < sq(0.05);
    };
    in["sdCapsule"] = [](auto p) {
        return inBalls(p, {-0.5, -0.3, 0.1}, {0.5, 0.3, -0.1}, 0.3, 0.3);
    };
    in["sdCapsuleY"] = [](auto p) { return inBalls(p, {0, -0.4, 0}, {0, 0.4, 0}, 0.35, 0.35); };
    in["sdCone"] = [](auto p) {
        return p.y + 0.5 > 0 && radial(p) < 0.6 * (1 - (p.y + 0.5) / 1.1);
    };
    in["sdConeInfinite"] = [](auto p) { return radial(p) < std::tan(0.5) * (0.6 - p.y); };
    in["sdCappedCone"] = [](auto p) {
        return std::abs(p.y) < 0.5 && radial(p) < 0.7 - 0.35 * (p.y + 0.5);
    };
    in["sdCappedConeBetween"] = [](auto p) {
        const Along c = along(p, {-0.5, -0.3, 0.1}, {0.5, 0.4, -0.1});
        return c.way > 0 && c.way < c.size && c.away < 0.5 - 0.3 * c.way / c.size;
    };
    in["sdRoundCone"] = [](auto p) {
        return inBalls(p + dvec3(0, 0.3, 0), dvec3(0), {0, 0.7, 0}, 0.45, 0.2);
    };
    in["sdRoundConeBetween"] = [](auto p) {
        return inBalls(p, {-0.4, -0.3, 0.1}, {0.5, 0.4, -0.1}, 0.4, 0.2);
    };
    in["sdSolidAngle"] = [](auto p) {
        const double y = p.y + 0.4;
        return radial(p) < std::tan(0.6) * y && sq(radial(p)) + y * y < 1;
    };
    in["sdCutSphere"] = [](auto p) { return glm::dot(p, p) < 0.64 && p.y > -0.2; };
    in["sdCutHollowSphere"] = [](auto p) {
        // The skin, and the torus of its rim.
        const double r = glm::length(p), rim = std::sqrt(sq(0.75) - sq(0.2));
        const bool below = p.y / r < 0.2 / 0.75;
        return (below && std::abs(r - 0.75) < 0.05) ||
               sq(radial(p) - rim) + sq(p.y - 0.2) < sq(0.05);
    };
    in["sdDeathStar"] = [](auto p) {
        return glm::dot(p, p) < 0.49 && sq(radial(p)) + sq(p.y - 0.75) > 0.25;
    };
    in["sdVesica"] = [](auto p) { return sq(radial(p) + 0.55) + p.y * p.y < 1; };
    in["sdVesicaBetween"] = [](auto p) {
        const Along c = along(p, {-0.7, -0.4, 0.2}, {0.7, 0.4, -0.2});
        const double tip = c.size / 2, m = (tip * tip - sq(0.35)) / 0.7;
        return sq(c.away + m) + sq(c.way - tip) < sq(0.35 + m);
    };
    in["sdLens"] = [](auto p) { return sq(radial(p)) + sq(std::abs(p.y) + 0.65) < 1; };
    in["sdEgg"] = [](auto p) { return inEgg(radial(p), p.y + 0.15); };
    in["sdEllipsoid"] = in["sdEllipsoidBound"] = [](auto p) {
        return sq(p.x / 0.85) + sq(p.y / 0.45) + sq(p.z / 0.6) < 1;
    };
    in["sdSpheroid"] = [](auto p) { return sq(radial(p) / 0.8) + sq(p.y / 0.4) < 1; };
    in["sdParaboloid"] = [](auto p) { return p.y + 0.6 > 1.5 * sq(radial(p)); };
    in["sdBezier"] = nearCurve(
        [](double t) {
            const dvec3 a(-0.8, -0.5, 0), b(0, 1.2, 0.4), c(0.8, -0.5, 0.2);
            return sq(1 - t) * a + 2 * t * (1 - t) * b + t * t * c;
        },
        0.1);
    in["sdTetrahedron"] =
        planes({{-1, -1, -1}, {-1, 1, 1}, {1, -1, 1}, {1, 1, -1}}, 0.6 / std::sqrt(3));
    in["sdOctahedron"] = [](auto p) { return std::abs(p.x) + std::abs(p.y) + std::abs(p.z) < 0.9; };
    const auto twenty = both(cyclic(kIcosahedralFace), cyclic(dvec3(1, 1, 1)));
    // The library's fold has the two-fold axes on x, y, z: 12 faces at (1, 0, phi) and 20 at
    // (0, 1, phi^2) and (1, 1, 1).
    in["sdDodecahedron"] = planes(cyclic(kDodecahedralFace), 0.7);
    in["sdFacetInCone"] = in["sdDodecahedron"];
    in["sdIcosahedron"] = planes(twenty, 0.7);
    in["sdTruncatedIcosahedron"] =
        [a = planes(twenty, 0.7), b = planes(cyclic(kDodecahedralFace), 0.7 * 1.0275766)](auto p) {
            return a(p) && b(p);
        };
    in["sdRhombicDodecahedron"] = planes(cyclic(dvec3(1, 1, 0)), 0.6);
    in["sdTruncatedOctahedron"] = [](auto p) {
        const dvec3 q = glm::abs(p);
        return inBox(p, dvec3(0.75)) && q.x + q.y + q.z < 1.5 * 0.75;
    };
    // Flat things: every point of them is tried.
    in["sdTriangle"] = [](auto p) {
        const dvec3 a(-0.7, -0.4, 0.2), b(0.8, -0.3, 0), c(0, 0.7, -0.3);
        for (int i = 0; i <= 150; ++i)
            for (int j = 0; i + j <= 150; ++j) {
                const dvec3 d = p - (a + (b - a) * (i / 150.0) + (c - a) * (j / 150.0));
                if (glm::dot(d, d) < sq(0.05)) return true;
            }
        return false;
    };
    in["sdQuad"] = [](auto p) {
        const dvec3 a(-0.7, -0.4, 0.2), b(0.8, -0.4, 0.2), c(0.5, 0.6, -0.3), d(-0.5, 0.6, -0.3);
        for (int i = 0; i <= 150; ++i)
            for (int j = 0; j <= 150; ++j) {
                const double s = i / 150.0, t = j / 150.0;
                const dvec3 away = p - glm::mix(glm::mix(a, b, s), glm::mix(d, c, s), t);
                if (glm::dot(away, away) < sq(0.05)) return true;
            }
        return false;
    };
    in["sdPyramid"] = [](auto p) {
        const double y = p.y + 0.45, half = 0.65 * (1 - y);
        return y > 0 && y < 1 && std::abs(p.x) < half && std::abs(p.z) < half;
    };
    in["sdPrism"] = [flat = in["sd2Polygon"]](auto p) {
        return std::abs(p.y) < 0.4 && flat({p.x, p.z, 0});
    };
    in["sdTriangularPrism"] = [](auto p) {
        return std::abs(p.y) < 0.5 &&
               inPolygon({p.x, p.z},
                         {{-0.4 * std::sqrt(3), -0.4}, {0.4 * std::sqrt(3), -0.4}, {0, 0.8}});
    };
    in["sdHexagonalPrism"] = [](auto p) {
        const double side = std::sqrt(0.75);
        return std::abs(p.y) < 0.4 && std::abs(p.z) < 0.6 &&
               side * std::abs(p.x) + 0.5 * std::abs(p.z) < 0.6;
    };
    in["sdRhombus"] = [](auto p) {
        // A rhombic plate, and all within the radius of its edges: by the nearest of many points.
        for (int i = 0; i <= 300; ++i)
            for (int j = 0; j <= 60; ++j) {
                const double x = 0.8 * (i / 150.0 - 1), y = 0.5 * (1 - std::abs(x) / 0.8);
                const dvec3 c(x, glm::clamp(p.y, -y, y), 0.15 * (j / 30.0 - 1));
                if (glm::dot(p - c, p - c) < sq(0.08)) return true;
            }
        return false;
    };
    return in;
}

}  // namespace vitrine
