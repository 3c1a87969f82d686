// SPDX-License-Identifier: MIT
#include "models/tank/textures.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "models/tank/edges.hpp"
#include "models/tank/surface.hpp"
#include "models/tank/texels.hpp"

namespace vitrine::tank {
namespace {

/// More copies than this share one colour, because no patch of camouflage would meet the next.
constexpr size_t kMostCamouflaged = 1;

uint8_t toByte(double v) {
    return static_cast<uint8_t>(std::lround(255.0 * std::clamp(v, 0.0, 1.0)));
}

uint8_t toSrgb(double v) {
    return toByte(v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1.0 / 2.4) - 0.055);
}

void set(ImageRgba8& image, int x, int y, uint8_t r, uint8_t g, uint8_t b) {
    const auto pixel = image.at(x, y);
    pixel[0] = r;
    pixel[1] = g;
    pixel[2] = b;
    pixel[3] = 255;
}

/// Where a part is for its texture: at its first copy, but what rolls is at the mean height of all.
Mat4 representative(const Part& part, const Vec3& origin) {
    Mat4 place = moved(origin) * part.places[0];
    if (part.finish != Finish::kRolls) return place;
    double height = 0.0;
    for (const Mat4& each : part.places) height += each[3].y / double(part.places.size());
    place[3].y = height;
    return place;
}

class Painter {
  public:
    Painter(const Assembly& assembly, const Atlas& atlas, const Occluder& occluder)
        : assembly_(assembly),
          atlas_(atlas),
          grid_(spread(assembly, atlas)),
          occlusion_(bakeOcclusion(assembly, atlas, grid_, occluder)),
          marks_(assembly.marks),
          heights_(grid_.texels.size(), 0.0f) {
        for (const Part& part : assembly.parts) {
            edges_.push_back(std::make_unique<OuterEdges>(part.solid));
            places_.push_back(representative(part, assembly.origin));
        }
        const int side = atlas.side;
        for (ImageRgba8* image : {&out_.albedo, &out_.normal, &out_.orm, &out_.glossMetal})
            *image = ImageRgba8(side, side);
    }

    Textures run() {
        const int side = atlas_.side;
        tbb::parallel_for(0, side, [this, side](int y) {
            for (int x = 0; x < side; ++x)
                if (grid_.at(x, y).chart != Texel::kEmpty) paint(x, y);
        });
        tbb::parallel_for(0, side, [this, side](int y) {
            for (int x = 0; x < side; ++x)
                if (grid_.at(x, y).chart != Texel::kEmpty) bend(x, y);
        });
        fillGutters();
        return std::move(out_);
    }

  private:
    [[nodiscard]] size_t index(int x, int y) const {
        return static_cast<size_t>(y) * static_cast<size_t>(grid_.side) + static_cast<size_t>(x);
    }

    void paint(int x, int y) {
        const Texel& texel = grid_.at(x, y);
        const uint32_t number = atlas_.charts[texel.chart].part;
        const Part& part = assembly_.parts[number];
        const Vec3 local(texel.local);
        const Vec3 inTank = Vec3(places_[number] * glm::dvec4(local, 1.0));
        const Vec3 at = inTank - assembly_.origin;
        SurfacePoint point;
        point.rolls = part.finish == Finish::kRolls;
        point.at = point.rolls ? local : at;
        point.inTank = inTank;
        // The height that decides about mud must not turn with a wheel.
        point.height = point.rolls ? places_[number][3].y : inTank.y;
        point.normal = glm::normalize(glm::dmat3(places_[number]) * Vec3(texel.normal));
        point.material = part.solid.triangles[texel.triangle].material;
        point.camouflaged = part.places.size() <= kMostCamouflaged;
        point.edge = edges_[number]->distance(local);
        point.open = occlusion_.open[index(x, y)];
        point.crevice = occlusion_.crevice[index(x, y)];
        if (part.places.size() == 1) {
            point.marked = marks_.at(at);
            point.letterings = assembly_.marks.letterings;
        }
        const Look look = lookAt(point);
        const bool cast = part.finish == Finish::kCast;
        heights_[index(x, y)] = static_cast<float>(point.marked.height + look.lump +
                                                   grain(point.material, cast, point.at));
        set(out_.albedo, x, y, toSrgb(look.colour.x), toSrgb(look.colour.y), toSrgb(look.colour.z));
        set(out_.orm, x, y, toByte(point.open), toByte(look.roughness), toByte(look.metal));
        set(out_.glossMetal, x, y, toByte(1.0 - look.roughness), toByte(look.metal), 0);
    }

