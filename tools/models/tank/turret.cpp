// SPDX-License-Identifier: MIT
// The casting is a skin over rings. A ring is a superellipse with a front and a rear half of
// different length (Lamé 1818); the rear of the lower rings is lifted, which makes the bustle.
#include "models/tank/turret.hpp"

#include <cmath>

#include "models/tank/layout.hpp"
#include "models/tank/polyhedron.hpp"
#include "models/tank/round.hpp"

namespace vitrine::tank {
namespace {

struct Ring {
    double y, lift;            // height in front, and how much higher the rear is
    double front, rear, side;  // half axes
    double square;             // exponent: 2 is an ellipse
};

constexpr std::array kRings = {
    Ring{0.000, 0.00, 0.96, 0.96, 0.96, 2.0},  Ring{0.045, 0.00, 0.98, 0.98, 0.98, 2.0},
    Ring{0.075, 0.05, 1.02, 1.16, 1.03, 2.15}, Ring{0.110, 0.09, 1.09, 1.42, 1.08, 2.4},
    Ring{0.165, 0.08, 1.15, 1.62, 1.125, 2.6}, Ring{0.240, 0.05, 1.185, 1.72, 1.15, 2.7},
    Ring{0.320, 0.03, 1.185, 1.75, 1.14, 2.7}, Ring{0.410, 0.01, 1.14, 1.74, 1.10, 2.7},
    Ring{0.500, 0.00, 1.06, 1.70, 1.035, 2.7}, Ring{0.580, 0.00, 0.95, 1.63, 0.95, 2.7},
    Ring{0.645, 0.00, 0.82, 1.54, 0.85, 2.7},  Ring{0.690, 0.00, 0.70, 1.43, 0.74, 2.6},
    Ring{0.714, 0.00, 0.55, 1.22, 0.58, 2.5},  Ring{0.726, 0.00, 0.30, 0.70, 0.32, 2.3},
    Ring{0.730, 0.00, 0.00, 0.00, 0.00, 2.0}};

std::vector<Vec3> ringPoints(const Ring& ring) {
    constexpr int kSides = 42;
    std::vector<Vec3> points;
    for (int i = 0; i < kSides; ++i) {
        const double angle = kTau * i / kSides;
        const double c = std::cos(angle), s = std::sin(angle);
        const auto bent = [&ring](double v) {
            return std::copysign(std::pow(std::abs(v), 2.0 / ring.square), v);
        };
        const double x = bent(c) * (c > 0.0 ? ring.front : ring.rear);
        // Narrower towards the gun and, less so, towards the rear.
        const double taper = x > 0.0 ? 1.0 - 0.12 * x * x : 1.0 - 0.055 * x * x;
        const double rear = glm::smoothstep(0.2, 1.3, -x);
        const double square = ring.square > 2.05 ? taper : 1.0;
        points.emplace_back(x, ring.y + ring.lift * rear, bent(s) * ring.side * square);
    }
    return points;
}

/// Two discs that hold the trunnions, and lips above and below the mantlet.
void addMantletRing(Solid& body) {
    constexpr double kRadius = 0.335;
    std::vector<Vec2> cheek{{0.62, 0.03}};
    for (int i = -5; i <= 5; ++i) {
        const double angle = 0.36 * i;
        cheek.emplace_back(kGunInTurret.x + kRadius * std::cos(angle),
                           kGunInTurret.y + kRadius * std::sin(angle));
    }
    cheek.emplace_back(0.62, 0.66);
    body.appendBothSides(bevelled(prism(cheek, 0.432, 0.545), 0.024, Material::kPaint));
    body.append(
        bevelled(prism({{0.70, 0.03}, {1.17, 0.045}, {1.19, 0.085}, {0.70, 0.12}}, -0.50, 0.50),
                 0.012, Material::kPaint));
    body.append(
        bevelled(prism({{0.50, 0.64}, {1.02, 0.700}, {1.04, 0.730}, {0.52, 0.735}}, -0.46, 0.46),
                 0.010, Material::kPaint));
}

}  // namespace

Assembly makeTurret() {
    Assembly turret{"turret", kTurretInHull, {}, {}};
    std::vector<std::vector<Vec3>> rings;
    for (const Ring& ring : kRings) rings.push_back(ringPoints(ring));
    Solid body = skinned(rings, Material::kPaint);
    addMantletRing(body);
    turret.add(body, {Mat4(1.0)}, 1.1, Finish::kCast);

    std::vector<Mat4> bolts;
    for (const double side : {1.0, -1.0})
        for (int i = 0; i < 5; ++i) {
            const double angle = 0.5 * (i - 2.0);
            bolts.push_back(standing({kGunInTurret.x + 0.27 * std::cos(angle),
                                      kGunInTurret.y + 0.27 * std::sin(angle), side * 0.544},
                                     {0, 0, side}));
        }
    for (int i = 0; i < 7; ++i)
        bolts.push_back(standing({0.92, 0.722, -0.39 + 0.13 * i}, {-0.03, 1, 0}));
    turret.add(hexBolt(0.018, 0.016, Material::kSteel), bolts, 0.8);

    addTurretFittings(turret);
    addTurretStowage(turret);

    // The casting's seam, where the halves of the mould met, and the roof that is welded in.
    Marks& marks = turret.marks;
    const std::vector<Vec3> seam = ringPoints({0.280, 0.040, 1.187, 1.737, 1.147, 2.7});
    for (size_t i = 0; i < seam.size(); ++i)
        marks.line(MarkKind::kWeld, {seam[i], seam[(i + 1) % seam.size()]}, 0.011);
    const std::vector<Vec3> roof = ringPoints({0.702, 0.0, 0.63, 1.33, 0.66, 2.55});
    for (size_t i = 0; i < roof.size(); ++i)
        marks.line(MarkKind::kWeld, {roof[i], roof[(i + 1) % roof.size()]}, 0.014);
    marks.letterings.push_back({"217", {0.08, 0.33, 1.12}, {0.05, 0.12, 1}, 0.21});
    marks.letterings.push_back({"217", {0.08, 0.33, -1.12}, {0.05, 0.12, -1}, 0.21});
    return turret;
}

}  // namespace vitrine::tank
