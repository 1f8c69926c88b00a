// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/model_analysis/model_response.h"

#include <numbers>

namespace dyncal {

std::complex<double> modelResponse(
    const SensorModel &model, ResponseTreatment treatment, double frequency_Hz)
{
    const std::complex<double> jw(0.0, 2.0 * std::numbers::pi * frequency_Hz);
    const bool isStep = isStepTreatment(treatment);
    std::complex<double> G = isStep ? model.plateauGain : 0.0;
    for (Index i = 0; i < model.amplitudes.size(); ++i)
        G += model.amplitudes[i] * (isStep ? jw : 1.0)
            / (jw - model.poles[static_cast<std::size_t>(i)].s_rad_s);
    return G;
}

} // namespace dyncal
