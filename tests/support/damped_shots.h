// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "tests/support/simulated_calibration.h"

#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <vector>

/// Shots of sensors that hardly ring, of known truth.
namespace dyncal::testing {

/// Unit-step response of w0^2/(s^2 + 2 zeta w0 s + w0^2) for every zeta: thesis eqs 3.15 to 3.17.
inline double dampedStep(double f0_Hz, double zeta, double t_s)
{
    if (zeta < 1.0 || t_s <= 0.0)
        return secondOrderStep(f0_Hz, zeta, t_s);
    const double w = 2.0 * std::numbers::pi * f0_Hz;
    if (zeta == 1.0)
        return 1.0 - std::exp(-w * t_s) * (1.0 + w * t_s);
    const double root = std::sqrt(zeta * zeta - 1.0);
    const double slow = w * (zeta - root);
    const double fast = w * (zeta + root);
    return 1.0 - (fast * std::exp(-slow * t_s) - slow * std::exp(-fast * t_s)) / (fast - slow);
}

struct DampedShots
{
    double noise = 0.005; ///< of each shot's step
    double ar1 = 0.0;
    double rate_Hz = 10e6;
    Index samples = 800;
    Index noiseSamples = 2000;
};

/// Response of a shot (0, 1 or 2) at a time after its onset, for a step of 1.
using ShotResponse = std::function<double(std::size_t shot, double t_s)>;

/// Three shots of 0.3, 0.6 and 0.9, each arriving at a fraction of a sample of its own.
inline ModelInput dampedShots(
    const ShotResponse &response, std::uint64_t seed, const DampedShots &made = {})
{
    std::vector<ModelSeries> series;
    for (std::size_t shot = 0; shot < 3; ++shot) {
        RandomStream random(seed, static_cast<Index>(shot), 16);
        const double step = 0.3 * static_cast<double>(shot + 1);
        const double fraction = random.nextUniform();
        const Eigen::VectorXd before
            = simulatedNoise(random, made.noiseSamples, made.noise * step, made.ar1);
        Eigen::VectorXd y = simulatedNoise(random, made.samples, made.noise * step, made.ar1);
        for (Index k = 0; k < y.size(); ++k)
            y[k] += step * response(shot, (static_cast<double>(k) + fraction) / made.rate_Hz);
        series.push_back(makeSeries(static_cast<Index>(shot) + 1, y, made.rate_Hz, before));
        series.back().step = step;
    }
    return makeInput(ResponseTreatment::StepDeflated, made.rate_Hz, std::move(series));
}

/// The same second-order sensor in all of them.
inline ModelInput dampedShots(
    double f0_Hz, double zeta, std::uint64_t seed, const DampedShots &made = {})
{
    return dampedShots(
        [&](std::size_t, double t_s) { return dampedStep(f0_Hz, zeta, t_s); }, seed, made);
}

/// Shots of a step of 1, each from its first sample beyond five standard deviations on.
struct CrossingShots
{
    double f0_Hz;
    double zeta;
    double noise = 0.005;
    Index shots = 3;
    double rate_Hz = 10e6;
};

inline ModelInput shotsFromTheirCrossings(const CrossingShots &made, std::uint64_t seed)
{
    constexpr double kSigmas = 5.0;
    constexpr Index kQuiet = 2000, kSamples = 800;
    std::vector<ModelSeries> series;
    for (Index shot = 1; shot <= made.shots; ++shot) {
        RandomStream random(seed, shot, 21);
        const double fraction = random.nextUniform();
        Eigen::VectorXd y = simulatedNoise(random, kQuiet + kSamples + 20, made.noise, 0.0);
        for (Index k = kQuiet; k < y.size(); ++k)
            y[k] += dampedStep(
                made.f0_Hz, made.zeta, (static_cast<double>(k - kQuiet) + fraction) / made.rate_Hz);
        Index start = kQuiet;
        while (y[start] < kSigmas * made.noise)
            ++start;
        series.push_back(
            makeSeries(shot, y.segment(start, kSamples), made.rate_Hz, y.head(kQuiet)));
    }
    return makeInput(ResponseTreatment::StepDeflated, made.rate_Hz, std::move(series));
}

} // namespace dyncal::testing
