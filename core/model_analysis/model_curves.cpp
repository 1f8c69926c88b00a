// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/model_analysis/sensor_response.h"
#include "core/model_analysis/unwrapped_phase.h"

#include <cmath>
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

ResponseCurve modelCurve(const SensorModel &model, ResponseTreatment treatment, double from_Hz,
    double to_Hz, Index count)
{
    ResponseCurve curve{Eigen::VectorXd(count), Eigen::VectorXd(count), Eigen::VectorXd(count)};
    UnwrappedPhase phase(model, treatment);
    for (Index k = 0; k < count; ++k) {
        const double share
            = count > 1 ? static_cast<double>(k) / static_cast<double>(count - 1) : 0.0;
        curve.frequency_Hz[k] = from_Hz * std::pow(to_Hz / from_Hz, share);
        curve.magnitude[k] = std::abs(modelResponse(model, treatment, curve.frequency_Hz[k]));
        curve.phase_rad[k] = phase.at(curve.frequency_Hz[k]);
    }
    return curve;
}

} // namespace dyncal
