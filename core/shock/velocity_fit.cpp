// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/shock/velocity_fit.h"

#include "core/base/number_text.h"
#include "core/shock/polynomial_fit.h"

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

/// Times over distances: slowness at the wall and what follows.
struct Line
{
    Polynomial polynomial;
    double velocity() const { return -1.0 / polynomial.coefficients[1]; }
    double gradient() const
    {
        return polynomial.coefficients.size() < 3
            ? 0.0
            : 2.0 * polynomial.coefficients[2] * velocity() * velocity();
    }
    double u_gradient() const
    {
        return 2.0 * std::sqrt(polynomial.covariance(2, 2)) * velocity() * velocity();
    }
    /// u(W) from the arrivals alone, whose inverse variances are `weight`.
    double u_velocity(const Eigen::VectorXd &weight) const
    {
        const double variance
            = polynomial.gain.row(1).transpose().cwiseAbs2().cwiseQuotient(weight).sum();
        return std::sqrt(variance) * velocity() * velocity();
    }
};

/// Places and times as vectors; times count from the first, as the record may start anywhere.
struct Arrivals
{
    Eigen::VectorXd x;
    Eigen::VectorXd t;
    double origin_s = 0.0;

    explicit Arrivals(const std::vector<Sighting> &sightings)
        : x(std::ssize(sightings))
        , t(std::ssize(sightings))
    {
        for (Index i = 0; i < x.size(); ++i) {
            x[i] = sightings[static_cast<std::size_t>(i)].distance_m;
            t[i] = sightings[static_cast<std::size_t>(i)].time_s;
        }
        origin_s = t.size() > 0 ? t[0] : 0.0;
        t.array() -= origin_s;
    }
};

bool everyUncertaintyIsStated(const std::vector<Sighting> &sightings)
{
    return std::all_of(sightings.begin(), sightings.end(), [](const Sighting &s) {
        const bool atWall = s.isDut && s.distance_m == 0.0;
        return s.u_distance_m > 0.0 || (atWall && (s.u_time_s > 0.0 || s.u_delay_s > 0.0));
    });
}

/// Inverse variances of the times; u of a distance becomes one of time by a first estimate of the
/// velocity.
Eigen::VectorXd statedWeights(const std::vector<Sighting> &sightings, double velocity_m_s)
{
    Eigen::VectorXd weight(std::ssize(sightings));
    for (Index i = 0; i < weight.size(); ++i) {
        const Sighting &s = sightings[static_cast<std::size_t>(i)];
        const double u_place_s = s.u_distance_m / velocity_m_s;
        weight[i]
            = 1.0 / (s.u_time_s * s.u_time_s + s.u_delay_s * s.u_delay_s + u_place_s * u_place_s);
    }
    // A place known a million times better than another is as good as exact; larger ratios would
    // cost digits.
    return weight.cwiseMin(1e12 * weight.minCoeff());
}

Error notTowardsTheWall(const std::vector<Sighting> &sightings, double velocity_m_s)
{
    const auto byDistance
        = [](const Sighting &a, const Sighting &b) { return a.distance_m < b.distance_m; };
    const auto [nearest, farthest]
        = std::minmax_element(sightings.begin(), sightings.end(), byDistance);
    return {ErrorKind::DataBlocked,
        Message{
            DYNCAL_TEXT("core",
                "The arrivals from '%1' to '%2' give a velocity of %3 m/s; the shock must run towards the end wall: check channels, distances and arrivals."),
            {farthest->channel, nearest->channel, numberText(velocity_m_s, 4)}},
        "SHK-001"};
}

/// Fills in everything that follows from the chosen line; `dof` are those of its residuals.
VelocityFit described(
    const Line &line, const Arrivals &seen, const Eigen::VectorXd &weight, bool stated, Index dof)
{
    VelocityFit fit;
    fit.velocity_m_s = line.velocity();
    fit.arrivalAtWall_s = line.polynomial.coefficients[0] + seen.origin_s;
    fit.attenuated = line.polynomial.coefficients.size() > 2;
    fit.residual = line.polynomial.residual;
    fit.weight = weight;
    fit.dof = dof;
    if (stated && dof > 0)
        fit.chiSquare = line.polynomial.squares;
    fit.scatterEstimated = !stated && dof > 0;
    return fit;
}

/// Without prior knowledge; the scatter of unstated uncertainties is that of the residuals.
VelocityFit fittedAlone(
    const Arrivals &seen, const Eigen::VectorXd &weight, bool stated, Index parameters)
{
    const Line line{fitPolynomial(seen.x, seen.t, weight, parameters)};
    const Index dof = seen.x.size() - parameters;
    VelocityFit fit = described(line, seen, weight, stated, dof);
    const double factor
        = stated || dof <= 0 ? 1.0 : std::sqrt(line.polynomial.squares / static_cast<double>(dof));
    if (fit.scatterEstimated)
        fit.scatter_m_s = factor * line.u_velocity(weight);
    if (parameters > 2) {
        fit.gradient_per_s = line.gradient();
        if (stated || dof > 0)
            fit.u_gradient_per_s = factor * line.u_gradient();
    }
    return fit;
}

