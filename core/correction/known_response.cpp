// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/correction/known_response.h"

#include "core/base/constants.h"
#include "core/base/distributions.h"
#include "core/base/least_squares.h"
#include "core/base/number_text.h"

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

using Complex = std::complex<double>;

/// Between which two knots a frequency lies, and how far.
struct KnotPlace
{
    Index below = 0;
    double share = 0.0; ///< of the knot above

    Complex of(const Eigen::VectorXcd &values) const
    {
        if (share == 0.0)
            return values[below];
        return (1.0 - share) * values[below] + share * values[below + 1];
    }
};

double shareBetween(double low_Hz, double high_Hz, double frequency_Hz)
{
    if (low_Hz > 0.0)
        return std::log(frequency_Hz / low_Hz) / std::log(high_Hz / low_Hz);
    return frequency_Hz / high_Hz;
}

KnotPlace placeOf(const Eigen::VectorXd &knot_Hz, double frequency_Hz)
{
    const auto above = std::upper_bound(knot_Hz.begin(), knot_Hz.end(), frequency_Hz);
    if (above == knot_Hz.begin())
        return {};
    const Index below = std::distance(knot_Hz.begin(), above) - 1;
    if (above == knot_Hz.end())
        return {below, 0.0};
    return {below, shareBetween(knot_Hz[below], *above, frequency_Hz)};
}

/// ln of the ratios at the knots, each phase the nearest to that before it.
Eigen::VectorXcd logRatios(const KnownResponse &response)
{
    Eigen::VectorXcd ratios(response.knot_Hz.size());
    double before = 0.0;
    for (Index k = 0; k < ratios.size(); ++k) {
        const Complex ratio
            = std::log(response.atKnots[k] / response.shape.at(response.knot_Hz[k]));
        before = ratio.imag() - kTwoPi * std::round((ratio.imag() - before) / kTwoPi);
        ratios[k] = {ratio.real(), before};
    }
    return ratios;
}

Eigen::VectorXd weightedU(const KnownResponse &response)
{
    return (response.u_alone.array().square() + kLeastDeparture * kLeastDeparture).sqrt();
}

/// Powers first, first + 2, ... of x, a column each.
Eigen::MatrixXd powersOf(const Eigen::VectorXd &x, Index first, Index count)
{
    Eigen::MatrixXd powers(x.size(), count);
    for (Index i = 0; i < count; ++i)
        powers.col(i) = x.array().pow(static_cast<double>(first + 2 * i));
    return powers;
}

/// Values at the knots carried to any frequency.
class CarriedValues
{
public:
    /// Phases of `atKnots` begin near a whole number of half turns, which is kept.
    CarriedValues(const KnownResponse &response, const Eigen::VectorXcd &atKnots)
        : m_knot_Hz(response.knot_Hz)
        , m_values(atKnots)
        , m_terms(response.terms)
    {
        if (m_terms > 0)
            fit(weightedU(response));
    }

    Complex at(double frequency_Hz) const
    {
        if (m_terms == 0)
            return placeOf(m_knot_Hz, frequency_Hz).of(m_values);
        const double x = std::min(frequency_Hz / m_knot_Hz.tail(1)[0], 1.0);
        double even = 0.0;
        double odd = 0.0;
        for (Index i = m_terms; i > 0; --i) {
            even = (even + m_even[i]) * x * x;
            odd = odd * x * x + m_odd[i - 1];
        }
        return {even + m_even[0], odd * x + m_halfTurns_rad};
    }

private:
    void fit(const Eigen::VectorXd &u)
    {
        const Eigen::VectorXd x = m_knot_Hz / m_knot_Hz.tail(1)[0];
        const Eigen::VectorXd weight = u.cwiseInverse();
        m_halfTurns_rad = 0.5 * kTwoPi * std::round(m_values[0].imag() / (0.5 * kTwoPi));
        const auto solve = [&](const Eigen::MatrixXd &powers, const Eigen::VectorXd &values) {
            return Eigen::VectorXd(leastSquares(Eigen::MatrixXd(weight.asDiagonal() * powers),
                Eigen::MatrixXd(weight.cwiseProduct(values))));
        };
        m_even = solve(powersOf(x, 0, m_terms + 1), m_values.real());
        m_odd = solve(powersOf(x, 1, m_terms), m_values.imag().array() - m_halfTurns_rad);
    }

