// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/realization/input/model_input.h"
#include "core/realization/model/model_assessment.h"
#include "core/realization/refinement/refinement.h"

#include <cstddef>
#include <vector>

namespace dyncal {

// Shots and levels for themselves: what the comparisons of shots share (docs/method/model.md).

/// Probability of the scatter by chance below which the shots do not share their poles.
inline constexpr double kSharedAtLeast = 0.01;

/// Positions in the input of the shots of each level, from low to high; shots without one are left
/// out.
std::vector<std::vector<std::size_t>> seriesByLevel(const ModelInput &input);

/// Which shots these series are, with their level and mean step; the rest unknown.
LevelPole partOfShots(const ModelInput &input, const std::vector<std::size_t> &series);

/// Mean plateau over the shots that `refinement` has fitted, weighted by their uncertainties, which
/// include that of each baseline. Nothing without a constant.
void addPlateau(const ModelInput &input, const std::vector<std::size_t> &series,
    const Refinement &refinement, LevelPole &part);

/// Standard uncertainty of the mean, weighted by 1/u^2, from the scatter over the shots; at least
/// two of them.
double betweenShots(const std::vector<double> &values, const std::vector<double> &u);

} // namespace dyncal
