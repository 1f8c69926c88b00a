// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/synthesis/step_response.h"

#include "core/base/index.h"
#include "core/base/portable_math.h"
#include "core/synthesis/sensor_poles.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>

namespace dyncal {
namespace {

constexpr Index kAnchorDistance = 1024;
constexpr double kVanished = 60.0; ///< decay times after which a term is below 1e-26
constexpr double kApart = 1e-5; ///< relative distance of real poles that would coincide

/// The relaxation, moved away from a real pole of the sensor that it would fall on.
double distinctRelaxation_s(const SensorSpec &sensor, double relaxation_s)
{
    std::vector<double> poles_per_s = sharedRealPoles_per_s(sensor);
    for (const SensorMode &mode : sensor.modes) {
        for (const std::complex<double> &pole : modePoles(mode)) {
            if (pole.imag() == 0.0)
                poles_per_s.push_back(-pole.real());
        }
    }
    const bool falls = std::any_of(poles_per_s.begin(), poles_per_s.end(), [&](double pole_per_s) {
        return std::abs(pole_per_s * relaxation_s - 1.0) < 0.5 * kApart;
    });
    return falls ? relaxation_s * (1.0 + kApart) : relaxation_s;
}

} // namespace

StepResponse::StepResponse(const SensorSpec &sensor, double relaxation_s)
{
    const double distinct_s = relaxation_s > 0.0 ? distinctRelaxation_s(sensor, relaxation_s) : 0.0;
    for (const SensorMode &mode : sensor.modes) {
        Fraction fraction = modeOf(sensor, mode);
        if (relaxation_s > 0.0) {
            fraction.poles.emplace_back(-1.0 / distinct_s, 0.0);
            fraction.gain /= distinct_s;
        }
        // The step's pole at 0, or AC coupling's: its zero at 0 cancels that of the step.
        fraction.poles.emplace_back(sensor.acCoupling_s ? -1.0 / *sensor.acCoupling_s : 0.0, 0.0);
        addHeated(std::move(fraction), sensor);
    }
}

StepResponse::StepResponse(const SensorSpec &sensor, const Oscillation &oscillation)
{
    const std::vector<std::complex<double>> pair
        = modePoles({oscillation.frequency_Hz, oscillation.zeta, 1.0});
    const SineCosine phase = portableSineCosine(oscillation.phase_rad);
    const double constant = -pair[0].real() * phase.cosine - pair[0].imag() * phase.sine;
    for (const SensorMode &mode : sensor.modes) {
        Fraction fraction = modeOf(sensor, mode);
        fraction.poles.insert(fraction.poles.end(), pair.begin(), pair.end());
        fraction.numerator = {constant, phase.cosine};
        if (sensor.acCoupling_s) {
            fraction.poles.emplace_back(-1.0 / *sensor.acCoupling_s, 0.0);
            fraction.numerator = {0.0, constant, phase.cosine};
        }
        addHeated(std::move(fraction), sensor);
    }
}

StepResponse::Fraction StepResponse::modeOf(const SensorSpec &sensor, const SensorMode &mode)
{
    const double omega0 = kTwoPi * mode.f0_Hz;
    Fraction fraction;
    fraction.poles = modePoles(mode);
    fraction.gain = mode.weight * omega0 * omega0;
    if (sensor.realPole_Hz) {
        fraction.poles.emplace_back(-kTwoPi * *sensor.realPole_Hz, 0.0);
        fraction.gain *= kTwoPi * *sensor.realPole_Hz;
    }
    return fraction;
}

/// Times 1 - share/(1 + s tau) = (s + (1 - share)/tau)/(s + 1/tau), where the sensor is heated.
void StepResponse::addHeated(Fraction fraction, const SensorSpec &sensor)
{
    if (sensor.heat) {
        const double rate_per_s = 1.0 / sensor.heat->tau_s;
        std::vector<double> product(fraction.numerator.size() + 1, 0.0);
        for (std::size_t n = 0; n < fraction.numerator.size(); ++n) {
            product[n] += (1.0 - sensor.heat->share) * rate_per_s * fraction.numerator[n];
            product[n + 1] += fraction.numerator[n];
        }
        fraction.numerator = std::move(product);
        fraction.poles.emplace_back(-rate_per_s, 0.0);
    }
    addTerms(fraction);
}

void StepResponse::addTerms(const Fraction &fraction)
{
    const std::vector<std::complex<double>> &poles = fraction.poles;
    for (std::size_t i = 0; i < poles.size(); ++i) {
        if (poles[i].imag() < 0.0)
            continue; // half of a pair: its partner's term stands for both
        std::complex<double> product(1.0, 0.0);
        for (std::size_t j = 0; j < poles.size(); ++j) {
            if (j != i)
                product *= poles[i] - poles[j];
        }
        std::complex<double> numerator(0.0, 0.0);
        for (auto n = fraction.numerator.rbegin(); n != fraction.numerator.rend(); ++n)
            numerator = *n + poles[i] * numerator;
        const std::complex<double> residue = std::conj(product) * numerator;
        const double scale
            = (poles[i].imag() > 0.0 ? 2.0 : 1.0) * fraction.gain / std::norm(product);
        const Term term{
            -poles[i].real(), poles[i].imag(), scale * residue.real(), scale * residue.imag()};
        if (term.decay_per_s == 0.0)
            m_constant += term.re;
        else
            m_terms.push_back(term);
    }
}

StepResponse StepResponse::weighted(const PoleWeight &weight) const
{
    StepResponse result;
    result.m_constant = m_constant * weight({0.0, 0.0}).real();
    for (const Term &term : m_terms) {
        const std::complex<double> amplitude = std::complex<double>(term.re, term.im)
            * weight({-term.decay_per_s, term.omega_rad_s});
        result.m_terms.push_back(
            {term.decay_per_s, term.omega_rad_s, amplitude.real(), amplitude.imag()});
    }
    return result;
}

double StepResponse::fastestPole_rad_s() const
{
    double fastest = 0.0;
    for (const Term &term : m_terms)
        fastest = std::max(fastest,
            std::sqrt(term.decay_per_s * term.decay_per_s + term.omega_rad_s * term.omega_rad_s));
    return fastest;
}

double StepResponse::at(double time_s) const
{
    if (time_s < 0.0)
        return 0.0;
    double value = m_constant;
    for (const Term &term : m_terms) {
        if (term.decay_per_s * time_s > kVanished)
            continue;
        const double envelope = portableExp(-term.decay_per_s * time_s);
        const SineCosine angle = portableSineCosine(term.omega_rad_s * time_s);
        value += envelope * (term.re * angle.cosine - term.im * angle.sine);
    }
    return value;
}

void StepResponse::addTo(
    std::span<double> values, double firstTime_s, double sampleRate_Hz, double scale) const
{
    const Index count = std::ssize(values);
    const double before = std::ceil(-firstTime_s * sampleRate_Hz);
    if (!(before < static_cast<double>(count)))
        return;
    const Index begin = std::max<Index>(0, static_cast<Index>(before));
    for (Index i = begin; i < count; ++i)
        values[static_cast<std::size_t>(i)] += scale * m_constant;
    for (const Term &term : m_terms) {
        const double factor = portableExp(-term.decay_per_s / sampleRate_Hz);
        const SineCosine turn = portableSineCosine(term.omega_rad_s / sampleRate_Hz);
        const double stepRe = factor * turn.cosine;
        const double stepIm = factor * turn.sine;
        for (Index anchor = begin; anchor < count; anchor += kAnchorDistance) {
            const double time_s = firstTime_s + static_cast<double>(anchor) / sampleRate_Hz;
            if (term.decay_per_s * time_s > kVanished)
                break;
            const double envelope = scale * portableExp(-term.decay_per_s * time_s);
            const SineCosine angle = portableSineCosine(term.omega_rad_s * time_s);
            double re = envelope * (term.re * angle.cosine - term.im * angle.sine);
            double im = envelope * (term.re * angle.sine + term.im * angle.cosine);
            const Index end = std::min(count, anchor + kAnchorDistance);
            for (Index i = anchor; i < end; ++i) {
                values[static_cast<std::size_t>(i)] += re;
                const double next = re * stepRe - im * stepIm;
                im = re * stepIm + im * stepRe;
                re = next;
            }
        }
    }
}

} // namespace dyncal
