// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/history/control_chart.h"

#include "core/base/distributions.h"
#include "core/uncertainty/reported_value.h"

#include <cmath>
#include <numbers>

namespace dyncal {
namespace {

/// Mean range of two normal values with standard deviation 1: d2 of two.
const double kRangeOfTwo = 2.0 / std::sqrt(std::numbers::pi);
constexpr double kBothSides = 0.975;

/// Rounding alone must not put results that are all the same outside of their own mean.
constexpr double kRounding = 1e-12;

bool areUsable(const Eigen::VectorXd &day, const Eigen::VectorXd &value, const Eigen::VectorXd &u)
{
    return value.size() >= kFewestForDrift && day.size() == value.size() && u.size() == value.size()
        && day.allFinite() && value.allFinite() && u.allFinite() && u.minCoeff() > 0.0;
}

/// Scatter beyond u is of the results themselves: as many degrees as they leave to a line.
void widen(YearlyDrift &drift)
{
    if (!(drift.birge > 1.0)) {
        drift.k = kUsualFactor;
        return;
    }
    drift.u *= drift.birge;
    drift.k = statedFactor(studentQuantile(kBothSides, static_cast<double>(drift.count - 2)));
}

} // namespace

double normalisedError(double x, double U, double earlier, double U_earlier)
{
    if (!(U > 0.0 && U_earlier > 0.0))
        return kUnknown;
    const double En = (x - earlier) / std::hypot(U, U_earlier);
    return std::isfinite(En) && std::isfinite(U) && std::isfinite(U_earlier) ? En : kUnknown;
}

std::optional<ControlLimits> controlLimits(const Eigen::VectorXd &values)
{
    const Index n = values.size();
    if (n < kFewestForLimits || !values.allFinite())
        return std::nullopt;
    const double meanRange = (values.tail(n - 1) - values.head(n - 1)).cwiseAbs().mean();
    const double first = values[0]; // the rest is small, and its mean exact
    return ControlLimits{first + (values.array() - first).mean(), meanRange / kRangeOfTwo};
}

const char *controlStateName(ControlState state)
{
    switch (state) {
    case ControlState::Inside:
        break;
    case ControlState::Warning:
        return "warning";
    case ControlState::Action:
        return "action";
    }
    return "inside";
}

ControlState controlState(const ControlLimits &limits, double value)
{
    const double off = std::abs(value - limits.mean) - kRounding * std::abs(limits.mean);
    return off > 3.0 * limits.sigma ? ControlState::Action
        : off > 2.0 * limits.sigma  ? ControlState::Warning
                                    : ControlState::Inside;
}

std::optional<YearlyDrift> yearlyDrift(
    const Eigen::VectorXd &day, const Eigen::VectorXd &value, const Eigen::VectorXd &u)
{
    if (!areUsable(day, value, u) || day.maxCoeff() == day.minCoeff())
        return std::nullopt;
    const Eigen::ArrayXd weight = (u.minCoeff() / u.array()).square(); // 1 for the best
    const Eigen::ArrayXd year = (day.array() - day[0]) / kDaysOfYear, x = value.array() - value[0];
    const Eigen::ArrayXd t = year - (weight * year).sum() / weight.sum();
    const Eigen::ArrayXd y = x - (weight * x).sum() / weight.sum();
    const double spread = (weight * t.square()).sum();
    YearlyDrift drift{.perYear = (weight * t * y).sum() / spread,
        .u = u.minCoeff() / std::sqrt(spread),
        .count = value.size()};
    const double chiSquare = ((y - drift.perYear * t) / u.array()).square().sum();
    drift.birge = std::sqrt(chiSquare / static_cast<double>(drift.count - 2));
    widen(drift);
    return drift;
}

} // namespace dyncal
