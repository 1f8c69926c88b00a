// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/constants.h"
#include "core/base/index.h"

#include <Eigen/Core>

#include <optional>

namespace dyncal {

/// E_n of two results of one quantity, (x - earlier)/sqrt(U^2 + U_earlier^2), with expanded
/// uncertainties of one coverage (ISO 13528:2015, 9.7; ISO/IEC 17043:2010, B.3.1.3). NaN unless
/// both U are above 0 and all is finite. It supposes independent results: what two calibrations
/// share is in both U and cancels in the difference, so that E_n comes out smaller.
double normalisedError(double x, double U, double earlier, double U_earlier);

/// Fewest results that limits are made from: four ranges.
inline constexpr Index kFewestForLimits = 5;

/// Limits of a chart for individual results.
struct ControlLimits
{
    double mean = kUnknown;
    double sigma = kUnknown; ///< standard deviation from one result to the next

    double warningLow() const { return mean - 2.0 * sigma; }
    double warningHigh() const { return mean + 2.0 * sigma; }
    double actionLow() const { return mean - 3.0 * sigma; }
    double actionHigh() const { return mean + 3.0 * sigma; }
};

/// Limits of results in the order of time: sigma is the mean of |x_i - x_(i-1)| over 2/sqrt(pi),
/// the mean range of two normal values with standard deviation 1 (ISO 7870-2:2013, chart of
/// individuals and moving ranges). The standard deviation of all results is not used: it takes a
/// drift for scatter, and of n results none can lie farther than (n - 1)/sqrt(n) of it from their
/// mean, 1.8 of five. Empty below kFewestForLimits and where a value is not finite.
std::optional<ControlLimits> controlLimits(const Eigen::VectorXd &values);

enum class ControlState {
    Inside,
    Warning, ///< beyond 2 standard deviations
    Action, ///< beyond 3
};

const char *controlStateName(ControlState state); ///< "inside", "warning", "action"

ControlState controlState(const ControlLimits &limits, double value);

/// Fewest results that a drift is made from: with two a line says nothing of its own quality.
inline constexpr Index kFewestForDrift = 3;
inline constexpr double kDaysOfYear = 365.25;

/// Slope of a weighted straight line.
struct YearlyDrift
{
    double perYear = kUnknown; ///< in the unit of the values
    double u = kUnknown; ///< k = 1
    double k = kUnknown; ///< of a 95 % interval
    double birge = kUnknown; ///< sqrt(chi^2/(n - 2)): scatter about the line over what u says
    Index count = 0;

    double U() const { return k * u; }
};

/// Weighted least squares with weights 1/u_i^2 (R. T. Birge, Phys. Rev. 40 (1932) 207). u of the
/// slope follows from the u_i as if they were independent, and is widened by the Birge ratio where
/// the results scatter more than that; k is then Student's of n - 2 degrees of freedom, else 2. An
/// error that all results share moves the line and not its slope, so that u is too large rather
/// than too small. `day`, `value`, `u` of one length, in any order. Empty below kFewestForDrift,
/// where all are of one day, and unless all is finite and every u above 0.
std::optional<YearlyDrift> yearlyDrift(
    const Eigen::VectorXd &day, const Eigen::VectorXd &value, const Eigen::VectorXd &u);

} // namespace dyncal
