// SPDX-License-Identifier: MIT
#include "sdf/field_bounds.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace vitrine {
namespace {

constexpr int kFirstLevel = -6, kLastLevel = 10;  // half edges of 2^level, in metres
static_assert(kFarthestBounds == 1 << kLastLevel);
constexpr uint32_t kPerLevel = 1024;
constexpr int kNewtonRounds = 6;
constexpr int kPressRounds = 7;
constexpr uint32_t kPressSpread = 2048;
constexpr size_t kOutermost = 24;  // points a face from which the search goes on
constexpr uint32_t kChildren = 8;
/// A field with a slope of only 1/16 is still followed.
constexpr float kLongestStride = 16;

float maxAbs(const glm::vec3& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

class BoundsSearch {
  public:
    BoundsSearch(const FieldDomain& domain, const FieldEvaluator& evaluate)
        : domain_(domain), evaluate_(evaluate) {}

    FoundBounds run() {
        for (int level = kFirstLevel; level <= kLastLevel; ++level) {
            const float half = std::exp2(static_cast<float>(level));
            domain_.box = {glm::vec3(-half), glm::vec3(half)};
            for (uint32_t i = 0; i < kPerLevel; ++i)
                addSpread(domain_, i + static_cast<uint32_t>(level + 16) * kPerLevel, 0, seeds_);
        }
        follow(std::move(seeds_), kNewtonRounds);
        if (box_.empty()) return {FoundBounds::Outcome::kNothing, {}};
        if (isInfinite()) return {FoundBounds::Outcome::kInfinite, {}};
        for (int round = 0; round < kPressRounds; ++round) press(round);
        if (isInfinite()) return {FoundBounds::Outcome::kInfinite, {}};
        return {FoundBounds::Outcome::kFound, withMargin()};
    }

  private:
    [[nodiscard]] bool isInfinite() const {
        return std::max(maxAbs(box_.min), maxAbs(box_.max)) > 0.5f * kFarthestBounds;
    }

    /// Leads the samples to the surface and keeps those that arrive, or were inside on the way.
    void follow(FieldSamples samples, int rounds) {
        for (int round = 0; round < rounds && samples.size() > 0; ++round) {
            for (auto& place : samples.places) place.step = 1e-3f * maxAbs(place.point) + 1e-7f;
            const std::vector<FieldValue> values = evaluate_(samples);
            FieldSamples next;
            for (size_t i = 0; i < samples.size(); ++i) {
                const FieldValue& v = values[i];
                if (v.bad > 0) continue;
                FieldSamples::Place place = samples.places[i];
                const float slope = glm::length(v.gradient);
                if (v.distance <= 1e-3f * slope * maxAbs(place.point)) keep(samples, i);
                if (slope < 1e-6f) continue;
                const float stride =
                    std::min(std::abs(v.distance) / slope, kLongestStride * std::abs(v.distance));
                place.point -= std::copysign(stride, v.distance) / slope * v.gradient;
                if (!(maxAbs(place.point) < 2 * kFarthestBounds)) continue;
                next.add(place, samples.setting(i));
            }
            samples = std::move(next);
        }
    }

    void keep(const FieldSamples& samples, size_t i) {
        const glm::vec3 p = samples.places[i].point;
        box_.grow(p);
        for (int face = 0; face < 6; ++face) {
            auto& list = outermost_[static_cast<size_t>(face)];
            const float reach = face < 3 ? p[face] : -p[face - 3];
            if (list.size() >= kOutermost && reach <= list.back().first) continue;
            if (list.size() >= kOutermost) list.pop_back();
            kept_.add(samples, i);
            const std::pair<float, size_t> entry{reach, kept_.size() - 1};
            list.insert(
                std::upper_bound(list.begin(), list.end(), entry,
                                 [](const auto& a, const auto& b) { return a.first > b.first; }),
                entry);
        }
    }

    /// Samples in and around the box, and around the outermost points.
    void press(int round) {
        const float size = maxAbs(box_.extent());
        domain_.box = {box_.min - 0.3f * size - 1e-6f, box_.max + 0.3f * size + 1e-6f};
        FieldSamples samples;
        for (uint32_t i = 0; i < kPressSpread; ++i)
            addSpread(domain_, i + static_cast<uint32_t>(round + 64) * kPressSpread, 0, samples);
        const float reach = 0.1f * std::exp2(-static_cast<float>(round));
        uint32_t index = static_cast<uint32_t>(round) << 20;
        for (const auto& list : outermost_)
            for (const auto& [ignored, sample] : list)
                for (uint32_t child = 0; child < kChildren; ++child)
                    addNear(domain_, kept_, sample, reach, ++index, 0, samples);
        follow(std::move(samples), 3);
    }

    /// A fiftieth all round, then outwards to numbers that a person would write.
    [[nodiscard]] Aabb withMargin() const {
        const float size = std::max(maxAbs(box_.extent()), 1e-5f);
        const float grid = 0.02f * std::pow(10.0f, std::floor(std::log10(size)));
        const auto out = [&](const glm::vec3& v) {
            return glm::ceil((v + 0.02f * size) / grid) * grid;
        };
        return {-out(-box_.min), out(box_.max)};
    }

    FieldDomain domain_;
    const FieldEvaluator& evaluate_;
    FieldSamples seeds_, kept_;
    Aabb box_;
    std::array<std::vector<std::pair<float, size_t>>, 6> outermost_;
};

}  // namespace

FoundBounds findBounds(const FieldDomain& domain, const FieldEvaluator& evaluate) {
    return BoundsSearch(domain, evaluate).run();
}

}  // namespace vitrine
