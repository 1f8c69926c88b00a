// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/portable_random.h"
#include "tests/support/model_inputs.h"

#include <cmath>
#include <vector>

/// Three-shot calibrations of known truth: what the order trials and the coverage of the stated
/// uncertainties are measured on (docs/accuracy.md).
namespace dyncal::testing {

/// One second-order mode of a sensor: `share` of the step passes through it.
struct SimulatedMode
{
    double share = 1.0;
    double f0_Hz = 0.0;
    double zeta = 0.0;
};

/// Steps of 0.33, 0.6 and 0.9 of the converter's range of 14 bits, each arriving at a fraction of
/// a sample of its own. The noise is `snr_dB` below each shot's own step; with `ar1` != 0 it is the
/// stationary process x_k = ar1 x_(k-1) + e_k of that same standard deviation.
struct SimulatedCalibration
{
    std::vector<SimulatedMode> modes;
    double snr_dB = 40.0;
    double ar1 = 0.0;
    double rate_Hz = 1e6;
    Index samples = 400; ///< of the response
    Index noiseSamples = 1000; ///< before the start
    std::vector<double> shiftOfShot = {0.0, 0.0, 0.0}; ///< relative shift of every f0, per shot
};

/// Noise of standard deviation `sd`, white or AR(1).
inline Eigen::VectorXd simulatedNoise(RandomStream &random, Index count, double sd, double ar1)
{
    Eigen::VectorXd x(count);
    const double innovation = std::sqrt(1.0 - ar1 * ar1) * sd;
    double last = sd * random.nextNormal();
    for (Index k = 0; k < count; ++k) {
        last = k == 0 ? last : ar1 * last + innovation * random.nextNormal();
        x[k] = last;
    }
    return x;
}

/// The model input of one run: the record and the noise before it, in units of the range.
inline ModelInput simulateCalibration(const SimulatedCalibration &calibration, std::uint64_t seed)
{
    static constexpr double kCode = 1.0 / 8192.0; // 14 bits over -1 .. 1
    static constexpr std::array<double, 3> kSteps{0.33, 0.6, 0.9};
    std::vector<ModelSeries> series;
    for (std::size_t shot = 0; shot < kSteps.size(); ++shot) {
        RandomStream random(seed, static_cast<Index>(shot), 11);
        const double fraction = random.nextUniform();
        const double step = kSteps[shot];
        const double sd = step * std::pow(10.0, -calibration.snr_dB / 20.0);
        Eigen::VectorXd record = simulatedNoise(
            random, calibration.noiseSamples + calibration.samples, sd, calibration.ar1);
        for (const SimulatedMode &mode : calibration.modes)
            record.tail(calibration.samples) += step * mode.share
                * sampledStep(mode.f0_Hz * (1.0 + calibration.shiftOfShot[shot]), mode.zeta,
                    calibration.rate_Hz, calibration.samples, fraction);
        record = (record / kCode).array().round() * kCode;
        const Eigen::VectorXd noise = record.head(calibration.noiseSamples);
        series.push_back(makeSeries(static_cast<Index>(shot) + 1, record.tail(calibration.samples),
            calibration.rate_Hz, noise.array() - noise.mean()));
    }
    return makeInput(ResponseTreatment::StepDeflated, calibration.rate_Hz, std::move(series));
}

} // namespace dyncal::testing
