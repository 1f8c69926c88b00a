// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/realization/hankel/hankel_decomposition.h"
#include "tests/support/realized_model.h"
#include "tests/support/simulated_calibration.h"

#include <cmath>
#include <string>
#include <vector>

namespace dyncal::testing {

/// How often the stated 95 % intervals of f0 and zeta hold the truth, and how the errors scatter
/// against the stated standard uncertainty.
struct PoleCoverage
{
    int runs = 0; ///< with a refined model
    int failed = 0; ///< without
    int insideF0 = 0;
    int insideZeta = 0;
    int heterogeneous = 0; ///< shots of one sensor that the homogeneity test told apart
    double squaresF0 = 0.0; ///< of error over u
    double squaresZeta = 0.0;

    double percentF0() const { return 100.0 * insideF0 / std::max(1, runs); }
    double percentZeta() const { return 100.0 * insideZeta / std::max(1, runs); }
};

struct CoverageCase
{
    std::string name;
    SimulatedCalibration calibration;
};

/// The cases in which the stated intervals must hold the truth in 93 to 97 % of 1000 runs.
inline std::vector<CoverageCase> coverageCases()
{
    const auto one = [](double f0_Hz, double zeta, double snr_dB, double ar1 = 0.0) {
        return SimulatedCalibration{{{1.0, f0_Hz, zeta}}, snr_dB, ar1};
    };
    return {
        {"318 kHz, zeta 0.02, 40 dB", one(318e3, 0.02, 40.0)},
        {"318 kHz, zeta 0.02, 30 dB", one(318e3, 0.02, 30.0)},
        {"318 kHz, zeta 0.02, 20 dB", one(318e3, 0.02, 20.0)},
        {"30 kHz, zeta 0.05, 40 dB", one(30e3, 0.05, 40.0)},
        {"30 kHz, zeta 0.05, 30 dB", one(30e3, 0.05, 30.0)},
        {"30 kHz, zeta 0.05, 20 dB", one(30e3, 0.05, 20.0)},
        {"30 kHz, zeta 0.5, 40 dB", one(30e3, 0.5, 40.0)},
        {"30 kHz, zeta 0.5, 30 dB", one(30e3, 0.5, 30.0)},
        {"30 kHz, zeta 0.05, 30 dB, AR(0.9)", one(30e3, 0.05, 30.0, 0.9)},
    };
}

inline void addCoverageRun(const CoverageCase &test, std::uint64_t seed, PoleCoverage &sum)
{
    const SimulatedMode &truth = test.calibration.modes.front();
    const ModelInput input = simulateCalibration(test.calibration, seed);
    RealizationSettings settings;
    settings.maxOrder = 4;
    const auto hankel = decomposeHankel(input, settings);
    const auto result = realizeModel(input, *hankel, 2, settings);
    const Pole *pole = result && result->model.refined ? result->main() : nullptr;
    if (!pole) {
        ++sum.failed;
        return;
    }
    ++sum.runs;
    const double f0 = pole->frequency_Hz - truth.f0_Hz;
    const double zeta = pole->dampingRatio - truth.zeta;
    sum.squaresF0 += std::pow(f0 / pole->u_frequency_Hz, 2);
    sum.squaresZeta += std::pow(zeta / pole->u_dampingRatio, 2);
    sum.insideF0 += std::abs(f0) <= pole->coverageFactor * pole->u_frequency_Hz;
    sum.insideZeta += std::abs(zeta) <= pole->coverageFactor * pole->u_dampingRatio;
    const auto &shared = result->assessment.homogeneity;
    sum.heterogeneous += shared && !shared->passed;
}

/// `runs` calibrations with seeds from `first` on.
inline PoleCoverage poleCoverage(const CoverageCase &test, int runs, int first = 1)
{
    PoleCoverage sum;
    for (int seed = first; seed < first + runs; ++seed)
        addCoverageRun(test, static_cast<std::uint64_t>(seed), sum);
    return sum;
}

} // namespace dyncal::testing
