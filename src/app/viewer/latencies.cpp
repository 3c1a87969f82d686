// SPDX-License-Identifier: MIT
#include "app/viewer/latencies.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace vitrine {

bool Latencies::empty() const {
    return std::all_of(seconds_.begin(), seconds_.end(), [](const auto& s) { return s.empty(); });
}

std::string Latencies::table() const {
    static constexpr std::array kNames{"refine", "play",   "turn",  "pick",
                                       "edit",   "reload", "behind"};
    std::string text = fmt::format("{:8}{:>8}{:>12}{:>12}{:>12}\n", "step", "count", "median ms",
                                   "95 % ms", "longest ms");
    for (size_t i = 0; i < seconds_.size(); ++i) {
        std::vector<double> sorted = seconds_[i];
        if (sorted.empty()) continue;
        std::sort(sorted.begin(), sorted.end());
        const auto at = [&](double share) {
            return 1000 *
                   sorted[static_cast<size_t>(share * static_cast<double>(sorted.size() - 1))];
        };
        text += fmt::format("{:8}{:>8}{:>12.1f}{:>12.1f}{:>12.1f}\n", kNames[i], sorted.size(),
                            at(0.5), at(0.95), at(1));
    }
    return text;
}

}  // namespace vitrine
