// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/refinement/series_simulation.h"

#include "core/base/number_text.h"

#include <cmath>
#include <complex>

namespace dyncal {

Eigen::VectorXd simulate(const ModelSeries &series, const ExponentialSum &sum,
    const std::vector<NuisanceTerm> &terms, double dt_s)
{
    Eigen::VectorXd y = Eigen::VectorXd::Constant(series.y.size(), sum.constant);
    const auto add = [&](std::complex<double> s, std::complex<double> amplitude) {
        const std::complex<double> first = amplitude * series.filter.delayedGain(s, series.first_s);
        y += exponentials(s * dt_s, y.size()) * Eigen::Vector2d(first.real(), -first.imag());
    };
    for (Index i = 0; i < sum.poles_rad_s.size(); ++i)
        add(sum.poles_rad_s[i], sum.amplitudes[i]);
    for (const NuisanceTerm &term : terms)
        add(term.pole_rad_s, term.amplitude);
    return y;
}

double fitPercent(double errorSquares, double spreadSquares)
{
    return spreadSquares > 0.0 ? 100.0 * (1.0 - std::sqrt(errorSquares / spreadSquares)) : 0.0;
}

std::string fitPercentText(double percent)
{
    return numberText(std::round(10.0 * percent) / 10.0, 4);
}

double spreadSquares(const Eigen::VectorXd &y)
{
    return (y.array() - y.mean()).square().sum();
}

} // namespace dyncal