/// Inverse variances from the scatter about a line of the curvature that is likely beforehand.
Eigen::VectorXd scatterWeights(const Arrivals &seen, double curvature_s_m2)
{
    const Index dof = seen.x.size() - 2;
    const Eigen::VectorXd straightened = seen.t - curvature_s_m2 * seen.x.cwiseAbs2();
    const Eigen::VectorXd one = Eigen::VectorXd::Ones(seen.x.size());
    const double squares = fitPolynomial(seen.x, straightened, one, 2).squares;
    // Arrivals that agree to the last digit are still no better than their clock.
    const double least_s = 1e-9 * (seen.t.maxCoeff() - seen.t.minCoeff());
    const double scatter_s = dof > 0 ? std::sqrt(squares / static_cast<double>(dof)) : 0.0;
    return one / std::pow(std::max(scatter_s, least_s), 2);
}

VelocityFit fittedWithRange(const Arrivals &seen, const std::vector<Sighting> &sightings,
    double first_m_s, const Interval &range_per_m)
{
    const AttenuationObservation observed{range_per_m, 0.5 / first_m_s};
    const double curvature = observed.scale * observed.value_per_m();
    const bool stated = everyUncertaintyIsStated(sightings);
    const Eigen::VectorXd weight
        = stated ? statedWeights(sightings, first_m_s) : scatterWeights(seen, curvature);
    const double u_curvature = observed.scale * observed.u_per_m();
    const Line line{fitPolynomial(
        seen.x, seen.t, weight, 3, CoefficientPrior{curvature, 1.0 / (u_curvature * u_curvature)})};
    VelocityFit fit = described(line, seen, weight, stated, seen.x.size() - 2);
    fit.attenuation = observed;
    if (fit.scatterEstimated)
        fit.scatter_m_s = line.u_velocity(weight);
    if (distinctPlaces(seen.x) < 3)
        return fit;
    fit.gradient_per_s = line.gradient();
    if (stated || fit.scatterEstimated)
        fit.u_gradient_per_s = line.u_gradient();
    const VelocityFit alone = fittedAlone(seen, weight, true, 3);
    fit.seenAttenuation_per_m = *alone.gradient_per_s / alone.velocity_m_s;
    fit.u_seenAttenuation_per_m = *alone.u_gradient_per_s / alone.velocity_m_s;
    return fit;
}

VelocityFit fittedWithout(const Arrivals &seen, const std::vector<Sighting> &sightings,
    double first_m_s, Attenuation attenuation)
{
    const bool stated = everyUncertaintyIsStated(sightings);
    const Eigen::VectorXd weight = stated ? statedWeights(sightings, first_m_s)
                                          : Eigen::VectorXd::Ones(seen.x.size()).eval();
    VelocityFit straight = fittedAlone(seen, weight, stated, 2);
    if (distinctPlaces(seen.x) < 3 || attenuation == Attenuation::None)
        return straight;
    VelocityFit bent = fittedAlone(seen, weight, stated, 3);
    const bool known = stated || bent.scatterEstimated;
    if (known && bent.velocity_m_s > 0.0)
        return bent;
    straight.gradient_per_s = bent.gradient_per_s;
    straight.u_gradient_per_s = bent.u_gradient_per_s;
    return straight;
}

} // namespace

double AttenuationObservation::u_per_m() const
{
    return range_per_m.length() / std::sqrt(12.0);
}

Result<VelocityFit> fitVelocity(
    const std::vector<Sighting> &sightings, Attenuation attenuation, const Interval &range_per_m)
{
    const Arrivals seen(sightings);
    if (seen.x.size() < 2 || seen.x.maxCoeff() == seen.x.minCoeff())
        return fail(ErrorKind::Usage,
            Message{DYNCAL_TEXT(
                        "core", "A velocity needs arrivals at two places at least; there are %1."),
                {std::to_string(std::min<Index>(seen.x.size(), 1))}});
    const Line first{fitPolynomial(seen.x, seen.t, Eigen::VectorXd::Ones(seen.x.size()), 2)};
    if (!(first.velocity() > 0.0 && std::isfinite(first.velocity())))
        return tl::unexpected(notTowardsTheWall(sightings, first.velocity()));
    return attenuation == Attenuation::Automatic
        ? fittedWithRange(seen, sightings, first.velocity(), range_per_m)
        : fittedWithout(seen, sightings, first.velocity(), attenuation);
}

RefittedWay refittedWay(const VelocityFit &fit, const Eigen::VectorXd &distance_m,
    const Eigen::VectorXd &time_s, double attenuation_per_m)
{
    const Eigen::VectorXd since = time_s.array() - time_s[0];
    std::optional<CoefficientPrior> prior;
    if (fit.attenuation) {
        const double u = fit.attenuation->scale * fit.attenuation->u_per_m();
        prior = CoefficientPrior{fit.attenuation->scale * attenuation_per_m, 1.0 / (u * u)};
    }
    const Line line{
        fitPolynomial(distance_m, since, fit.weight, prior || fit.attenuated ? 3 : 2, prior)};
    return {line.velocity(), line.gradient() / line.velocity()};
}

double refittedVelocity_m_s(const VelocityFit &fit, const Eigen::VectorXd &distance_m,
    const Eigen::VectorXd &time_s, double attenuation_per_m)
{
    return refittedWay(fit, distance_m, time_s, attenuation_per_m).velocity_m_s;
}

} // namespace dyncal
