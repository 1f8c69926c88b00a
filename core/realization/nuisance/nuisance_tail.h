// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"
#include "core/realization/input/model_input.h"
#include "core/realization/input/nuisance_term.h"
#include "core/signal/window_bands.h"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace dyncal {

/// The record after a time at which the sensor has settled, averaged in blocks.
struct NuisanceTail
{
    Eigen::VectorXd y;
    std::vector<SampleRange> used; ///< blocks without anything left out
    double begin_s = 0.0; ///< middle of the first block
    double step_s = 0.0;

    Index count() const
    {
        Index sum = 0;
        for (const SampleRange &range : used)
            sum += range.size();
        return sum;
    }
};

/// The record of the series from `begin_s` on, in blocks short enough for a mode of `fastest_Hz`.
NuisanceTail tailOf(const ModelSeries &series, double begin_s, double fastest_Hz);

/// A mode expected in one series, before it is found.
struct NuisanceCandidate
{
    std::size_t mode;
    double frequency_Hz;
};

/// Adds the mode at its best frequency near the expected one; false if none is found.
bool addBestTerm(const NuisanceTail &tail, const NuisanceCandidate &candidate, bool startsWithStep,
    std::vector<NuisanceTerm> &terms);

/// Fits the poles too, starting from those of the search; amplitudes at time 0.
void polish(const NuisanceTail &tail, bool withConstant, std::vector<NuisanceTerm> &terms);

} // namespace dyncal
