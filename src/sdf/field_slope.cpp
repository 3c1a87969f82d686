// SPDX-License-Identifier: MIT
#include "sdf/field_slope.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace vitrine {
namespace {

constexpr uint32_t kSpread = 32768;
constexpr size_t kBatch = 16384;

/// Steps over which slopes are measured: four scales, each four times the one before. The finest
/// is what floats of the coordinates' size still tell apart to a thousandth.
constexpr int kScales = 4;
constexpr float kFinestStep = 1.0f / 4096;

constexpr int kRounds = 9;
constexpr size_t kKept = 24;       // places a scale and side from which the search goes on
constexpr uint32_t kChildren = 8;  // of each
constexpr size_t kNearSurface = 512;

/// The same slope over a quarter of the step is a crease; four times the slope is a jump.
constexpr float kJumpGrowth = 2.2f;
/// A jump has no safe step; beyond this slope shorter ones only cost.
constexpr float kMostForJump = 4;

class Search {
  public:
    Search(const FieldDomain& domain, const FieldEvaluator& evaluate)
        : domain_(domain), evaluate_(evaluate) {
        const glm::vec3 reach = glm::max(glm::abs(domain.box.min), glm::abs(domain.box.max));
        finest_ = kFinestStep * std::max({reach.x, reach.y, reach.z});
        report_.bounds = domain.box;
        report_.nearest = std::numeric_limits<float>::infinity();
    }

    FieldReport run() {
        spread();
        approachSurface();
        for (int round = 0; round < kRounds; ++round) climb(round);
        faces();
        conclude();
        return std::move(report_);
    }

  private:
    struct Candidate {
        float slope;
        size_t sample;  // in kept_
    };
    /// The steepest of one scale on one side of the surface.
    struct Pool {
        std::vector<Candidate> list;
        float best = 0;
        size_t bestSample = 0;
    };

    [[nodiscard]] float stepOf(int scale) const {
        return finest_ * std::exp2(2.0f * static_cast<float>(scale));
    }
    [[nodiscard]] int scaleOf(float step) const {
        return std::clamp(static_cast<int>(std::lround(0.5f * std::log2(step / finest_))), 0,
                          kScales - 1);
    }
    [[nodiscard]] static FieldPlace placeOf(const FieldSamples& samples, size_t i, float value) {
        const auto& place = samples.places[i];
        return {place.point, place.time, samples.setting(i), value};
    }

    /// Asks, and keeps what stands out. The whole answer goes to `visit(samples, values)`.
    template <class Visit>
    void ask(const FieldSamples& samples, Visit visit) {
        if (samples.size() == 0) return;
        const std::vector<FieldValue> values = evaluate_(samples);
        for (size_t i = 0; i < samples.size(); ++i) {
            const FieldValue& v = values[i];
            if (v.bad > 0 || !std::isfinite(v.slope)) {
                if (report_.notFinite++ == 0)
                    report_.notFinitePlace = placeOf(samples, i, v.distance);
                continue;
            }
            report_.nearest = std::min(report_.nearest, std::abs(v.distance));
            anyNegative_ = anyNegative_ || v.distance < 0;
            offer(samples, i, v);
        }
        visit(samples, values);
    }

    void offer(const FieldSamples& samples, size_t i, const FieldValue& v) {
        // Between the two sides lies a skin in which a segment has an end on each: it would give
        // the slope of the inside to the outside, and a ray is there only when it has arrived.
        if (v.distance > 0 && v.distance < v.slope * samples.places[i].step) return;
        const auto scale = static_cast<size_t>(scaleOf(samples.places[i].step));
        Pool& pool = pools_[v.distance > 0 ? 0 : 1][scale];
        const bool full = pool.list.size() >= kKept;
        if (full && v.slope <= pool.list.back().slope) return;
        if (full) pool.list.pop_back();
        kept_.add(samples, i);
        const Candidate candidate{v.slope, kept_.size() - 1};
        pool.list.insert(
            std::upper_bound(pool.list.begin(), pool.list.end(), candidate,
                             [](const auto& a, const auto& b) { return a.slope > b.slope; }),
            candidate);
        if (v.slope > pool.best) {
            pool.best = v.slope;
            pool.bestSample = candidate.sample;
        }
    }

    void spread() {
        size_t steep = 0, outside = 0, negative = 0, good = 0;
        std::vector<std::pair<float, size_t>> nearest;
        for (uint32_t first = 0; first < kSpread; first += kBatch) {
            FieldSamples batch;
            for (uint32_t i = first; i < first + kBatch; ++i)
                addSpread(domain_, i,
                          stepOf(static_cast<int>(scrambled(i ^ 0x2545f491u) % kScales)), batch);
            ask(batch, [&](const FieldSamples& samples, const std::vector<FieldValue>& values) {
                for (size_t i = 0; i < values.size(); ++i) {
                    if (values[i].bad > 0) continue;
                    ++good;
                    negative += values[i].distance <= 0 ? 1 : 0;
                    if (values[i].distance > 0) {
                        ++outside;
                        steep += values[i].slope > kCleanSlope ? 1 : 0;
                    }
                    seeds_.push_back({std::abs(values[i].distance), values[i]});
                    seedSamples_.add(samples, i);
                }
            });
        }
        report_.samples = kSpread;
        if (outside > 0)
            report_.steepShare = static_cast<double>(steep) / static_cast<double>(outside);
        if (good > 0)
            report_.negativeShare = static_cast<double>(negative) / static_cast<double>(good);
    }

