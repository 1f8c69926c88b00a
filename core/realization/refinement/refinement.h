// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"
#include "core/realization/exponentials/exponential_sum.h"
#include "core/realization/input/nuisance_term.h"
#include "core/signal/window_bands.h"

#include <Eigen/Core>

#include <complex>
#include <vector>

namespace dyncal {

/// One record that the refinement fits: y(t) = c0 + sum c_i e^(s_i t) + its nuisance terms,
/// t = index / rate.
struct RefinementRecord
{
    Eigen::VectorXd y;
    double rate_Hz = 0.0;
    double weight = 1.0; ///< 1 / noise sd
    std::vector<NuisanceTerm> nuisance = {}; ///< poles to start from; amplitudes are fitted
    std::vector<SampleRange> used = {}; ///< samples that take part, in order; empty = all
};

/// Result of the joint fit: poles shared by all records, amplitudes for each record.
struct Refinement
{
    std::vector<std::complex<double>> poles_rad_s; ///< s_i, paired as given
    std::vector<ExponentialSum> records; ///< amplitudes at t = 0, without the nuisance terms
    /// Positions of the real poles that have not died out by the end of the records. c_i and c0 of
    /// such a pole are nearly one parameter, and both pass infinity where its rate passes 0. So the
    /// parameters in their place are its slope at t = 0, c_i s_i, and for c0 the level there, c0
    /// with all these c_i: known as well as the record shows them, whatever the rate.
    std::vector<Index> relaxing = {};
    std::vector<std::vector<NuisanceTerm>> nuisance; ///< per record, as fitted
    Eigen::MatrixXd covariance; ///< of (real parameters of the poles, then per record of
                                ///< amplitudes, c0, nuisance terms); with `relaxing`
                                ///< slopes and level in place of their amplitudes and c0
    std::vector<Index> offsets; ///< where each record's own parameters begin in it
    Index poleParameters = 0; ///< n: per pair (Re s, Im s), per real pole Re s
    bool withConstant = false;
    double residualToNoise = 1.0; ///< rms of the weighted residual: 1 where the noise explains it
};

/// The response of one record with parameter `index` of its own (poles first, then amplitudes, c0)
/// moved by `delta`, all others held: for propagating the covariance to quantities derived from the
/// response.
ExponentialSum perturbed(const Refinement &refinement, Index record, Index index, double delta);

/// The same with all parameters of the record moved at once, `deltas` in that order.
ExponentialSum perturbed(const Refinement &refinement, Index record, const Eigen::VectorXd &deltas);

/// Covariance of the poles' and one record's parameters, in the order of perturbed().
Eigen::MatrixXd recordCovariance(const Refinement &refinement, Index record);

/// Variance of c0 of one record; of its last amplitude where there is no constant.
double constantVariance(const Refinement &refinement, Index record);

/// d (poles, amplitudes, c0, nuisance terms) / d (parameters), of all records: 1 but for the slopes
/// and levels of `relaxing`.
Eigen::MatrixXd amplitudesByParameters(const Refinement &refinement);

/// Covariance of (Re pole, Im pole, Re amplitude, Im amplitude) of one nuisance term of a record.
Eigen::Matrix4d nuisanceCovariance(const Refinement &refinement, Index record, Index term);

} // namespace dyncal
