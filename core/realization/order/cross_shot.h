// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/progress.h"
#include "core/realization/input/model_input.h"
#include "core/realization/input/realization_settings.h"

#include <Eigen/Core>

namespace dyncal {

/// How well the poles of the other shots describe a shot, by order.
struct CrossShot
{
    Eigen::VectorXd error_percent; ///< 100 sqrt(sum error^2 / sum spread^2) over all shots
    Eigen::MatrixXd fit_percent; ///< orders x shots, eq 4.1 of each shot
};

/// Leave-one-shot-out: poles from the decomposition of the other shots, amplitudes and constant
/// fitted to the shot left out, orders 1..20. NaN where an order diverges; empty with fewer than
/// two shots, for an average, and where a decomposition fails.
CrossShot leaveOneShotOut(
    const ModelInput &input, const RealizationSettings &settings, const JobControl &control = {});

} // namespace dyncal