    /// Newton's steps from the samples nearest to the surface: there the slope matters most.
    void approachSurface() {
        std::vector<size_t> order(seeds_.size());
        for (size_t i = 0; i < order.size(); ++i) order[i] = i;
        const size_t count = std::min(kNearSurface, order.size());
        std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count),
                          order.end(), [&](size_t a, size_t b) {
                              return seeds_[a].first != seeds_[b].first
                                         ? seeds_[a].first < seeds_[b].first
                                         : a < b;
                          });
        FieldSamples samples;
        std::vector<FieldValue> values;
        for (size_t i = 0; i < count; ++i) {
            samples.add(seedSamples_, order[i]);
            values.push_back(seeds_[order[i]].second);
        }
        seeds_.clear();
        seedSamples_ = {};
        for (int round = 0; round < 3; ++round) {
            FieldSamples moved;
            for (size_t i = 0; i < samples.size(); ++i) {
                FieldSamples::Place place = samples.places[i];
                const float size = glm::dot(values[i].gradient, values[i].gradient);
                if (values[i].bad == 0 && size > 1e-12f)
                    place.point =
                        glm::clamp(place.point - values[i].distance / size * values[i].gradient,
                                   domain_.box.min, domain_.box.max);
                place.step = stepOf(round % 2);
                moved.add(place, samples.setting(i));
            }
            samples = std::move(moved);
            ask(samples, [&](const FieldSamples&, const std::vector<FieldValue>& answer) {
                values = answer;
            });
        }
    }

    void climb(int round) {
        const float reach = 0.1f * std::exp2(-static_cast<float>(round));
        FieldSamples samples;
        uint32_t index = static_cast<uint32_t>(round) << 20;
        for (const auto& side : pools_)
            for (int scale = 0; scale < kScales; ++scale)
                for (const Candidate& candidate : side[static_cast<size_t>(scale)].list)
                    for (uint32_t child = 0; child < kChildren; ++child) {
                        // Mostly at the same scale, else finer: that tells creases from jumps.
                        const int finer = child % 4 == 3 ? 1 : 0;
                        const int at = std::max(scale - finer, 0);
                        // Every other child no farther than the step: the peak is about there.
                        const glm::vec3 size = domain_.box.extent();
                        const float near = stepOf(at) / std::max({size.x, size.y, size.z});
                        addNear(domain_, kept_, candidate.sample,
                                child % 2 == 0 ? reach : std::min(reach, 2 * near), ++index,
                                stepOf(at), samples);
                    }
        ask(samples, [](const FieldSamples&, const std::vector<FieldValue>&) {});
    }

    /// Is the surface cut by a face of the box?
    void faces() {
        const glm::vec3 size = domain_.box.extent();
        const float deep = -1e-3f * std::max({size.x, size.y, size.z});
        FieldSamples samples;
        for (uint32_t i = 0; i < kBatch / 2; ++i) {
            addSpread(domain_, i, finest_, samples);
            const uint32_t face = i % 6;
            const int axis = static_cast<int>(face % 3);
            samples.places.back().point[axis] =
                face < 3 ? domain_.box.min[axis] : domain_.box.max[axis];
        }
        const std::vector<FieldValue> values = evaluate_(samples);
        for (size_t i = 0; i < values.size(); ++i) {
            if (values[i].bad > 0 || !(values[i].distance < deep)) continue;
            const FieldSetting setting = samples.setting(i);
            const bool inUse = std::find(domain_.settings.begin(), domain_.settings.end(),
                                         setting) != domain_.settings.end();
            if (report_.cut &&
                (report_.cutInUse > inUse ||
                 (report_.cutInUse == inUse && report_.cut->value <= values[i].distance)))
                continue;
            report_.cut = placeOf(samples, i, values[i].distance);
            report_.cutInUse = inUse;
        }
    }

    void conclude() {
        for (size_t side = 0; side < 2; ++side) {
            const auto& pools = pools_[side];
            FieldPlace& place = side == 0 ? report_.steepest : report_.steepestInside;
            size_t best = 0;
            for (size_t scale = 1; scale < kScales; ++scale)
                if (pools[scale].best > pools[best].best) best = scale;
            if (side == 0 && pools[0].best > kMostForJump / 2 &&
                pools[0].best > kJumpGrowth * pools[1].best &&
                pools[1].best > kJumpGrowth * pools[2].best) {
                report_.jump = finest_ * pools[0].best;
                report_.jumpPlace = placeOf(kept_, pools[0].bestSample, pools[0].best);
                best = kScales - 1;
            }
            if (pools[best].list.empty()) continue;
            place = placeOf(kept_, pools[best].bestSample, pools[best].best);
        }
        report_.lipschitz = report_.jump > 0
                                ? std::min(safeLipschitz(report_.steepest.value), kMostForJump)
                                : safeLipschitz(report_.steepest.value);
        if (anyNegative_) report_.nearest = 0;
    }

    const FieldDomain& domain_;
    const FieldEvaluator& evaluate_;
    float finest_ = 0;
    FieldReport report_;
    bool anyNegative_ = false;
    FieldSamples kept_;
    std::array<std::array<Pool, kScales>, 2> pools_;  // outside, inside; by scale
    std::vector<std::pair<float, FieldValue>> seeds_;
    FieldSamples seedSamples_;
};

}  // namespace

FieldReport measureSlope(const FieldDomain& domain, const FieldEvaluator& evaluate) {
    return Search(domain, evaluate).run();
}

}  // namespace vitrine
