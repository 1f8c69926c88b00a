// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"
#include "core/base/result.h"

#include <Eigen/Core>

#include <complex>
#include <limits>
#include <string>
#include <vector>

namespace dyncal {

/// G(jw) = level + sum c_i jw/(jw - s_i): the shape of a response between the frequencies at which
/// it was measured. No poles: G = level.
struct PoleShape
{
    double level = 1.0; ///< at 0 Hz
    Eigen::VectorXcd c;
    Eigen::VectorXcd s_rad_s; ///< negative real parts; both of a pair

    std::complex<double> at(double frequency_Hz) const;
};

/// One source of error of a response: what a standard deviation of it changes ln S by (real part:
/// relative magnitude, imaginary part: phase in rad).
struct ResponseError
{
    std::string quantity;
    Eigen::VectorXcd atKnots; ///< one for each knot
    double dof = std::numeric_limits<double>::infinity();
    /// Where not empty: what it moves each pole by. The response at the knots, which was measured,
    /// stays; what lies between them moves.
    Eigen::VectorXcd polesMoved_rad_s = {};
};

/// A complex response that is known at single frequencies (knots), with the shape of a model
/// between them: ln S = ln G + r(f), with r carried from ln (S_k/G_k) at the knots by
/// - a polynomial where `terms` is not 0: Re r = a_0 + a_1 x^2 + ... + a_m x^2m, Im r = b_1 x + b_2
/// x^3
///   + ... + b_m x^(2m-1), x = f over the last knot, by least squares with weights 1/u_alone^2;
/// - else straight lines over log f (over f from a knot at 0 Hz on), as of a table without a model.
/// Beyond the first and the last knot r stays.
struct KnownResponse
{
    Eigen::VectorXd knot_Hz; ///< ascending, the first may be 0
    Eigen::VectorXcd atKnots; ///< S in `unit`, not 0
    PoleShape shape;
    std::vector<ResponseError> errors; ///< independent of each other
    double validTo_Hz = 0.0; ///< beyond, nothing is known
    std::string unit; ///< "V/Pa"
    Eigen::VectorXd u_alone; ///< relative: what each knot's magnitude and phase have alone
    Index terms = 0; ///< m of the polynomial

    /// S at each frequency (>= 0).
    Eigen::VectorXcd at(const Eigen::VectorXd &frequency_Hz) const;
    /// d ln S at each frequency for a standard deviation of `error`. With d_i(f) the change of ln G
    /// by the i-th pole alone, the level and the zeros of G unmoved, jw/(s_i (jw - s_i)): that less
    /// what is carried of it from the knots.
    Eigen::VectorXcd changeBy(
        const ResponseError &error, const Eigen::VectorXd &frequency_Hz) const;
    /// Without the knots behind the first at or above this frequency.
    KnownResponse upTo(double frequency_Hz) const;
};

/// Least departure of S from the shape of its model that counts, relative (and in rad).
inline constexpr double kLeastDeparture = 5e-4;
/// Terms of the polynomial at most.
inline constexpr Index kMostTerms = 4;

/// With the fewest terms, from one on, that describe the knots: chi-square of the residuals over
/// u_alone (and kLeastDeparture) is not exceeded with a probability below 1 %. Fails (DataBlocked),
/// naming the worst knot, where kMostTerms are not enough: then the shape is not that of the
/// response. u_alone has as many values as there are knots, at least 4.
Result<KnownResponse> carriedByShape(KnownResponse response);

} // namespace dyncal
