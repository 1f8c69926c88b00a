// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "core/realization/exponentials/exponential_sum.h"
#include "core/realization/input/model_input.h"
#include "core/signal/response_window.h"
#include "core/signal/signal_settings.h"
#include "core/signal/window_bands.h"

#include <Eigen/Core>

#include <vector>

namespace dyncal {

// Marked stretches of a record that take no part in the fit (docs/method/nuisance-modes.md).

/// Adds the stretches to their series and bridges them by a straight line in the correction;
/// stretches of unused shots are ignored. Fails (Usage) on a stretch outside its window;
/// (DataBlocked, WIN-008) where more than half of a model input would be left out. Findings:
/// WIN-007 (each stretch, with its reason), WIN-009 (the average of the shots has none).
Result<void> leaveOut(ModelInput &input, const std::vector<WindowedResponse> &responses,
    const std::vector<ExcludedStretch> &stretches);

/// Samples of fullRate that take part, in order; empty = all.
std::vector<SampleRange> usedSamples(const ModelSeries &series);

/// Samples of y whose filter sees nothing that was left out, in order.
std::vector<SampleRange> countedSamples(const ModelSeries &series);

/// The values (one per sample of y) of countedSamples(), one after the other.
Eigen::VectorXd countedValues(const ModelSeries &series, const Eigen::VectorXd &values);

/// The correction that, added to y, replaces the recording in the stretches by the response of
/// `sensor` and the series' nuisance terms; through the filter, at the model rate.
Eigen::VectorXd bridge(const ModelSeries &series, const ExponentialSum &sensor);

/// The input cut to the longest run without stretches left out that every series has; empty if
/// shorter than an eighth of the input. For finding poles.
ModelInput cleanRun(const ModelInput &input);

} // namespace dyncal
