// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"

#include <Eigen/Core>

#include <optional>

namespace dyncal {

/// What can be read off a step response directly. Empty where noise or the window forbid it.
struct StepReadings
{
    std::optional<double> rise_samples; ///< 10-90 %, first crossings, interpolated
    std::optional<double> overshoot; ///< (maximum - plateau)/plateau, from a parabola at the top
    std::optional<double> settling_samples; ///< after the start: last entry into 1 +- 0.05
};

/// `response` goes from 0 before the start to 1 on the plateau; the window is
/// [lead, lead + length) of it. `noiseSd` is relative to the step: above 0.1 (SNR 20 dB) nothing is
/// given, above 0.0125 (four deviations are 5 %) neither overshoot nor settling, because noise
/// alone would decide them.
StepReadings readStep(
    const Eigen::Ref<const Eigen::VectorXd> &response, Index lead, Index length, double noiseSd);

/// Where `response`, as above, first rises through `level` of 0.1 or more between the detected
/// start `lead` and `end`: in samples, interpolated. Empty where it never does.
std::optional<double> riseCrossing(
    const Eigen::Ref<const Eigen::VectorXd> &response, Index lead, Index end, double level);

} // namespace dyncal
