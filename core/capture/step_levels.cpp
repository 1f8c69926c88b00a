// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/step_levels.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace dyncal {

std::vector<ShotLevel> levelsByStepHeight(const std::vector<std::optional<double>> &heights)
{
    constexpr double kLeastRatio = 1.1;
    constexpr std::size_t kMostGaps = 2;
    std::vector<double> sorted;
    for (const std::optional<double> &height : heights) {
        if (height && std::isfinite(*height) && *height != 0.0)
            sorted.push_back(std::abs(*height));
    }
    std::sort(sorted.begin(), sorted.end());
    std::vector<std::pair<double, double>> gaps; ///< ratio, first height above
    for (std::size_t i = 1; i < sorted.size(); ++i) {
        if (sorted[i] >= kLeastRatio * sorted[i - 1])
            gaps.emplace_back(sorted[i] / sorted[i - 1], sorted[i]);
    }
    std::sort(gaps.rbegin(), gaps.rend());
    gaps.resize(std::min(gaps.size(), kMostGaps));
    constexpr std::array kThree{ShotLevel::Low, ShotLevel::Medium, ShotLevel::High};
    constexpr std::array kTwo{ShotLevel::Low, ShotLevel::High};
    std::vector<ShotLevel> levels;
    for (const std::optional<double> &height : heights) {
        const bool none = !height || !std::isfinite(*height) || *height == 0.0 || gaps.empty();
        const auto below = static_cast<std::size_t>(std::count_if(gaps.begin(), gaps.end(),
            [&](const auto &gap) { return !none && std::abs(*height) >= gap.second; }));
        levels.push_back(none ? ShotLevel::None : gaps.size() == 2 ? kThree[below] : kTwo[below]);
    }
    return levels;
}

} // namespace dyncal