    Eigen::VectorXd m_knot_Hz;
    Eigen::VectorXcd m_values;
    Index m_terms;
    double m_halfTurns_rad = 0.0;
    Eigen::VectorXd m_even;
    Eigen::VectorXd m_odd;
};

Complex movedBy(const PoleShape &shape, const Eigen::VectorXcd &moved_rad_s, double frequency_Hz)
{
    const Complex jw(0.0, kTwoPi * frequency_Hz);
    Complex sum = 0.0;
    for (Index i = 0; i < moved_rad_s.size(); ++i)
        if (moved_rad_s[i] != 0.0) // of many poles one pair moves
            sum += moved_rad_s[i] * jw / (shape.s_rad_s[i] * (jw - shape.s_rad_s[i]));
    return sum;
}

/// Of magnitude and phase together, in u of each knot alone.
Eigen::VectorXd departuresOf(const KnownResponse &response)
{
    return response.atKnots.cwiseQuotient(response.at(response.knot_Hz))
        .array()
        .log()
        .matrix()
        .cwiseAbs()
        .cwiseQuotient(weightedU(response));
}

} // namespace

std::complex<double> PoleShape::at(double frequency_Hz) const
{
    const Complex jw(0.0, kTwoPi * frequency_Hz);
    Complex G = level;
    for (Index i = 0; i < c.size(); ++i)
        G += c[i] * jw / (jw - s_rad_s[i]);
    return G;
}

Eigen::VectorXcd KnownResponse::at(const Eigen::VectorXd &frequency_Hz) const
{
    const CarriedValues ratio(*this, logRatios(*this));
    Eigen::VectorXcd values(frequency_Hz.size());
    for (Index i = 0; i < values.size(); ++i)
        values[i] = shape.at(frequency_Hz[i]) * std::exp(ratio.at(frequency_Hz[i]));
    return values;
}

Eigen::VectorXcd KnownResponse::changeBy(
    const ResponseError &error, const Eigen::VectorXd &frequency_Hz) const
{
    Eigen::VectorXcd measured = error.atKnots;
    for (Index k = 0; k < knot_Hz.size(); ++k)
        measured[k] -= movedBy(shape, error.polesMoved_rad_s, knot_Hz[k]);
    const CarriedValues carried(*this, measured);
    Eigen::VectorXcd change(frequency_Hz.size());
    for (Index i = 0; i < change.size(); ++i)
        change[i]
            = carried.at(frequency_Hz[i]) + movedBy(shape, error.polesMoved_rad_s, frequency_Hz[i]);
    return change;
}

KnownResponse KnownResponse::upTo(double frequency_Hz) const
{
    KnownResponse part = *this;
    const auto last = std::lower_bound(knot_Hz.begin(), knot_Hz.end(), frequency_Hz);
    const Index count = std::min(std::distance(knot_Hz.begin(), last) + 1, knot_Hz.size());
    part.knot_Hz.conservativeResize(count);
    part.atKnots.conservativeResize(count);
    part.u_alone.conservativeResize(std::min(count, u_alone.size()));
    part.errors.clear();
    for (ResponseError error : errors) {
        error.atKnots.conservativeResize(count);
        if (!error.atKnots.isZero(0.0) || error.polesMoved_rad_s.size() > 0)
            part.errors.push_back(std::move(error));
    }
    return part;
}

Result<KnownResponse> carriedByShape(KnownResponse response)
{
    constexpr double kSeldom = 0.01;
    Eigen::VectorXd departures;
    for (response.terms = 1; response.terms <= kMostTerms; ++response.terms) {
        departures = departuresOf(response);
        const double dof = static_cast<double>(2 * (departures.size() - 1 - response.terms));
        if (dof > 0.0 && chiSquareSurvival(departures.squaredNorm(), dof) >= kSeldom)
            return response;
    }
    Index worst = 0;
    departures.maxCoeff(&worst);
    return fail(ErrorKind::DataBlocked,
        {DYNCAL_TEXT("core",
             "The measured response departs from the shape of its model, most at %1 (%2 times its uncertainty), so that nothing can be said between the measured frequencies; calibrate with another order, or ask for a narrower band (--band, --edge)."),
            {numberWithUnit(response.knot_Hz[worst], "Hz"), numberText(departures[worst], 2)}});
}

} // namespace dyncal
