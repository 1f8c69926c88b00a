// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/progress.h"
#include "core/correction/correction_filter.h"
#include "core/model_analysis/noise_density.h"

#include <Eigen/Core>

#include <optional>

namespace dyncal {

/// A stretch of a recording without gaps, its level before the pressure taken off.
struct RecordedStretch
{
    Eigen::VectorXd values; ///< unit of the recording, finite
    double time_s = 0.0; ///< of values[0]
};

/// Coverage of the band k u_Pa.
inline constexpr double kCoverageOfPressure = 0.95;

/// The pressure behind a recording, sample by sample, relative to that before it.
struct CorrectedPressure
{
    double rate_Hz = 0.0;
    double time_s = 0.0; ///< of the first value
    Eigen::VectorXd pressure_Pa;
    double u_noise_Pa = 0.0; ///< noise of the recording and of its level before
    Eigen::VectorXd u_response_Pa; ///< of the sensor's response
    Eigen::VectorXd bound_Pa; ///< what the low-pass takes away at most, by the assumption stated
    Eigen::VectorXd u_Pa; ///< all three, the bound as the half width of a rectangle
    Eigen::VectorXd k; ///< of 95 %
};

/// The stretch through the filter, its delay taken off; values for which the filter would need
/// samples beyond the ends of the stretch are left out. With y_j the stretch through column j of
/// tapErrors,
///     u_Pa^2 = u_noise_Pa^2 + sum over j of y_j^2 + bound_Pa^2/3
/// u_noise_Pa^2 is the mean of P(f) |H(f)|^2 over frequency, and H(0)^2 times the variance of the
/// level; k is Student's of the degrees of freedom by Welch and Satterthwaite. bound_Pa is
/// `beyond_Pa` where given; else what the pressure has in the upper half of the band within 1/band
/// of each sample, as far as it stands out of noise (of its square nine variances are taken off):
/// that the pressure has no more beyond the band than there is the assumption. Fails (Usage) where
/// the stretch is too short, (DataBlocked) where a value is not finite, (Cancelled) when asked to
/// stop.
Result<CorrectedPressure> correctedPressure(const RecordedStretch &stretch,
    const NoiseDensity &noise, const CorrectionFilter &filter, std::optional<double> beyond_Pa = {},
    const JobControl &control = {});

} // namespace dyncal
