// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"
#include "core/capture/channel.h"

#include <Eigen/Core>

namespace dyncal {

inline constexpr double kNormalSdPerMad = 1.482602218505602; ///< 1 / Phi^-1(3/4)

/// Straight line through a stretch of samples by least squares: value at sample i of the stretch is
/// mean + slope (i - (size - 1)/2).
struct LineFit
{
    double mean = 0.0;
    double slope = 0.0; ///< per sample; 0 for fewer than two samples
    double sd = 0.0; ///< about the line, size - 2 degrees of freedom; 0 for fewer than three
};

/// `values` finite.
LineFit fitLine(const Eigen::Ref<const Eigen::VectorXd> &values);

/// Of the slope of a line through so many equidistant values with this standard deviation.
double uOfSlope(double sd, Index count);

/// Means of stretches of `each` samples; what is left over at the end takes no part.
Eigen::VectorXd meansOf(const Eigen::Ref<const Eigen::VectorXd> &values, Index each);

/// `values` less their line.
Eigen::VectorXd withoutLine(const Eigen::Ref<const Eigen::VectorXd> &values);

/// Median (mean of the two in the middle for an even count); 0 for none. All finite.
double median(Eigen::VectorXd values);

/// The finite ones of `values`, in order.
Eigen::VectorXd finiteOnly(Eigen::VectorXd values);

/// Standard deviation of noise that outliers and slow changes of the level hardly affect: 1.4826
/// times the median absolute deviation from lines through pieces of `piece` samples. Where that is
/// 0 (coarse codes) the ordinary deviation of the nine tenths closest to those lines.
double robustNoiseSd(const Eigen::Ref<const Eigen::VectorXd> &values, Index piece);

/// Whether a stretch before an event of this height is at rest: the levels of twenty pieces of it
/// stay within a tenth of `height`, or differ by no more than noise explains.
bool isAtRest(const Eigen::Ref<const Eigen::VectorXd> &values, double height, double noiseSd);

/// Size of one count in physical units at a raw value; 0 where the source has no counts.
double countSize(const Channel &channel, double raw);

} // namespace dyncal
