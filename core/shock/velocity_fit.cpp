// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/shock/velocity_fit.h"

#include "core/base/distributions.h"
#include "core/base/number_text.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <limits>

namespace dyncal {
namespace {

constexpr double kSignificance = 0.99865; ///< one-sided, as 3 sigma of a normal distribution

/// Polynomial of degree `parameters` - 1 through y over x, weighted; coefficients and covariance
/// for weights that are inverse variances.
struct Polynomial
{
    Eigen::VectorXd coefficients; ///< ascending
    Eigen::MatrixXd covariance;
    Eigen::VectorXd residual;
};

Polynomial fitPolynomial(const Eigen::VectorXd &x, const Eigen::VectorXd &y,
    const Eigen::VectorXd &weight, Index parameters)
{
    Eigen::MatrixXd powers(x.size(), parameters);
    powers.col(0).setOnes();
    for (Index k = 1; k < parameters; ++k)
        powers.col(k) = powers.col(k - 1).cwiseProduct(x);
    const Eigen::VectorXd root = weight.cwiseSqrt();
    const Eigen::MatrixXd weighted = root.asDiagonal() * powers;
    const Eigen::HouseholderQR<Eigen::MatrixXd> qr(weighted);
    Polynomial fit;
    fit.coefficients = qr.solve(root.cwiseProduct(y));
    fit.residual = y - powers * fit.coefficients;
    const Eigen::MatrixXd triangle = qr.matrixQR().topRows(parameters);
    const Eigen::MatrixXd inverse = triangle.triangularView<Eigen::Upper>().solve(
        Eigen::MatrixXd::Identity(parameters, parameters));
    fit.covariance = inverse * inverse.transpose();
    return fit;
}

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
    /// u(W), if the weights are inverse variances.
    double u_velocity() const
    {
        return std::sqrt(polynomial.covariance(1, 1)) * velocity() * velocity();
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

/// Number of different places: two values at one place say nothing about the shape along the tube.
Index distinctPlaces(Eigen::VectorXd x)
{
    std::sort(x.begin(), x.end());
    return std::unique(x.begin(), x.end()) - x.begin();
}

double weightedSquares(const Eigen::VectorXd &weight, const Eigen::VectorXd &residual)
{
    return weight.dot(residual.cwiseAbs2());
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

double dofOf(bool stated, Index residualDof)
{
    return stated ? std::numeric_limits<double>::infinity() : static_cast<double>(residualDof);
}

/// `dof` of u: an uncertainty from few residuals is itself uncertain.
bool isSignificant(double gradient, double u_gradient, double dof)
{
    return dof > 0.0 && std::abs(gradient) > studentQuantile(kSignificance, dof) * u_gradient;
}

/// Fills in everything that follows from the chosen line.
VelocityFit described(const Line &line, const Eigen::VectorXd &weight, bool stated)
{
    VelocityFit fit;
    fit.velocity_m_s = line.velocity();
    fit.attenuated = line.polynomial.coefficients.size() > 2;
    fit.residual = line.polynomial.residual;
    fit.weight = weight;
    fit.dof = weight.size() - line.polynomial.coefficients.size();
    const double squares = weightedSquares(weight, fit.residual);
    if (stated && fit.dof > 0)
        fit.chiSquare = squares;
    if (!stated && fit.dof > 0) {
        fit.scatterEstimated = true;
        fit.scatter_m_s = line.u_velocity() * std::sqrt(squares / static_cast<double>(fit.dof));
    }
    return fit;
}

} // namespace

Result<VelocityFit> fitVelocity(const std::vector<Sighting> &sightings, Attenuation attenuation)
{
    const Index count = std::ssize(sightings);
    Eigen::VectorXd x(count), t(count);
    for (Index i = 0; i < count; ++i) {
        x[i] = sightings[static_cast<std::size_t>(i)].distance_m;
        t[i] = sightings[static_cast<std::size_t>(i)].time_s;
    }
    if (count < 2 || x.maxCoeff() == x.minCoeff())
        return fail(ErrorKind::Usage,
            Message{DYNCAL_TEXT(
                        "core", "A velocity needs arrivals at two places at least; there are %1."),
                {std::to_string(std::min<Index>(count, 1))}});
    const double origin_s = t[0]; // times count from here: the record's axis may start anywhere
    t.array() -= origin_s;
    const Line first{fitPolynomial(x, t, Eigen::VectorXd::Ones(count), 2)};
    if (!(first.velocity() > 0.0 && std::isfinite(first.velocity())))
        return tl::unexpected(notTowardsTheWall(sightings, first.velocity()));
    const bool stated = everyUncertaintyIsStated(sightings);
    const Eigen::VectorXd weight
        = stated ? statedWeights(sightings, first.velocity()) : Eigen::VectorXd::Ones(count).eval();
    const Line straight{fitPolynomial(x, t, weight, 2)};
    VelocityFit fit = described(straight, weight, stated);
    fit.arrivalAtWall_s = straight.polynomial.coefficients[0] + origin_s;
    if (distinctPlaces(x) < 3 || attenuation == Attenuation::None)
        return fit;
    const Line bent{fitPolynomial(x, t, weight, 3)};
    const VelocityFit bentFit = described(bent, weight, stated);
    const bool known = stated || bentFit.scatterEstimated;
    const double factor = stated || bentFit.dof == 0
        ? 1.0
        : std::sqrt(weightedSquares(weight, bentFit.residual) / static_cast<double>(bentFit.dof));
    const bool asked = attenuation == Attenuation::Linear && known;
    const bool taken = known
        && (asked
            || isSignificant(
                bent.gradient(), factor * bent.u_gradient(), dofOf(stated, bentFit.dof)));
    if (taken && bent.velocity() > 0.0) {
        fit = bentFit;
        fit.arrivalAtWall_s = bent.polynomial.coefficients[0] + origin_s;
    }
    fit.gradient_per_s = bent.gradient();
    if (known)
        fit.u_gradient_per_s = factor * bent.u_gradient();
    return fit;
}

double refittedVelocity_m_s(
    const VelocityFit &fit, const Eigen::VectorXd &distance_m, const Eigen::VectorXd &time_s)
{
    const Eigen::VectorXd since = time_s.array() - time_s[0];
    return Line{fitPolynomial(distance_m, since, fit.weight, fit.attenuated ? 3 : 2)}.velocity();
}

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

VelocityFit describedCounters(const Polynomial &line, const Intervals &intervals)
{
    VelocityFit fit;
    fit.velocity_m_s = line.coefficients[0];
    fit.arrivalAtWall_s = std::numeric_limits<double>::quiet_NaN();
    fit.attenuated = line.coefficients.size() > 1;
    fit.residual = line.residual;
    fit.weight = intervals.weight;
    fit.dof = intervals.weight.size() - line.coefficients.size();
    const double squares = weightedSquares(intervals.weight, line.residual);
    if (intervals.stated && fit.dof > 0)
        fit.chiSquare = squares;
    fit.scatterEstimated = !intervals.stated && fit.dof > 0;
    if (fit.scatterEstimated)
        fit.scatter_m_s = std::sqrt(line.covariance(0, 0) * squares / static_cast<double>(fit.dof));
    return fit;
}

} // namespace

Result<VelocityFit> fitCounters(
    const std::vector<CounterReading> &readings, Attenuation attenuation)
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
    VelocityFit fit = describedCounters(
        fitPolynomial(intervals.middle_m, intervals.velocity_m_s, intervals.weight, 1), intervals);
    if (distinctPlaces(intervals.middle_m) < 2 || attenuation == Attenuation::None)
        return fit;
    const Polynomial bent
        = fitPolynomial(intervals.middle_m, intervals.velocity_m_s, intervals.weight, 2);
    const VelocityFit bentFit = describedCounters(bent, intervals);
    const bool known = intervals.stated || bentFit.scatterEstimated;
    const double squares = weightedSquares(intervals.weight, bent.residual);
    const double factor = intervals.stated || bentFit.dof == 0
        ? 1.0
        : std::sqrt(squares / static_cast<double>(bentFit.dof));
    const double gradient = bent.coefficients[1];
    const double u_gradient = factor * std::sqrt(bent.covariance(1, 1));
    if (attenuation == Attenuation::Linear
        || (known && isSignificant(gradient, u_gradient, dofOf(intervals.stated, bentFit.dof))))
        fit = bentFit;
    fit.gradient_per_s = gradient;
    if (known)
        fit.u_gradient_per_s = u_gradient;
    return fit;
}

double refittedCounterVelocity_m_s(
    const VelocityFit &fit, const std::vector<CounterReading> &readings)
{
    const Intervals intervals = intervalsOf(readings);
    return fitPolynomial(
        intervals.middle_m, intervals.velocity_m_s, fit.weight, fit.attenuated ? 2 : 1)
        .coefficients[0];
}

} // namespace dyncal
