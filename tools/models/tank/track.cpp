// SPDX-License-Identifier: MIT
#include "models/tank/track.hpp"

#include <algorithm>
#include <cmath>

#include "models/tank/layout.hpp"
#include "models/tank/polyhedron.hpp"
#include "models/tank/round.hpp"

namespace vitrine::tank {
namespace {

/// What the pins run around.
struct Support {
    Vec2 centre;
    double radius;
    bool hangsOn;  // the track hangs freely from here to the next
};

std::vector<Support> supports() {
    std::vector<Support> list{{kSprocketAt, kSprocketRadius, true}};
    for (size_t i = kRollerX.size(); i-- > 0;)
        list.push_back({{kRollerX[i], kRollerY}, kRollerRadius + kLinkInside, true});
    list.push_back({kIdlerAt, kIdlerRadius + kLinkInside, false});
    for (const double x : kWheelX)
        list.push_back({{x, kWheelY}, kWheelRadius + kLinkInside, false});
    return list;
}

/// Where the track leaves one support and comes to the next, as directions from their centres.
struct Span {
    Vec2 leave, arrive;
};

Span tangent(const Support& a, const Support& b) {
    const Vec2 d = glm::normalize(b.centre - a.centre);
    const double sine = (a.radius - b.radius) / glm::distance(a.centre, b.centre);
    const Vec2 normal = std::sqrt(1.0 - sine * sine) * Vec2(-d.y, d.x) + sine * d;
    return {normal, normal};
}

/// y = cosh(k (x - lowest)) / k from `from` to `to`.
struct Catenary {
    double k, lowest;

    Catenary(double bend, const Vec2& from, const Vec2& to) : k(bend) {
        const double width = to.x - from.x;
        lowest = from.x + 0.5 * width -
                 std::asinh(k * (to.y - from.y) / (2.0 * std::sinh(0.5 * k * width))) / k;
    }
    [[nodiscard]] double y(double x) const { return std::cosh(k * (x - lowest)) / k; }
    [[nodiscard]] double slope(double x) const { return std::sinh(k * (x - lowest)); }
};

/// The bend at the lowest point, the same for all spans because the pull is.
double bend() {
    const double width = kRollerX[0] - kRollerX[1];
    return 8.0 * kSag / (width * width);
}

Span hanging(const Support& a, const Support& b) {
    Span span = tangent(a, b);
    const auto across = [](double slope) { return glm::normalize(Vec2(-slope, 1.0)); };
    // The ends and the slope depend on each other; this converges to a nanometre.
    for (int i = 0; i < 30; ++i) {
        const Vec2 from = a.centre + a.radius * span.leave, to = b.centre + b.radius * span.arrive;
        const Catenary curve(bend(), from, to);
        span = {across(curve.slope(from.x)), across(curve.slope(to.x))};
    }
    return span;
}

/// The closed curve as points that are so close that straight pieces will do.
class Loop {
  public:
    Loop() {
        const std::vector<Support> list = supports();
        const size_t n = list.size();
        std::vector<Span> spans;
        for (size_t i = 0; i < n; ++i) {
            const Support &a = list[i], &b = list[(i + 1) % n];
            spans.push_back(a.hangsOn ? hanging(a, b) : tangent(a, b));
        }
        for (size_t i = 0; i < n; ++i) {
            addArc(list[i], spans[(i + n - 1) % n].arrive, spans[i].leave);
            const Support& next = list[(i + 1) % n];
            addSpan(list[i].centre + list[i].radius * spans[i].leave,
                    next.centre + next.radius * spans[i].arrive, list[i].hangsOn);
        }
        points_.push_back(points_.front());
        along_.push_back(0.0);
        for (size_t i = 1; i < points_.size(); ++i)
            along_.push_back(along_.back() + glm::distance(points_[i - 1], points_[i]));
    }
    [[nodiscard]] double length() const { return along_.back(); }
    [[nodiscard]] Vec2 at(double s) const {
        s -= length() * std::floor(s / length());
        const auto above = std::upper_bound(along_.begin(), along_.end() - 1, s);
        const auto i = std::max<size_t>(1, static_cast<size_t>(above - along_.begin()));
        const double t = (s - along_[i - 1]) / (along_[i] - along_[i - 1]);
        return glm::mix(points_[i - 1], points_[i], t);
    }
    /// The first place after `s` that is `chord` away from it in a straight line.
    [[nodiscard]] double step(double s, double chord) const {
        const Vec2 from = at(s);
        double low = s + 0.9 * chord, high = s + 1.3 * chord;
        for (int i = 0; i < 48; ++i) {
            const double middle = 0.5 * (low + high);
            (glm::distance(from, at(middle)) < chord ? low : high) = middle;
        }
        return low;
    }

  private:
    static constexpr double kFine = 0.004;

    void addArc(const Support& around, const Vec2& from, const Vec2& to) {
        const double start = std::atan2(from.y, from.x);
        double turn = start - std::atan2(to.y, to.x);
        turn -= kTau * std::floor(turn / kTau);
        if (turn > kTau - 1e-9) turn = 0.0;
        const int steps = static_cast<int>(turn * around.radius / kFine) + 1;
        for (int i = 0; i < steps; ++i) {
            const double angle = start - turn * i / steps;
            points_.push_back(around.centre +
                              around.radius * Vec2(std::cos(angle), std::sin(angle)));
        }
    }
    void addSpan(const Vec2& from, const Vec2& to, bool hangs) {
        const int steps = static_cast<int>(glm::distance(from, to) / kFine) + 1;
        for (int i = 0; i < steps; ++i) {
            Vec2 p = glm::mix(from, to, double(i) / steps);
            if (hangs) {
                const Catenary curve(bend(), from, to);
                p.y = from.y + curve.y(p.x) - curve.y(from.x);
            }
            points_.push_back(p);
        }
    }

