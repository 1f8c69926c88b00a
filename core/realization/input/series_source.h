// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"
#include "core/decomposition/component_result.h"
#include "core/signal/response_window.h"
#include "core/signal/signal_settings.h"

#include <Eigen/Core>

#include <vector>

namespace dyncal {

/// What one series is made of before it is resampled: samples from `lead` on are the response.
/// Keeps a reference to them.
struct SeriesSource
{
    Index shot = 0;
    Eigen::Ref<const Eigen::VectorXd> values;
    Index lead = 0;
    Index length = 0;
    double rate_Hz = 0.0;
    Eigen::VectorXd noise;
    double leastNoiseSd = 0.0; ///< of rounding, at the record's rate
    double roundingSd = 0.0; ///< of it what averaging leaves
    double baselineVarianceFactor = 1.0; ///< WindowedResponse
};

/// One per shot, or the average of the reconstructions alone.
std::vector<SeriesSource> seriesSources(const std::vector<WindowedResponse> &responses,
    const ComponentResult &components, CombineMethod combine);

} // namespace dyncal
