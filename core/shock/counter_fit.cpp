// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/shock/counter_fit.h"

#include "core/base/number_text.h"
#include "core/shock/polynomial_fit.h"

#include <cmath>
#include <limits>

namespace dyncal {
namespace {

/// Mean velocities of the intervals and their middles.
struct Intervals
{
    Eigen::VectorXd middle_m;
    Eigen::VectorXd velocity_m_s;
    Eigen::VectorXd weight;
    bool stated = true;
};

Intervals intervalsOf(const std::vector<CounterReading> &readings)
{
    const Index count = std::ssize(readings);
    Intervals intervals{
        Eigen::VectorXd(count), Eigen::VectorXd(count), Eigen::VectorXd::Ones(count), true};
    for (Index i = 0; i < count; ++i) {
        const CounterReading &r = readings[static_cast<std::size_t>(i)];
        const double length_m = r.far_m - r.near_m;
        intervals.middle_m[i] = 0.5 * (r.far_m + r.near_m);
        intervals.velocity_m_s[i] = length_m / r.time_s;
        const double u = intervals.velocity_m_s[i]
            * std::hypot(r.u_distance_m / length_m, r.u_time_s / r.time_s);
        intervals.stated = intervals.stated && r.u_distance_m > 0.0;
        intervals.weight[i] = 1.0 / (u * u);
    }
    if (!intervals.stated)
        intervals.weight.setOnes();
    return intervals;
}

/// u of a coefficient from the readings alone, whose inverse variances are `weight`.
double uOf(const Polynomial &line, Index coefficient, const Eigen::VectorXd &weight)
{
    return std::sqrt(
        line.gain.row(coefficient).transpose().cwiseAbs2().cwiseQuotient(weight).sum());
}

VelocityFit describedCounters(const Polynomial &line, const Intervals &intervals, Index dof)
{
    VelocityFit fit;
    fit.velocity_m_s = line.coefficients[0];
    fit.arrivalAtWall_s = std::numeric_limits<double>::quiet_NaN();
    fit.attenuated = line.coefficients.size() > 1;
    fit.residual = line.residual;
    fit.weight = intervals.weight;
    fit.dof = dof;
    if (intervals.stated && dof > 0)
        fit.chiSquare = line.squares;
    fit.scatterEstimated = !intervals.stated && dof > 0;
    return fit;
}

VelocityFit countersAlone(const Intervals &intervals, Index parameters)
{
    const Polynomial line
        = fitPolynomial(intervals.middle_m, intervals.velocity_m_s, intervals.weight, parameters);
    const Index dof = intervals.weight.size() - parameters;
    VelocityFit fit = describedCounters(line, intervals, dof);
    const double factor
        = intervals.stated || dof <= 0 ? 1.0 : std::sqrt(line.squares / static_cast<double>(dof));
    if (fit.scatterEstimated)
        fit.scatter_m_s = factor * uOf(line, 0, intervals.weight);
    if (parameters > 1) {
        fit.gradient_per_s = line.coefficients[1];
        if (intervals.stated || dof > 0)
            fit.u_gradient_per_s = factor * uOf(line, 1, intervals.weight);
    }
    return fit;
}

/// Unstated intervals weigh by their scatter about a line of the slope that is likely beforehand.
void weighByScatter(Intervals &intervals, double slope)
{
    const Index count = intervals.middle_m.size();
    const Eigen::VectorXd level = intervals.velocity_m_s - slope * intervals.middle_m;
    const double least = 1e-9 * intervals.velocity_m_s.mean();
    const double squares = (level.array() - level.mean()).square().sum();
    const double scatter = count > 1 ? std::sqrt(squares / static_cast<double>(count - 1)) : least;
    intervals.weight.setConstant(1.0 / std::pow(std::max(scatter, least), 2));
}

VelocityFit countersWithRange(Intervals intervals, const Interval &range_per_m)
{
    const double first_m_s = intervals.velocity_m_s.mean();
    const AttenuationObservation observed{range_per_m, first_m_s};
    const double slope = observed.scale * observed.value_per_m();
    if (!intervals.stated)
        weighByScatter(intervals, slope);
    const double u_slope = observed.scale * observed.u_per_m();
    const Polynomial line = fitPolynomial(intervals.middle_m, intervals.velocity_m_s,
        intervals.weight, 2, CoefficientPrior{slope, 1.0 / (u_slope * u_slope)});
    VelocityFit fit = describedCounters(line, intervals, intervals.weight.size() - 1);
    fit.attenuation = observed;
    if (fit.scatterEstimated)
        fit.scatter_m_s = uOf(line, 0, intervals.weight);
    if (distinctPlaces(intervals.middle_m) < 2)
        return fit;
    fit.gradient_per_s = line.coefficients[1];
    if (intervals.stated || fit.scatterEstimated)
        fit.u_gradient_per_s = std::sqrt(line.covariance(1, 1));
    const Polynomial alone
        = fitPolynomial(intervals.middle_m, intervals.velocity_m_s, intervals.weight, 2);
    fit.seenAttenuation_per_m = alone.coefficients[1] / alone.coefficients[0];
    fit.u_seenAttenuation_per_m = std::sqrt(alone.covariance(1, 1)) / alone.coefficients[0];
    return fit;
}

} // namespace

Result<VelocityFit> fitCounters(const std::vector<CounterReading> &readings,
    Attenuation attenuation, const Interval &range_per_m)
{
    for (const CounterReading &r : readings) {
        const bool isFinite = std::isfinite(r.far_m) && std::isfinite(r.time_s);
        if (!(isFinite && r.far_m > r.near_m && r.near_m >= 0.0 && r.time_s > 0.0))
            return fail(ErrorKind::Usage,
                Message{
                    DYNCAL_TEXT("core",
                        "A counter reads %1 s from %2 m to %3 m before the end wall; the time must be above 0 and the first distance the larger one."),
                    {numberText(r.time_s), numberText(r.far_m), numberText(r.near_m)}});
    }
    if (readings.empty())
        return fail(
            ErrorKind::Usage, Message{DYNCAL_TEXT("core", "There is no counter reading."), {}});
    const Intervals intervals = intervalsOf(readings);
    if (attenuation == Attenuation::Automatic)
        return countersWithRange(intervals, range_per_m);
    const bool bent = attenuation == Attenuation::Linear && distinctPlaces(intervals.middle_m) >= 2;
    return countersAlone(intervals, bent ? 2 : 1);
}

double refittedCounterVelocity_m_s(
    const VelocityFit &fit, const std::vector<CounterReading> &readings, double attenuation_per_m)
{
    const Intervals intervals = intervalsOf(readings);
    std::optional<CoefficientPrior> prior;
    if (fit.attenuation) {
        const double u = fit.attenuation->scale * fit.attenuation->u_per_m();
        prior = CoefficientPrior{fit.attenuation->scale * attenuation_per_m, 1.0 / (u * u)};
    }
    return fitPolynomial(
        intervals.middle_m, intervals.velocity_m_s, fit.weight, fit.attenuated ? 2 : 1, prior)
        .coefficients[0];
}

} // namespace dyncal
