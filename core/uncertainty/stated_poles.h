// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/uncertainty/uncertainty_report.h"

#include <optional>
#include <vector>

namespace dyncal {

/// Standard uncertainties of a pole's frequency and damping ratio, and their Student's factors of
/// 95 %; kUnknown where the pole was not refined.
struct PoleUncertainty
{
    double u_frequency_Hz = kUnknown;
    double kFrequency = kUnknown;
    double u_dampingRatio = kUnknown;
    double kDamping = kUnknown;
    double u_amplitude = kUnknown; ///< of |c_i|, in the model's unit
    double kAmplitude = kUnknown;
    double leastFrequency_Hz = 0.0; ///< the CMC of what is reported; 0 without one
    double leastDamping = 0.0;
};

/// Of each of polesOf(), in their order. The residuals do not show an error of the sample clock:
/// its line of the budget joins that of the noise (docs/method/uncertainty.md). The pole that f0
/// and damping are of has exactly what is reported of these, so that one number has one uncertainty
/// wherever it is printed. Without a report, or with one that has no f0, the noise alone is not
/// passed off for more: all are unknown.
std::vector<PoleUncertainty> statedPoles(
    const SensorModel &model, const ModelAssessment *assessment, const UncertaintyReport *report);

/// f0 and damping of the sensor with what is reported of them; unknown uncertainties without a
/// report. Empty where sensorResonance() is.
struct StatedResonance
{
    double frequency_Hz = kUnknown;
    double dampingRatio = kUnknown;
    PoleUncertainty with;
};
std::optional<StatedResonance> statedResonance(
    const SensorModel *model, const ModelAssessment *assessment, const UncertaintyReport *report);

} // namespace dyncal
