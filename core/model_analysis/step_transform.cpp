// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/model_analysis/step_transform.h"

#include <cmath>
#include <numbers>

namespace dyncal {
namespace {

/// jx / (1 - e^(-jx)), 1 at x = 0.
std::complex<double> sampledStepCorrection(double x)
{
    if (x == 0.0)
        return 1.0;
    return std::complex<double>(0.0, x) / (1.0 - std::polar(1.0, -x));
}

} // namespace

std::complex<double> stepTransform(const Eigen::Ref<const Eigen::VectorXd> &y, double rate_Hz,
    double endLevel, double onset_s, double frequency_Hz)
{
    const double w = 2.0 * std::numbers::pi * frequency_Hz;
    const double x = w / rate_Hz;
    const std::complex<double> turn = std::polar(1.0, -x);
    std::complex<double> D = 0.0;
    std::complex<double> phasor = 1.0;
    double previous = 0.0;
    constexpr Index kBlock = 1024; // the rotating phasor is set anew before rounding adds up
    for (Index n = 0; n < y.size(); ++n) {
        if (n % kBlock == 0)
            phasor = std::polar(1.0, -x * static_cast<double>(n));
        D += (y[n] - previous) * phasor;
        previous = y[n];
        phasor *= turn;
    }
    D += (endLevel - previous) * std::polar(1.0, -x * static_cast<double>(y.size()));
    return D * sampledStepCorrection(x) * std::polar(1.0, w * onset_s);
}

double stepTransformNoise(Index samples, double rate_Hz, double noiseSd, double frequency_Hz)
{
    const double x = 2.0 * std::numbers::pi * frequency_Hz / rate_Hz;
    return noiseSd * std::abs(1.0 - std::polar(1.0, -x))
        * std::sqrt(static_cast<double>(samples) / 2.0) * std::abs(sampledStepCorrection(x));
}

} // namespace dyncal
