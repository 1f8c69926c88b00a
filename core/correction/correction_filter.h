// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "core/correction/correction_request.h"
#include "core/correction/known_response.h"
#include "core/correction/low_pass.h"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace dyncal {

/// A FIR filter from a recording (V) to pressure (Pa), `delaySamples` late:
///     pressure(n - delaySamples) = sum over k of taps[k] record(n - k)
struct CorrectionFilter
{
    double rate_Hz = 0.0;
    LowPass lowPass;
    Index delaySamples = 0;
    Eigen::VectorXd taps; ///< Pa per unit of the recording
    /// What a standard deviation of each source changes the taps by, a column each: the taps'
    /// covariance is the product of this matrix with its transpose.
    Eigen::MatrixXd tapErrors;
    std::vector<std::string> errorNames; ///< of the columns
    Eigen::VectorXd errorDof;
    double passError = 0.0; ///< largest |H S e^(jw delay) - L| up to the band's end
    std::string unit; ///< of the taps: "Pa/V"

    double delay_s() const { return static_cast<double>(delaySamples) / rate_Hz; }
    double gain() const { return taps.sum(); } ///< at 0 Hz, Pa per unit of the recording
    double noiseAmplification() const; ///< the largest |H(f)| over that at 0 Hz
    /// H at each frequency, with the delay taken off.
    Eigen::VectorXcd at(const Eigen::VectorXd &frequency_Hz) const;
    Eigen::VectorXd u_taps() const { return tapErrors.rowwise().norm(); }
};

/// L/S on the grid k rate/n, k = 0 .. n/2.
Eigen::VectorXcd inverseOf(
    const KnownResponse &response, const LowPass &lowPass, double rate_Hz, Index n);

/// What a standard deviation of `error` changes that `inverse` by, on its grid: -(L/S) d ln S.
Eigen::VectorXcd inverseChange(const Eigen::VectorXcd &inverse, const KnownResponse &response,
    const ResponseError &error, double rate_Hz);

/// The filter: L/S sampled in frequency, its impulse response cut to the shortest stretch about 0
/// that keeps the pass error below kLargestPassError (of all filters of that length the nearest to
/// L/S in the mean over frequency, by Parseval). Its taps are linear in L/S, so that the errors of
/// S come out exactly to first order. Fails (Usage) where rate, band, edge or delay cannot be: a
/// band beyond what is known, an edge beyond kHighestEdge, a delay too short for the inverse;
/// (DataBlocked) where noise would be amplified more than kMostAmplified, and where 1/S rings on
/// for more than 2^19 samples, as the inverse of a response with zeros near the axis does, and as
/// carriedByShape(). rate_Hz finite, above 0. docs/method/correction.md.
Result<CorrectionFilter> designCorrection(
    const KnownResponse &response, double rate_Hz, const CorrectionSettings &settings = {});

} // namespace dyncal
