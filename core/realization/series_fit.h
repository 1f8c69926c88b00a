// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/realization/model_draft.h"
#include "core/realization/sensor_model.h"

#include <vector>

namespace dyncal {

/// 100 (1 - sqrt(errorSquares / spreadSquares)): eq 4.1 in percent, from sums of squares.
double fitPercent(double errorSquares, double spreadSquares);

/// Sum of squares about the mean.
double spreadSquares(const Eigen::VectorXd &y);

/// At the samples of series.y: the sum with the terms beside it, through the filter as measured.
Eigen::VectorXd simulate(const ModelSeries &series, const ExponentialSum &sum,
    const std::vector<NuisanceTerm> &terms, double dt_s);

/// How series `r` of the input is described by the draft: plateau, onset with its uncertainty,
/// amplitudes at the onset, simulation and FIT. `isSensor` tells which poles take part in the
/// search for the onset; `stateSpace` is what thesis mode simulates with.
SeriesFit describeSeries(const ModelInput &input, const ModelDraft &draft, std::size_t r,
    const std::vector<bool> &isSensor, const StateSpaceModel &stateSpace);

} // namespace dyncal