    std::vector<Vec2> points_;
    std::vector<double> along_;
};

}  // namespace

namespace {

const Loop& loop() {
    static const Loop curve;
    return curve;
}

/// From the first pin, `start` along the curve, over all links. Returns how far that leads.
double walk(double start, double pitch, std::vector<double>* along = nullptr) {
    const int links = static_cast<int>(std::lround(loop().length() / kPitch));
    double s = start;
    for (int i = 0; i < links; ++i) {
        if (along) along->push_back(s);
        s = loop().step(s, pitch);
    }
    return s - start;
}

/// The chord with which the links close the curve.
double closingPitch(double start) {
    double low = 0.95 * kPitch, high = 1.05 * kPitch;
    for (int i = 0; i < 48; ++i) {
        const double middle = 0.5 * (low + high);
        (walk(start, middle) < loop().length() ? low : high) = middle;
    }
    return low;
}

}  // namespace

double trackPitch() {
    static const double pitch = closingPitch(0.0);
    return pitch;
}

std::vector<Vec2> trackPins(double drive) {
    // After one pitch every pin is where the next one was: exactly, or the loop would jump.
    static const double firstStep = loop().step(0.0, trackPitch());
    const double rounds = drive / trackPitch();
    const double start = (rounds - std::floor(rounds)) * firstStep;
    std::vector<double> along;
    walk(start, closingPitch(start), &along);
    std::vector<Vec2> pins;
    for (const double s : along) pins.push_back(loop().at(s));
    return pins;
}

std::vector<Mat4> linkPlaces(const std::vector<Vec2>& pins, double side) {
    std::vector<Mat4> places;
    for (size_t i = 0; i < pins.size(); ++i) {
        const Vec2 &a = pins[i], &b = pins[(i + 1) % pins.size()];
        const Vec2 x = glm::normalize(b - a), middle = 0.5 * (a + b);
        places.push_back({glm::dvec4(x, 0, 0), glm::dvec4(-x.y, x.x, 0, 0), glm::dvec4(0, 0, 1, 0),
                          glm::dvec4(middle, side * kTrackZ, 1)});
    }
    return places;
}

double sprocketAngle(const std::vector<Vec2>& pins) {
    size_t rear = 0;
    for (size_t i = 0; i < pins.size(); ++i)
        if (pins[i].x < pins[rear].x) rear = i;
    const Vec2 middle = 0.5 * (pins[rear] + pins[(rear + 1) % pins.size()]) - kSprocketAt;
    return std::atan2(middle.y, middle.x);
}

Solid makeLink() {
    constexpr double kPinRadius = 0.017, kHalf = 0.5 * kPitch;
    Solid link;
    link.append(
        softBar({-0.0665, -kLinkInside, -0.215}, {0.0665, 0.026, 0.215}, 0.013, Material::kTrack));
    link.append(bentTube({{kHalf, 0, -0.27}, {kHalf, 0, 0.27}},
                         {kPinRadius, 5, false, Material::kSteel, true}));
    const std::vector<Vec2> connector{{kHalf - 0.056, 0},      {kHalf - 0.030, -0.030},
                                      {kHalf + 0.030, -0.030}, {kHalf + 0.056, 0},
                                      {kHalf + 0.030, 0.030},  {kHalf - 0.030, 0.030}};
    link.appendBothSides(bevelled(prism(connector, 0.254, 0.285), 0.0, Material::kTrack));
    // Pads and horn sink into the link: they have no undersides.
    const auto frustum = [&link](Material material, const Vec2& foot, double footY, const Vec2& top,
                                 double topY, double z) {
        std::array<Vec3, 8> p;
        for (size_t i = 0; i < 4; ++i) {
            const double x = i == 0 || i == 3 ? -1.0 : 1.0, side = i < 2 ? -1.0 : 1.0;
            p[i] = {x * foot.x, footY, z + side * foot.y};
            p[4 + i] = {x * top.x, topY, z + side * top.y};
        }
        const auto face = [&](size_t i, size_t j, size_t k, size_t l, const Vec3& out) {
            Vec3 normal = glm::normalize(glm::cross(p[k] - p[i], p[l] - p[j]));
            if (glm::dot(normal, out) < 0.0) normal = -normal;
            link.quad(material, {p[i], normal}, {p[j], normal}, {p[k], normal}, {p[l], normal});
        };
        face(0, 1, 5, 4, {0, 0, -1});
        face(1, 2, 6, 5, {1, 0, 0});
        face(2, 3, 7, 6, {0, 0, 1});
        face(3, 0, 4, 7, {-1, 0, 0});
        face(4, 5, 6, 7, {0, topY - footY, 0});
    };
    for (const double z : {0.1085, -0.1085})
        frustum(Material::kRubber, {0.058, 0.0965}, 0.020, {0.046, 0.0845}, kLinkOutside, z);
    frustum(Material::kTrack, {0.045, 0.028}, -0.026, {0.020, 0.014}, -0.100, 0.0);
    return link;
}

}  // namespace vitrine::tank
