// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/model_analysis/model_curves.h"

#include "core/model_analysis/model_response.h"
#include "core/model_analysis/unwrapped_phase.h"

#include <cmath>

namespace dyncal {

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