    /// The height's slope along an axis of the square, in metres a metre of the chart.
    [[nodiscard]] double slope(int x, int y, int dx, int dy) const {
        const uint32_t chart = grid_.at(x, y).chart;
        const auto reaches = [&](int sign) {
            const int u = x + sign * dx, v = y + sign * dy;
            return u >= 0 && v >= 0 && u < grid_.side && v < grid_.side &&
                   grid_.at(u, v).chart == chart;
        };
        const int ahead = reaches(1) ? 1 : 0, back = reaches(-1) ? 1 : 0;
        if (ahead + back == 0) return 0.0;
        const double rise = double(heights_[index(x + ahead * dx, y + ahead * dy)]) -
                            double(heights_[index(x - back * dx, y - back * dy)]);
        return rise * atlas_.charts[chart].scale / (ahead + back);
    }

    void bend(int x, int y) {
        const Texel& texel = grid_.at(x, y);
        const Chart& chart = atlas_.charts[texel.chart];
        // Slanted to the chart, a texel is longer on the surface.
        const Vec3 normal(texel.normal);
        const auto length = [&](const Vec3& axis) {
            const double facing = std::max(0.3, std::abs(glm::dot(normal, chart.out)));
            const double lean = glm::dot(normal, axis) / facing;
            return std::sqrt(1.0 + lean * lean);
        };
        const Vec3 u = chart.onSide ? -chart.down : chart.right;
        const Vec3 v = chart.onSide ? -chart.right : -chart.down;
        const Vec3 n = glm::normalize(
            Vec3(-slope(x, y, 1, 0) / length(u), slope(x, y, 0, 1) / length(v), 1.0));
        set(out_.normal, x, y, toByte(0.5 + 0.5 * n.x), toByte(0.5 + 0.5 * n.y),
            toByte(0.5 + 0.5 * n.z));
    }

    /// Grows the charts' rims over the empty texels between them, for filters that look aside.
    void fillGutters() {
        constexpr int kSteps = 6;
        std::vector<bool> filled(grid_.texels.size());
        for (size_t i = 0; i < filled.size(); ++i)
            filled[i] = grid_.texels[i].chart != Texel::kEmpty;
        for (int step = 0; step < kSteps; ++step) {
            std::vector<bool> next = filled;
            for (int y = 0; y < grid_.side; ++y)
                for (int x = 0; x < grid_.side; ++x)
                    if (!filled[index(x, y)]) next[index(x, y)] = copyFromNeighbour(x, y, filled);
            filled = std::move(next);
        }
        for (int y = 0; y < grid_.side; ++y)
            for (int x = 0; x < grid_.side; ++x)
                if (!filled[index(x, y)]) {
                    set(out_.albedo, x, y, 82, 88, 54);
                    set(out_.normal, x, y, 128, 128, 255);
                    set(out_.orm, x, y, 255, 160, 0);
                    set(out_.glossMetal, x, y, 95, 0, 0);
                }
    }

    bool copyFromNeighbour(int x, int y, const std::vector<bool>& filled) {
        constexpr std::array<std::array<int, 2>, 8> kAround = {
            {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, 1}, {1, -1}, {-1, -1}}};
        for (const auto& [dx, dy] : kAround) {
            const int u = x + dx, v = y + dy;
            if (u < 0 || v < 0 || u >= grid_.side || v >= grid_.side || !filled[index(u, v)])
                continue;
            for (ImageRgba8* image : {&out_.albedo, &out_.normal, &out_.orm, &out_.glossMetal})
                std::ranges::copy(image->at(u, v), image->at(x, y).begin());
            return true;
        }
        return false;
    }

    const Assembly& assembly_;
    const Atlas& atlas_;
    TexelGrid grid_;
    Occlusion occlusion_;
    MarkField marks_;
    std::vector<float> heights_;
    std::vector<std::unique_ptr<OuterEdges>> edges_;
    std::vector<Mat4> places_;
    Textures out_;
};

}  // namespace

Textures makeTextures(const Assembly& assembly, const Atlas& atlas, const Occluder& occluder) {
    return Painter(assembly, atlas, occluder).run();
}

}  // namespace vitrine::tank
