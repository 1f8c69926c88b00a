// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/selftest/checks_of_draws.h"

#include "core/base/input_draws.h"
#include "core/monte_carlo/coverage_interval.h"
#include "core/monte_carlo/source_draws.h"

#include <cmath>

namespace dyncal {
namespace {

constexpr const char *kChain = "monte_carlo_of_the_chain";
constexpr Index kSums = 50000;

/// Four inputs of 0 with u = 1, even within +-sqrt(3); their sums.
DrawnQuantity sumsOfFour(DataChange &change)
{
    SourceDraws sources;
    std::vector<DrawnInput> inputs;
    for (const char *name : {"x1", "x2", "x3", "x4"}) {
        const UncertainInput input{name, 0.0, change(1.0), Distribution::Rectangular};
        inputs.push_back({input, sources.add(input)});
    }
    Eigen::VectorXd sums = Eigen::VectorXd::Zero(kSums);
    for (Index trial = 0; trial < kSums; ++trial) {
        const Eigen::VectorXd probabilities = sources.probabilities(1, trial);
        for (const DrawnInput &input : inputs)
            sums[trial] += input.value(probabilities);
    }
    return drawnQuantity(sums, 0.0, 0.95);
}

double uOfSums(DataChange &change)
{
    return sumsOfFour(change).u;
}

double upperEndOfSums(DataChange &change)
{
    return sumsOfFour(change).high;
}

double expandedOfSums(DataChange &change)
{
    return sumsOfFour(change).expanded;
}

double toleranceOfU(DataChange &change)
{
    return numericalTolerance(change(0.35), 1);
}

/// Of a sum of four numbers even in 0 to 1 the chance to be above 4 - t is t^4/24, t up to 1.
double endOfFour()
{
    const double t = std::pow(24.0 * 0.025, 0.25);
    return (2.0 - t) * 2.0 * std::sqrt(3.0);
}

} // namespace

std::vector<CheckSpec> checksOfDraws()
{
    const Message even{
        DYNCAL_TEXT("core", "distribution of a sum of four even ones, closed form (JCGM 101, 9.2)"),
        {}};
    constexpr double kOfEnd
        = 0.09; // some four standard deviations of what so many draws leave open
    constexpr double kOfSpread = 0.025;
    return {{kChain, {DYNCAL_TEXT("core", "u of 50000 sums"), {}}, even, 2.0, kOfSpread, uOfSums},
        {kChain, {DYNCAL_TEXT("core", "upper end of their 95 % interval"), {}}, even, endOfFour(),
            kOfEnd, upperEndOfSums},
        {kChain, {DYNCAL_TEXT("core", "half width about 0 that holds 95 %"), {}}, even, endOfFour(),
            kOfEnd, expandedOfSums},
        {kChain, {DYNCAL_TEXT("core", "tolerance of u = 0.35, one digit"), {}},
            {DYNCAL_TEXT("core", "JCGM 101, 7.9.2"), {}}, 0.05, 1e-12, toleranceOfU}};
}

} // namespace dyncal
