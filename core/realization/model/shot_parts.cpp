// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/model/shot_parts.h"

#include "core/base/index.h"

#include <cmath>
#include <map>

namespace dyncal {

std::vector<std::vector<std::size_t>> seriesByLevel(const ModelInput &input)
{
    std::map<ShotLevel, std::vector<std::size_t>> levels;
    for (std::size_t r = 0; r < input.series.size(); ++r) {
        if (input.series[r].level != ShotLevel::None)
            levels[input.series[r].level].push_back(r);
    }
    std::vector<std::vector<std::size_t>> lists;
    lists.reserve(levels.size());
    for (auto &[level, series] : levels)
        lists.push_back(std::move(series));
    return lists;
}

LevelPole partOfShots(const ModelInput &input, const std::vector<std::size_t> &series)
{
    LevelPole part;
    part.level = input.series[series.front()].level;
    double step = 0.0;
    for (const std::size_t r : series) {
        part.shots.push_back(input.series[r].shot);
        step += input.series[r].step / static_cast<double>(series.size());
    }
    part.step = step;
    return part;
}

void addPlateau(const ModelInput &input, const std::vector<std::size_t> &series,
    const Refinement &refinement, LevelPole &part)
{
    if (!refinement.withConstant)
        return;
    double weights = 0.0;
    double sum = 0.0;
    for (std::size_t i = 0; i < series.size(); ++i) {
        const double u_baseline = input.series[series[i]].u_baseline;
        const double variance
            = constantVariance(refinement, static_cast<Index>(i)) + u_baseline * u_baseline;
        const double weight = variance > 0.0 ? 1.0 / variance : 1.0;
        weights += weight;
        sum += weight * refinement.records[i].constant;
    }
    part.plateauGain = sum / weights;
    part.u_plateauGain = 1.0 / std::sqrt(weights);
}

double betweenShots(const std::vector<double> &values, const std::vector<double> &u)
{
    const double count = static_cast<double>(values.size());
    double mean = 0.0;
    for (const double value : values)
        mean += value / count;
    double squares = 0.0;
    double weights = 0.0;
    double weightSquares = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        squares += (values[i] - mean) * (values[i] - mean);
        const double weight = 1.0 / (u[i] * u[i]);
        weights += weight;
        weightSquares += weight * weight;
    }
    return std::sqrt(squares / (count - 1.0) * weightSquares) / weights;
}

} // namespace dyncal
