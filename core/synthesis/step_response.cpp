// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/synthesis/step_response.h"

#include "core/base/portable_math.h"
#include "core/synthesis/sensor_poles.h"

#include <algorithm>
#include <cmath>
#include <complex>

namespace dyncal {
namespace {

constexpr Index kAnchorDistance = 1024;
constexpr double kVanished = 60.0; ///< decay times after which a term is below 1e-26

} // namespace

StepResponse::StepResponse(const SensorSpec &sensor, double relaxation_s)
{
    for (const SensorMode &mode : sensor.modes)
        addMode(sensor, mode, relaxation_s);
}

void StepResponse::addMode(const SensorSpec &sensor, const SensorMode &mode, double relaxation_s)
{
    std::vector<std::complex<double>> poles = modePoles(mode);
    const double omega0 = kTwoPi * mode.f0_Hz;
    double gain = mode.weight * omega0 * omega0;
    if (sensor.realPole_Hz) {
        poles.emplace_back(-kTwoPi * *sensor.realPole_Hz, 0.0);
        gain *= kTwoPi * *sensor.realPole_Hz;
    }
    if (relaxation_s > 0.0) {
        poles.emplace_back(-1.0 / relaxation_s, 0.0);
        gain /= relaxation_s;
    }
    // The step's pole at 0, or AC coupling's: its zero at 0 cancels that of the step.
    poles.emplace_back(sensor.acCoupling_s ? -1.0 / *sensor.acCoupling_s : 0.0, 0.0);

    for (std::size_t i = 0; i < poles.size(); ++i) {
        if (poles[i].imag() < 0.0)
            continue; // half of a pair: in its partner's real part
        std::complex<double> product(1.0, 0.0);
        for (std::size_t j = 0; j < poles.size(); ++j) {
            if (j != i)
                product *= poles[i] - poles[j];
        }
        const double scale = (poles[i].imag() > 0.0 ? 2.0 : 1.0) * gain / std::norm(product);
        const Term term{
            -poles[i].real(), poles[i].imag(), scale * product.real(), -scale * product.imag()};
        if (term.decay_per_s == 0.0)
            m_constant += term.re;
        else
            m_terms.push_back(term);
    }
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
