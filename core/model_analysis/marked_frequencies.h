// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/model_analysis/response_result.h"
#include "core/model_analysis/response_settings.h"
#include "core/realization/model/sensor_model.h"

#include <optional>

namespace dyncal {

/// Where |S| is largest near a natural frequency, and how large over the plateau.
struct ResonancePeak
{
    double frequency_Hz = 0.0;
    double gain = 0.0;
};

/// Of a pair of poles with f0 (in hertz) and damping ratio zeta, by golden section to 1e-8 of the
/// frequency: of a second-order sensor alone f0 sqrt(1 - 2 zeta^2). Looked for there, zeta f0 to
/// both sides and at most half of that frequency. Empty where zeta is not below 1/sqrt(2), as
/// nothing rises then, and where |S| has no top there, because of other modes or of a level that
/// does not ring.
std::optional<ResonancePeak> resonancePeak(
    const SensorModel &model, ResponseTreatment treatment, double f0_Hz, double zeta);

/// Puts into `result` the frequencies, ascending, at which S(f) is always stated, and into `marks`
/// what each is: the ends of the band, the band edges that may be stated
/// (statedCharacteristics()) and, where they lie inside the band, the peak of the main resonance
/// and the frequencies of `known` values.
void markFrequencies(const SensorModel &model, ResponseTreatment treatment,
    const std::vector<KnownSensitivity> &known, ResponseResult &result);

} // namespace dyncal
