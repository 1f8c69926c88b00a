// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/realization/input/model_input.h"

#include <cmath>
#include <complex>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

/// Model inputs of known truth for the tests of the realisation.
namespace dyncal::testing {

/// Unit-step response of w0^2/(s^2 + 2 zeta w0 s + w0^2) at time t >= 0 (closed form).
inline double secondOrderStep(double f0_Hz, double zeta, double t_s)
{
    if (t_s <= 0.0)
        return 0.0;
    const double w0 = 2.0 * std::numbers::pi * f0_Hz;
    const double wd = w0 * std::sqrt(1.0 - zeta * zeta);
    return 1.0
        - std::exp(-zeta * w0 * t_s) * (std::cos(wd * t_s) + zeta * w0 / wd * std::sin(wd * t_s));
}

/// Upper pole of that sensor in the z plane.
inline std::complex<double> secondOrderPole(double f0_Hz, double zeta, double rate_Hz)
{
    const double w0 = 2.0 * std::numbers::pi * f0_Hz;
    return std::exp(std::complex<double>(-zeta, std::sqrt(1.0 - zeta * zeta)) * (w0 / rate_Hz));
}

/// Gaussian noise that is the same everywhere (Box-Muller on mt19937_64).
class Noise
{
public:
    explicit Noise(std::uint64_t seed)
        : m_engine(seed)
    {
    }
    double next()
    {
        const double u1 = (static_cast<double>(m_engine() >> 11) + 0.5) / 9007199254740992.0;
        const double u2 = (static_cast<double>(m_engine() >> 11) + 0.5) / 9007199254740992.0;
        return std::sqrt(-2.0 * std::log(u1)) * std::cos(2.0 * std::numbers::pi * u2);
    }
    Eigen::VectorXd series(Index count, double sd)
    {
        Eigen::VectorXd x(count);
        for (Index i = 0; i < count; ++i)
            x[i] = sd * next();
        return x;
    }

private:
    std::mt19937_64 m_engine;
};

/// One unfiltered series: y at the model rate, `noise` its pre-trigger record.
inline ModelSeries makeSeries(
    Index shot, const Eigen::VectorXd &y, double rate_Hz, const Eigen::VectorXd &noise = {})
{
    ModelSeries series;
    series.shot = shot;
    series.y = y;
    series.noise = noise;
    series.noiseSd
        = noise.size() > 1 ? std::sqrt((noise.array() - noise.mean()).square().mean()) : 0.0;
    series.filter = {1, Eigen::VectorXd::Ones(1), rate_Hz};
    series.fullRate = y;
    series.fullRate_Hz = rate_Hz;
    series.fullRateNoiseSd = series.noiseSd;
    series.fullRateNoise = noiseCovariance(noise, kLargestNoiseModelOrder);
    return series;
}

inline ModelInput makeInput(
    ResponseTreatment treatment, double rate_Hz, std::vector<ModelSeries> series)
{
    ModelInput input;
    input.treatment = treatment;
    input.combine = series.size() > 1 ? CombineMethod::Stacked : CombineMethod::PcaAverage;
    input.sampleRate_Hz = rate_Hz;
    input.samples = series.front().y.size();
    input.series = std::move(series);
    return input;
}

/// Step response of one second-order sensor sampled at (k + first) / rate, k = 0..count-1.
inline Eigen::VectorXd sampledStep(
    double f0_Hz, double zeta, double rate_Hz, Index count, double first = 1.0)
{
    Eigen::VectorXd y(count);
    for (Index k = 0; k < count; ++k)
        y[k] = secondOrderStep(f0_Hz, zeta, (static_cast<double>(k) + first) / rate_Hz);
    return y;
}

} // namespace dyncal::testing
