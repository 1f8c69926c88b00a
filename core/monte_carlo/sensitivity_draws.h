// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/monte_carlo/chain_inputs.h"

#include <Eigen/Core>

namespace dyncal {

/// The sensitivities of one trial, NaN where a step leaves the range of the relations.
struct DrawnSensitivities
{
    Eigen::VectorXd ofMeans; ///< of ChainInputs::means
    Eigen::VectorXd ofShots;
    double common = 1.0; ///< by which every row of S(f) is larger, without what is its own
};

/// `probabilities` of the sources.
DrawnSensitivities drawnSensitivities(
    const ChainSubject &subject, const ChainInputs &inputs, const Eigen::VectorXd &probabilities);

} // namespace dyncal
