// SPDX-License-Identifier: MIT
// A closed curve turns about the z axis and grows exponentially while it does so. Its shape stays
// the same, so ribs at equal angles become finer towards the apex by themselves.
// Source: Raup, "Geometric analysis of shell coiling", Journal of Paleontology 40(5), 1966.
//
// The surface is one sheet without holes: it starts at the apex, runs along the outside to the lip,
// around it, back along the inside and ends in the dome that closes the chamber. `along` counts
// these five stretches from 0 to 5, `around` is the angle on the generating curve: 0 is the outer
// side of the spiral (the venter), pi the side that lies on the turn before (the dorsum).
#include "models/ammonite.hpp"

#include <algorithm>
#include <cmath>

namespace vitrine {
namespace {

constexpr double kTau = 6.283185307179586;

// Lengths are in units of the generating curve's half height at the opening.
constexpr double kExpansion = 2.25;  // size after one turn; more opens the spiral faster
constexpr double kTurns = 5.0;
constexpr double kWidth = 0.98;       // across the spiral; less is flatter
constexpr double kSquareness = 2.35;  // 2 is round
constexpr double kImpression = 0.45;  // of the dorsum, which embraces the turn before
constexpr double kCentre = 1.93;      // distance of the axis; the turns just clear each other
constexpr double kForward = 0.20;     // radians by which ribs and lip lead at the venter
constexpr double kRibsPerTurn = 24.0;
constexpr double kRibHeight = 0.085;
constexpr double kKnobHeight = 0.09;  // on top of each rib, at the shoulders
constexpr double kKnobAt = 0.92;      // radians from the venter
constexpr double kFlare = 0.50;
constexpr double kFlareAngle = 0.80;  // radians before the lip at which the flare begins
constexpr double kWall = 0.05;
constexpr double kLipWall = 0.17;
constexpr double kChamberTurns = 0.36;
constexpr double kHeight = 1.6;  // metres
constexpr double kPose = -0.98;  // radians; direction of the lip from the centre

const double kGrowth = std::log(kExpansion) / kTau;

double smoothstep(double low, double high, double x) {
    const double s = std::clamp((x - low) / (high - low), 0.0, 1.0);
    return s * s * (3.0 - 2.0 * s);
}

double bell(double x, double width) {
    return std::exp(-(x / width) * (x / width));
}

/// 1 at the venter, 0 at the dorsum.
double ventral(double around) {
    return 0.5 + 0.5 * std::cos(around);
}

/// The generating curve: (radial, axial), with the ribs' share `rib` from 0 to 1.
glm::dvec2 section(double around, double rib) {
    const double c = std::cos(around), s = std::sin(around);
    const double n = kSquareness;
    const double round = std::pow(std::pow(std::abs(c), n) + std::pow(std::abs(s), n), -1.0 / n);
    const double angle = std::acos(std::clamp(c, -1.0, 1.0));
    const double height =
        kRibHeight * smoothstep(0.04, 0.5, ventral(around)) * (1.0 - 0.45 * bell(angle, 0.42)) +
        kKnobHeight * bell(angle - kKnobAt, 0.20);
    const double size = round * (1.0 + rib * height);
    return {size * c + kImpression * std::pow(1.0 - ventral(around), 10.0), size * kWidth * s};
}

double ribAt(double turnAngle) {
    const double wave = 0.5 + 0.5 * std::cos(turnAngle / kTau * kRibsPerTurn * kTau);
    const double young = smoothstep(-kTau * kTurns, -kTau * (kTurns - 0.7), turnAngle);
    return std::pow(wave, 1.5) * young * (1.0 - smoothstep(-0.45, -0.15, turnAngle));
}

/// The middle of the wall as (angle, size of the generating curve), and half its thickness.
struct Wall {
    double angle, size, half;
};

Wall wallAt(double angle, double around) {
    const double toLip = std::clamp(1.0 + angle / kFlareAngle, 0.0, 1.0);
    const double half = 0.5 * (kWall + (kLipWall - kWall) * toLip * toLip);
    const double flare = kFlare * std::pow(ventral(around), 1.2) * std::pow(toLip, 4.0);
    return {angle, 1.0 - half + flare, half};
}

/// The wall's direction at `angle` as (forward, outward), unit length in the units of the curve.
glm::dvec2 wallDirection(double angle, double around, double radius) {
    constexpr double kStep = 1e-4;
    const double rise = wallAt(angle, around).size - wallAt(angle - kStep, around).size;
    return glm::normalize(glm::dvec2(kStep * radius, rise));
}

/// Where `along` lies on the unrolled outline: angle, size, rib.
struct Outline {
    double angle, size, rib;
};

Outline outlineAt(double along, double around) {
    const double radius = kCentre + section(around, 0.0).x;
    const double start = -kTau * kTurns, chamberEnd = -kTau * kChamberTurns;
    if (along < 1.0) {
        const double turn = 0.25 * kTau * along;
        return {start - std::cos(turn) / kCentre, std::sin(turn), 0.0};
    }
    if (along >= 4.0) {
        const Wall wall = wallAt(chamberEnd, around);
        const double turn = 0.25 * kTau * (along - 4.0);
        return {chamberEnd - 0.45 * std::sin(turn) / kCentre,
                (wall.size - wall.half) * std::cos(turn), 0.0};
    }
    // Both sides of the wall stand off its middle at right angles, and the lip is a half circle.
    const double angle = along < 2.0   ? start * (2.0 - along)
                         : along < 3.0 ? 0.0
                                       : chamberEnd * (along - 3.0);
    const double turn = along < 2.0 ? 0.0 : along < 3.0 ? 0.5 * kTau * (along - 2.0) : 0.5 * kTau;
    const Wall wall = wallAt(angle, around);
    const glm::dvec2 forward = wallDirection(angle, around, radius);
    const glm::dvec2 outward(-forward.y, forward.x);
    const glm::dvec2 off = wall.half * (std::cos(turn) * outward + std::sin(turn) * forward);
    return {angle + off.x / radius, wall.size + off.y, along < 2.0 ? ribAt(angle) : 0.0};
}

/// Raup's rule, before the shell is put on the floor.
glm::dvec3 surface(double along, double around) {
    const Outline at = outlineAt(along, around);
    const glm::dvec2 curve = section(around, at.rib) * at.size;
    const double lead = kForward * (smoothstep(0.0, 1.0, ventral(around)) - 0.5);
    const double angle = at.angle + lead * std::min(1.0, at.size);
    const double scale = std::exp(kGrowth * angle);
    const double turned = angle + kPose;
    const double r = scale * (kCentre + curve.x);
    return {r * std::cos(turned), r * std::sin(turned), scale * curve.y};
}

glm::dvec3 normalAt(double along, double around) {
    constexpr double kStep = 1e-5;
    const double low = std::max(along - kStep, 0.0), high = std::min(along + kStep, 5.0);
    const glm::dvec3 forward = surface(high, around) - surface(low, around);
    const glm::dvec3 sideward = surface(along, around + kStep) - surface(along, around - kStep);
    return glm::normalize(glm::cross(forward, sideward));
}

/// The apex and the middle of the dome are points: the mean of the normals close by.
glm::dvec3 normalAtPole(double along) {
    const double near = along < 1.0 ? 1e-3 : 5.0 - 1e-3;
    glm::dvec3 sum(0.0);
    for (int i = 0; i < 64; ++i) sum += normalAt(near, kTau * i / 64.0);
    return glm::normalize(sum);
}

struct Ring {
    double along;
    uint32_t sides;
    uint32_t part;  // of the band that begins here
};

enum Part : uint32_t { kShell, kLip, kChamber };

std::vector<Ring> rings() {
    constexpr uint32_t kFine = 56, kMiddle = 28, kCoarse = 14;
    std::vector<Ring> list;
    const auto add = [&list](double from, double to, int steps, uint32_t sides, Part part) {
        for (int i = 0; i < steps; ++i)
            list.push_back({from + (to - from) * i / steps, sides, part});
    };
    // Steps per rib are whole numbers, so that every crest and every valley has its ring.
    const auto addTurns = [&add](double from, double to, int stepsPerRib, uint32_t sides) {
        const int ribs = static_cast<int>(std::lround((from - to) * kRibsPerTurn));
        add(2.0 - from / kTurns, 2.0 - to / kTurns, ribs * stepsPerRib, sides, kShell);
    };
    add(0.0, 1.0, 5, kCoarse, kShell);
    addTurns(kTurns, 3.25, 4, kCoarse);
    addTurns(3.25, 1.25, 4, kMiddle);
    addTurns(1.25, 0.0, 6, kFine);
    add(2.0, 3.0, 10, kFine, kLip);
    add(3.0, 4.0, 36, kFine, kChamber);
    add(4.0, 5.0, 10, kFine, kChamber);
    list.push_back({5.0, kFine, kChamber});
    return list;
}

/// One row of vertices, its first repeated at the end with the other end of the texture.
void addRing(Mesh& mesh, const Ring& ring) {
    const bool pole = ring.along == 0.0 || ring.along == 5.0;
    for (uint32_t i = 0; i <= ring.sides; ++i) {
        const double around = kTau * (i % ring.sides) / ring.sides;
        const glm::dvec3 normal = pole ? normalAtPole(ring.along) : normalAt(ring.along, around);
        // Lengths along and around grow alike, so textures keep their proportions.
        const double v = outlineAt(ring.along, 0.0).angle / kTau * kCentre;
        mesh.positions.emplace_back(surface(ring.along, pole ? 0.0 : around));
        mesh.normals.emplace_back(normal);
        mesh.uvs.emplace_back(double(i) / ring.sides, v);
    }
}

/// Joins two rows; the upper may have twice as many sides as the lower.
void addBand(Mesh& mesh, uint32_t lower, const Ring& from, uint32_t upper, const Ring& to) {
    const auto add = [&](uint32_t a, uint32_t b, uint32_t c) {
        mesh.triangles.emplace_back(a, b, c);
        mesh.triangleParts.push_back(from.part);
    };
    const uint32_t ratio = to.sides / from.sides;
    for (uint32_t i = 0; i < from.sides; ++i) {
        const uint32_t a = lower + i, b = a + 1;
        const uint32_t c = upper + ratio * i, d = c + ratio;
        if (from.along == 0.0) {
            add(a, c, d);
        } else if (to.along == 5.0) {
            add(a, c, b);
        } else if (ratio == 2) {
            add(a, c, c + 1);
            add(a, c + 1, b);
            add(b, c + 1, d);
        } else {
            add(a, c, d);
            add(a, d, b);
        }
    }
}

void standOnFloor(Mesh& mesh) {
    const Aabb box = bounds(mesh);
    const float scale = static_cast<float>(kHeight) / box.extent().y;
    const glm::vec3 foot(box.centre().x, box.min.y, box.centre().z);
    for (glm::vec3& p : mesh.positions) p = (p - foot) * scale;
}

}  // namespace

Mesh makeAmmonite() {
    Mesh mesh;
    mesh.name = "ammonite";
    mesh.partNames = {"shell", "lip", "chamber"};
    const std::vector<Ring> list = rings();
    uint32_t last = 0;
    for (size_t i = 0; i < list.size(); ++i) {
        const auto start = static_cast<uint32_t>(mesh.positions.size());
        addRing(mesh, list[i]);
        if (i > 0) addBand(mesh, last, list[i - 1], start, list[i]);
        last = start;
    }
    standOnFloor(mesh);
    return mesh;
}

}  // namespace vitrine
