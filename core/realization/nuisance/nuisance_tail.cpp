// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/nuisance/nuisance_tail.h"

#include "core/base/constants.h"
#include "core/base/least_squares.h"
#include "core/realization/refinement/pole_refinement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>

namespace dyncal {
namespace {

constexpr double kPerPeriod = 24.0; ///< samples of the search, at the fastest mode
constexpr double kPresent = 20.0; ///< decrease of the squares over their mean; noise gives far less
constexpr std::array kDampings{0.0, 0.005, 0.015, 0.04, 0.1, 0.2};

/// Fits constant and amplitudes for these poles; returns the sum of squares left.
double fitTail(const NuisanceTail &tail, std::vector<NuisanceTerm> &terms)
{
    const Index modes = std::ssize(terms);
    Eigen::MatrixXd basis(tail.count(), 1 + 2 * modes);
    Eigen::VectorXd y(tail.count());
    Index row = 0;
    for (const SampleRange &range : tail.used) {
        for (Index k = range.begin; k < range.end; ++k, ++row) {
            const double t_s = tail.begin_s + static_cast<double>(k) * tail.step_s;
            y[row] = tail.y[k];
            basis(row, 0) = 1.0;
            for (Index i = 0; i < modes; ++i) {
                const std::complex<double> power
                    = std::exp(terms[static_cast<std::size_t>(i)].pole_rad_s * t_s);
                basis(row, 1 + 2 * i) = power.real();
                basis(row, 2 + 2 * i) = -power.imag();
            }
        }
    }
    const Eigen::VectorXd x = leastSquares(basis, y);
    for (Index i = 0; i < modes; ++i)
        terms[static_cast<std::size_t>(i)].amplitude = {x[1 + 2 * i], x[2 + 2 * i]};
    return (y - basis * x).squaredNorm();
}

std::complex<double> poleFrom(double frequency_Hz, double zeta)
{
    return kTwoPi * frequency_Hz * std::complex<double>(-zeta, std::sqrt(1.0 - zeta * zeta));
}

} // namespace

NuisanceTail tailOf(const ModelSeries &series, double begin_s, double fastest_Hz)
{
    const Index begin = static_cast<Index>(begin_s * series.fullRate_Hz);
    const Index block
        = std::max<Index>(1, static_cast<Index>(series.fullRate_Hz / (kPerPeriod * fastest_Hz)));
    const Index count = (series.fullRate.size() - begin) / block;
    NuisanceTail tail{
        Eigen::VectorXd(count), {}, 0.0, static_cast<double>(block) / series.fullRate_Hz};
    for (Index k = 0; k < count; ++k) {
        const SampleRange samples{begin + k * block, begin + (k + 1) * block};
        tail.y[k] = series.fullRate.segment(samples.begin, block).mean();
        const bool isWhole = std::none_of(series.leftOut.begin(), series.leftOut.end(),
            [&](const LeftOut &part) { return part.samples.overlaps(samples); });
        if (isWhole && !tail.used.empty() && tail.used.back().end == k)
            ++tail.used.back().end;
        else if (isWhole)
            tail.used.push_back({k, k + 1});
    }
    tail.begin_s
        = (static_cast<double>(begin) + 0.5 * static_cast<double>(block - 1)) / series.fullRate_Hz;
    return tail;
}

bool addBestTerm(const NuisanceTail &tail, const NuisanceCandidate &candidate, bool startsWithStep,
    std::vector<NuisanceTerm> &terms)
{
    const double before = fitTail(tail, terms);
    const double periods
        = candidate.frequency_Hz * tail.step_s * static_cast<double>(tail.y.size());
    const double reach = std::clamp(0.5 / periods, 0.03, 0.15);
    const int steps = std::max(2, static_cast<int>(std::ceil(reach * periods * 8.0)));
    std::vector<NuisanceTerm> best;
    double least = before;
    for (int step = -steps; step <= steps; ++step) {
        const double f_Hz = candidate.frequency_Hz * (1.0 + reach * step / steps);
        for (const double zeta : kDampings) {
            std::vector<NuisanceTerm> tried = terms;
            tried.push_back({candidate.mode, startsWithStep, poleFrom(f_Hz, zeta), 0.0});
            const double left = fitTail(tail, tried);
            if (left < least) {
                least = left;
                best = std::move(tried);
            }
        }
    }
    const double freedom = static_cast<double>(tail.count() - 5 - 2 * std::ssize(terms));
    if (best.empty() || !(freedom > 0.0) || !((before - least) * freedom > kPresent * least))
        return false;
    terms = std::move(best);
    return true;
}

void polish(const NuisanceTail &tail, bool withConstant, std::vector<NuisanceTerm> &terms)
{
    const auto fit
        = refinePoles({{tail.y, 1.0 / tail.step_s, 1.0, terms, tail.used}}, {}, withConstant);
    if (!fit)
        return;
    terms = fit->nuisance.front();
    for (NuisanceTerm &term : terms)
        term.amplitude *= std::exp(-term.pole_rad_s * tail.begin_s);
}

} // namespace dyncal
