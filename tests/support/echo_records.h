// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/realization/input/rate_choice.h"
#include "core/signal/response_window.h"
#include "tests/support/damped_shots.h"

#include <cmath>
#include <cstdint>
#include <numbers>

/// Responses to a step and a smaller copy of it, of known truth.
namespace dyncal::testing {

struct EchoRecord
{
    double f0_Hz = 318e3;
    double zeta = 0.02;
    double relative = 0.0; ///< of the copy
    double delay_s = 100e-6;
    double noise = 0.01; ///< of the step
    double drift = 0.0; ///< of the step, with a time constant of 0.1 ms
    double slope_per_s = 0.0; ///< of the pressure after the step
    double secondMode = 0.0; ///< share of another mode of 510 kHz
    std::uint64_t seed = 1;
    Index shot = 1;
    Index samples = 3000;
};

/// Record at 10 MS/s (300 us), arriving a third of a sample before the first one; 3000 values of
/// noise.
inline WindowedResponse echoRecord(const EchoRecord &made)
{
    constexpr double kRate_Hz = 10e6;
    RandomStream random(made.seed, made.shot, 17);
    WindowedResponse response;
    response.shot = made.shot;
    response.sampleRate_Hz = kRate_Hz;
    response.noise = simulatedNoise(random, 3000, made.noise, 0.0);
    response.values = simulatedNoise(random, made.samples, made.noise, 0.0);
    response.length = made.samples;
    response.end_s = static_cast<double>(made.samples) / kRate_Hz;
    const auto answer = [&](double t_s) {
        return (1.0 - made.secondMode) * dampedStep(made.f0_Hz, made.zeta, t_s)
            + made.secondMode * dampedStep(510e3, 0.01, t_s);
    };
    for (Index k = 0; k < made.samples; ++k) {
        const double t_s = (static_cast<double>(k) + 1.0 / 3.0) / kRate_Hz;
        response.values[k] += answer(t_s) + made.relative * answer(t_s - made.delay_s)
            + made.slope_per_s * t_s - made.drift * std::expm1(-t_s / 1e-4);
    }
    return response;
}

/// What is known of that sensor before any model: its damped frequency and decay, or its rise.
inline SensorTraits traitsOf(double f0_Hz, double zeta)
{
    if (zeta >= 0.5)
        return {{}, zeta < 1.0 ? 0.35 / f0_Hz : 0.35 * 2.0 * zeta / f0_Hz};
    const double f_Hz = f0_Hz * std::sqrt(1.0 - zeta * zeta);
    return {{{f_Hz, 1.0 / (2.0 * std::numbers::pi * f0_Hz * zeta)}}, 0.2 / f0_Hz};
}

} // namespace dyncal::testing
