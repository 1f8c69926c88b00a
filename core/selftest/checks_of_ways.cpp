// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/selftest/checks_of_ways.h"

#include "core/base/constants.h"
#include "core/base/propagation.h"
#include "core/consistency/way_comparison.h"
#include "core/uncertainty/transducer_comparison.h"

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

WayComparison twoWays(DataChange &change)
{
    WayComparison ways;
    ways.value_a = change(12.0);
    ways.value_b = change(9.0);
    ways.u = change(0.75);
    return ways;
}

double normalizedError(DataChange &change)
{
    return twoWays(change).e_n();
}

double smallestFaultFound(DataChange &change)
{
    return twoWays(change).smallestDetectable();
}

/// Contradictions found among differences of 3.5 and 3.7 standard uncertainties.
double contradictionsFound(DataChange &change)
{
    WayComparison ways;
    ways.value_b = 0.0;
    ways.u = change(1.0);
    double count = 0.0;
    for (const double difference : {3.5, 3.7}) {
        ways.value_a = change(difference);
        count += ways.agrees() ? 0.0 : 1.0;
    }
    return count;
}

/// Three rows S = value with common parts of u.
UncertainResponse knownAnswer(DataChange &change, double value, double u_relative)
{
    UncertainResponse answer;
    ResponseResult &r = answer.response;
    r.frequency_Hz = Eigen::Vector3d(1e3, 1e4, 1e5);
    r.magnitude = change(Eigen::VectorXd::Constant(3, value));
    r.u_magnitude = r.u_noiseMagnitude = 1e-9 * r.magnitude;
    r.u_frontMagnitude = r.u_referenceMagnitude = r.boundEnd = r.boundAlias
        = Eigen::Vector3d::Zero();
    r.dof = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
    r.unit = "V/Pa";
    answer.report.rows.u_common_relative = change(u_relative);
    answer.report.rows.common = {directLine("source", answer.report.rows.u_common_relative)};
    return answer;
}

/// 2 against 2.04, u 0.3 % and 0.4 % independent.
std::optional<StepAgainstTransducer> knownComparison(DataChange &change)
{
    UncertainResponse byTransducer = knownAnswer(change, 2.0, 0.003);
    byTransducer.response.isByTransducer = true;
    byTransducer.report.rows.common.front().quantity = "reference_gain_relative";
    UncertainResponse byStep = knownAnswer(change, 2.04, 0.004);
    byStep.report.rows.common.front().quantity = "velocity_m_s";
    return compareWithStep(byTransducer, byStep, 0.0);
}

double comparedDifference_relative(DataChange &change)
{
    const auto comparison = knownComparison(change);
    return comparison ? comparison->difference_relative : kUnknown;
}

double comparedUncertainty_relative(DataChange &change)
{
    const auto comparison = knownComparison(change);
    return comparison ? comparison->u_relative : kUnknown;
}

/// 2 a - b, a normal (1; 0.3), b rectangular (0; 0.8), in 20000 trials.
std::optional<MonteCarloResult> knownDraws(DataChange &change)
{
    const std::vector<UncertainInput> inputs{
        {"a", change(1.0), change(0.3)}, {"b", 0.0, change(0.8), Distribution::Rectangular}};
    MonteCarloSettings settings;
    settings.trials = 20000;
    settings.seed = 11;
    const auto draws = propagateMonteCarlo(
        inputs,
        [](const Eigen::VectorXd &x) -> Result<Eigen::VectorXd> {
            return Eigen::VectorXd::Constant(1, 2.0 * x[0] - x[1]);
        },
        settings);
    return draws ? std::optional(*draws) : std::nullopt;
}

double meanOfDraws(DataChange &change)
{
    const auto draws = knownDraws(change);
    return draws ? draws->mean[0] : kUnknown;
}

double deviationOfDraws(DataChange &change)
{
    const auto draws = knownDraws(change);
    return draws ? draws->u[0] : kUnknown;
}

} // namespace

std::vector<CheckSpec> checksOfWays()
{
    const Message hand{DYNCAL_TEXT("core", "by hand"), {}};
    const Message sums{
        DYNCAL_TEXT("core", "exact moments; four standard deviations of so many draws"), {}};
    const double u = std::hypot(0.6, 0.8), trials = 20000.0;
    return {{"checks", {DYNCAL_TEXT("core", "E_n of 12 and 9, u = 0.75"), {}}, hand, 2.0, 1e-12,
                normalizedError},
        {"checks", {DYNCAL_TEXT("core", "smallest fault that is found, u = 0.75"), {}}, hand,
            0.75 * (3.6 + 1.2816), 1e-12, smallestFaultFound},
        {"checks", {DYNCAL_TEXT("core", "contradictions among 3.5 u and 3.7 u"), {}}, hand, 1.0,
            0.1, contradictionsFound},
        {"comparison", {DYNCAL_TEXT("core", "mean difference of two responses, relative"), {}},
            hand, 0.04 / 2.02, 1e-6, comparedDifference_relative},
        {"comparison", {DYNCAL_TEXT("core", "u of that difference"), {}}, hand, 0.005, 1e-6,
            comparedUncertainty_relative},
        {"monte_carlo", {DYNCAL_TEXT("core", "mean of 20000 draws"), {}}, sums, 2.0,
            4.0 * u / std::sqrt(trials), meanOfDraws},
        {"monte_carlo", {DYNCAL_TEXT("core", "standard deviation of 20000 draws"), {}}, sums, u,
            4.0 * u / std::sqrt(2.0 * trials), deviationOfDraws}};
}

} // namespace dyncal
