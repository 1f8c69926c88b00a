// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/model_analysis/model_characteristics.h"
#include "core/realization/exponentials/onset.h"
#include "core/realization/input/model_input.h"
#include "core/realization/refinement/pole_refinement.h"
#include "core/realization/refinement/refinement.h"
#include "core/synthesis/sensor_simulator.h"
#include "core/synthesis/step_response.h"

#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

/// What the noise allows: the Cramer-Rao bound of f0, zeta and the -3 dB frequency for simulated
/// shots, from the Fisher information of the joint model (shared poles; plateau and amplitudes of
/// each shot free) at the true parameters, white noise of known standard deviation.
namespace dyncal::testing {

struct NoiseBound
{
    double f0_Hz = 0.0;
    double zeta = 0.0;
    double minus3dB_Hz = 0.0;
};

/// Poles of the sensor in the s plane, paired, slowest first.
inline std::vector<std::complex<double>> truePoles(const SensorSpec &sensor)
{
    std::vector<std::complex<double>> poles;
    for (const SensorMode &mode : sensor.modes) {
        const double w0 = 2.0 * std::numbers::pi * mode.f0_Hz;
        const std::complex<double> s
            = w0 * std::complex<double>(-mode.zeta, std::sqrt(1.0 - mode.zeta * mode.zeta));
        poles.push_back(s);
        poles.push_back(std::conj(s));
    }
    if (sensor.realPole_Hz)
        poles.insert(poles.begin(), -2.0 * std::numbers::pi * *sensor.realPole_Hz);
    return poles;
}

/// -3 dB frequency of the mean of the records' responses, each turned to its own onset.
inline double minus3dB_Hz(const std::vector<ExponentialSum> &records)
{
    SensorModel model;
    model.amplitudes = Eigen::VectorXcd::Zero(records.front().poles_rad_s.size());
    for (const ExponentialSum &record : records) {
        const double onset_s
            = findOnset_s(record, 3.0 / record.poles_rad_s.cwiseAbs().maxCoeff()).value_or(0.0);
        const double share = 1.0 / static_cast<double>(records.size());
        model.plateauGain += share * record.constant;
        model.amplitudes.array()
            += share * record.amplitudes.array() * (record.poles_rad_s.array() * onset_s).exp();
    }
    for (const std::complex<double> &s : records.front().poles_rad_s) {
        Pole pole;
        pole.s_rad_s = s;
        model.poles.push_back(pole);
    }
    return stepCharacteristics(model, ResponseTreatment::StepDeflated).minus3dB_Hz.value_or(0.0);
}

/// Noise-free records of the truth, each as its exact sum of exponentials.
inline std::optional<Refinement> exactFit(const SensorSpec &sensor, int shots, double rate_Hz,
    double first_s, Index samples, double noiseSd)
{
    const StepResponse response(sensor);
    Eigen::VectorXd y(samples);
    for (Index k = 0; k < samples; ++k)
        y[k] = response.at(first_s + static_cast<double>(k) / rate_Hz);
    const std::vector<RefinementRecord> records(
        static_cast<std::size_t>(shots), {y, rate_Hz, 1.0 / noiseSd});
    return refinePoles(records, truePoles(sensor), true);
}

inline std::vector<ExponentialSum> exactRecords(
    const SensorSpec &sensor, int shots, double rate_Hz, Index samples)
{
    const auto exact = exactFit(sensor, shots, rate_Hz, 0.0, samples, 1.0);
    return exact ? exact->records : std::vector<ExponentialSum>();
}

/// Bound for `shots` records of `samples` values at `rate_Hz`, the first `first_s` after arrival,
/// noise `noiseSd` of the step.
inline NoiseBound noiseBound(const SensorSpec &sensor, int shots, double rate_Hz, double first_s,
    Index samples, double noiseSd)
{
    const auto exact = exactFit(sensor, shots, rate_Hz, first_s, samples, noiseSd);
    if (!exact)
        return {};

    NoiseBound bound;
    const Index pair = sensor.realPole_Hz ? 1 : 0;
    const std::complex<double> s = exact->poles_rad_s[static_cast<std::size_t>(pair)];
    const double w = std::abs(s);
    const Eigen::Matrix2d block = exact->covariance.block<2, 2>(pair, pair);
    const Eigen::Vector2d frequency(s.real() / w, s.imag() / w);
    const Eigen::Vector2d damping(
        -s.imag() * s.imag() / (w * w * w), s.real() * s.imag() / (w * w * w));
    bound.f0_Hz = std::sqrt(frequency.dot(block * frequency)) / (2.0 * std::numbers::pi);
    bound.zeta = std::sqrt(damping.dot(block * damping));

    // Gradient of the -3 dB frequency over all parameters: poles move all records, the rest one.
    const Index n = exact->poleParameters;
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(exact->covariance.rows());
    for (Index i = 0; i < gradient.size(); ++i) {
        const double step = 0.1 * std::sqrt(exact->covariance(i, i));
        const auto moved = [&](double delta) {
            std::vector<ExponentialSum> sums = exact->records;
            for (int r = 0; r < shots; ++r) {
                if (i < n)
                    sums[static_cast<std::size_t>(r)] = perturbed(*exact, r, i, delta);
                else if ((i - n) / (n + 1) == r)
                    sums[static_cast<std::size_t>(r)]
                        = perturbed(*exact, r, n + (i - n) % (n + 1), delta);
            }
            return minus3dB_Hz(sums);
        };
        gradient[i] = (moved(step) - moved(-step)) / (2.0 * step);
    }
    bound.minus3dB_Hz = std::sqrt(gradient.dot(exact->covariance * gradient));
    return bound;
}

} // namespace dyncal::testing
