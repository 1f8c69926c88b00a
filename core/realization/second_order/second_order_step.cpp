// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/second_order/second_order_step.h"

#include "core/realization/exponentials/front.h"

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

using Complex = std::complex<double>;
constexpr double kCriticalDistance = 1e-4; ///< of zeta from 1

} // namespace

void SecondOrderStep::setParameters(const Eigen::VectorXd &values)
{
    logOmega = values[0];
    logZeta = values[1];
    Index at = 2;
    if (drift)
        drift->rate = values[at++];
    plateau = values[at++];
    onset = values[at++];
    if (drift)
        drift->amplitude = values[at++];
    for (Mode &mode : modes) {
        mode.pole = {values[at], values[at + 1]};
        mode.amplitude = {values[at + 2], values[at + 3]};
        at += 4;
    }
}

Eigen::VectorXd SecondOrderStep::parameterValues() const
{
    Eigen::VectorXd values(parameters());
    values.head(2) << logOmega, logZeta;
    Index at = 2;
    if (drift)
        values[at++] = drift->rate;
    values[at++] = plateau;
    values[at++] = onset;
    if (drift)
        values[at++] = drift->amplitude;
    for (const Mode &mode : modes) {
        values.segment(at, 4) << mode.pole.real(), mode.pole.imag(), mode.amplitude.real(),
            mode.amplitude.imag();
        at += 4;
    }
    return values;
}

double SecondOrderStep::zeta() const
{
    const double free = std::exp(logZeta);
    if (std::abs(free - 1.0) >= kCriticalDistance)
        return free;
    return free < 1.0 ? 1.0 - kCriticalDistance : 1.0 + kCriticalDistance;
}

Complex SecondOrderStep::gainAt(Complex s) const
{
    const Complex r = s / std::exp(logOmega);
    return plateau / (r * r + 2.0 * zeta() * r + 1.0);
}

Complex SecondOrderStep::factorOfPressure(Complex s) const
{
    Complex factor = frontFactor(front, s);
    if (drift)
        factor += s * drift->amplitude / gainAt(drift->rate) / (s - drift->rate);
    for (const Mode &mode : modes) {
        if (!mode.startsWithStep)
            continue;
        const Complex pressure = mode.amplitude * std::exp(mode.pole * onset) / gainAt(mode.pole);
        factor += 0.5 * s
            * (pressure / (s - mode.pole) + std::conj(pressure) / (s - std::conj(mode.pole)));
    }
    return factor;
}

Eigen::VectorXd SecondOrderStep::exponentials() const
{
    const double omega = std::exp(logOmega);
    const double damping = zeta();
    const Index first = drifts(); // of the sensor's poles
    const Index gains = first + 2 + 2 * std::ssize(modes);
    Eigen::VectorXd x(2 * gains + 1);
    if (drift) {
        x[0] = drift->rate;
        x[gains] = drift->amplitude * std::exp(-drift->rate * onset);
    }
    if (damping < 1.0) {
        const double root = std::sqrt((1.0 - damping) * (1.0 + damping));
        const Complex s(-damping * omega, root * omega);
        const Complex g
            = -plateau * Complex(1.0, -damping / root) * std::exp(-s * onset) * factorOfPressure(s);
        x.segment(first, 2) << s.real(), s.imag();
        x.segment(gains + first, 2) << g.real(), g.imag();
    } else {
        const double root = std::sqrt((damping - 1.0) * (damping + 1.0));
        const double slow = -omega / (damping + root);
        const double fast = -omega * (damping + root);
        const double unit = plateau / (fast - slow);
        x.segment(first, 2) << slow, fast;
        x.segment(gains + first, 2)
            << -unit * fast * std::exp(-slow * onset) * factorOfPressure(slow).real(),
            unit * slow * std::exp(-fast * onset) * factorOfPressure(fast).real();
    }
    Index at = first + 2;
    for (const Mode &mode : modes) {
        x.segment(at, 2) << mode.pole.real(), mode.pole.imag();
        x.segment(gains + at, 2) << mode.amplitude.real(), mode.amplitude.imag();
        at += 2;
    }
    x.tail(1) << plateau;
    return x;
}

Eigen::MatrixXd SecondOrderStep::derivatives() const
{
    constexpr double kStep = 1e-6;
    constexpr double kSmallest = 1e-30;
    const Eigen::VectorXd here = parameterValues();
    const double ofGain = kStep * std::max(kSmallest, std::abs(plateau));
    Eigen::VectorXd steps = Eigen::VectorXd::Constant(here.size(), kStep);
    const Index own = 2 + drifts(); // where the record's own parameters begin
    steps[own] = ofGain;
    if (drift) {
        steps[2] = kStep * std::max(kSmallest, std::abs(drift->rate));
        steps[own + 2] = ofGain;
    }
    for (std::size_t i = 0; i < modes.size(); ++i) {
        const Index at = own + 2 + drifts() + 4 * static_cast<Index>(i);
        steps.segment(at, 2).setConstant(kStep * std::max(kSmallest, std::abs(modes[i].pole)));
        steps.segment(at + 2, 2).setConstant(ofGain);
    }
    Eigen::MatrixXd J(exponentials().size(), here.size());
    SecondOrderStep moved = *this;
    const auto at = [&](Index column, double step) {
        Eigen::VectorXd values = here;
        values[column] += step;
        moved.setParameters(values);
        return moved.exponentials();
    };
    for (Index i = 0; i < here.size(); ++i)
        J.col(i) = (at(i, steps[i]) - at(i, -steps[i])) / (2.0 * steps[i]);
    return J;
}

} // namespace dyncal
