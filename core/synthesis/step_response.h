// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/synthesis/sensor_spec.h"

#include <complex>
#include <functional>
#include <span>
#include <vector>

namespace dyncal {

/// exp(-decay t) cos(omega t + phase) from t = 0 on; decay and omega from the undamped frequency
/// and zeta, above 0 and below 1.
struct Oscillation
{
    double frequency_Hz = 0.0; ///< undamped
    double zeta = 0.0;
    double phase_rad = 0.0;
};

/// Response of a sensor of sensitivity 1 to a unit step, in closed form: a constant and decaying
/// exponentials from the poles and residues of G(s)/s. With `relaxation_s` > 0 the input is
/// 1 - exp(-t / relaxation_s) instead of the step (one pole more; equally exact). Values depend on
/// portable arithmetic only.
class StepResponse
{
public:
    /// The sensor must pass checkSensor. A relaxation whose pole coincides with a real pole of the
    /// sensor is moved by 1e-5 of itself (the response changes by less than 1e-5).
    explicit StepResponse(const SensorSpec &sensor, double relaxation_s = 0.0);

    /// Response to an oscillation instead of the step. Sensor and oscillation must not have a pole
    /// in common.
    StepResponse(const SensorSpec &sensor, const Oscillation &oscillation);

    /// Value at a time after the step; 0 before.
    double at(double time_s) const;

    /// Adds scale * response at times firstTime_s + i / sampleRate_Hz to values[i]. Recurrences of
    /// 1024 samples between closed-form values; the difference from at() stays below 1e-12.
    void addTo(
        std::span<double> values, double firstTime_s, double sampleRate_Hz, double scale) const;

    /// Every exponential times the weight of its pole, the constant times that of 0. The weight of
    /// the conjugate pole must be the conjugate weight; asked for where the imaginary part is >= 0.
    using PoleWeight = std::function<std::complex<double>(std::complex<double> pole_per_s)>;
    StepResponse weighted(const PoleWeight &weight) const;

    /// Largest magnitude of a pole, in rad/s.
    double fastestPole_rad_s() const;

private:
    StepResponse() = default;

    /// Real part of (re + j im) exp((-decay + j omega) t).
    struct Term
    {
        double decay_per_s = 0.0;
        double omega_rad_s = 0.0;
        double re = 0.0;
        double im = 0.0;
    };

    /// Laplace transform: gain (numerator[0] + numerator[1] s + ...) / product of (s - pole).
    struct Fraction
    {
        double gain = 1.0;
        std::vector<double> numerator{1.0};
        std::vector<std::complex<double>> poles;
    };

    static Fraction modeOf(const SensorSpec &sensor, const SensorMode &mode);
    void addHeated(Fraction fraction, const SensorSpec &sensor);
    void addTerms(const Fraction &fraction);

    double m_constant = 0.0;
    std::vector<Term> m_terms;
};

} // namespace dyncal
