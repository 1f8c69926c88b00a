// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"
#include "core/base/message.h"
#include "core/capture/capture_set.h"

#include <Eigen/Core>

#include <optional>
#include <string>
#include <string_view>

namespace dyncal {

/// Coverage factor of expanded uncertainties on the certificate, unless another is printed.
inline constexpr double kCoverageFactor = 2.0;
/// A FIT of this magnitude has no meaning: the simulation diverged.
inline constexpr double kMostPercent = 1e6;

/// Whether nothing was typed but blanks.
bool isBlank(std::string_view text);
/// Words that are printed as they are, whatever they look like: typed or read.
Message verbatim(std::string text);
/// Numbers of ours with their units, which a document prints as its language writes numbers.
Message inNumbers(std::string text);
/// One of a list's values, unknown past its end.
double valueAt(const Eigen::VectorXd &values, Index row);
/// A table cell without a value.
Message dash();
/// A setting or a reading, at most four digits (core/base/rounding.h); a dash if it is no number.
Message setting(double value, std::string_view unit);
/// Value and unit with three digits, as its uncertainty is not known, or `otherwise` if there is
/// none.
Message printed(const std::optional<double> &value, std::string_view unit, Message otherwise);
/// k = 2, or a larger Student's k where few degrees of freedom decide, so that the interval has 95
/// % there too; 2 where it is not known.
double printedCoverage(double k);
/// u that `k` times makes the printed U: rounded it is not below the CMC either (neverBelow()).
double printableU(double u, double k, double leastExpanded);
/// "4.30".
std::string factorText(double k);
/// The factor that U is stated with: "2", "4.30".
std::string printedFactor(double k);
/// " (k = 2)", " (k = 4.30)".
std::string coverageText(double k);
/// "2.3301 MHz ± 0.0024 MHz (k = 2)" from a standard uncertainty; without one as printed().
Message printedWithUncertainty(
    double value, double u, std::string_view unit, double k = kCoverageFactor);
/// The half width alone, k u: "0.0024 MHz". A k other than 2, which its column names, is printed
/// beside it; a dash where u is not known.
Message expandedCell(double value, double u, std::string_view unit, double k = kCoverageFactor);
/// The value alone, to the digits of k u; without a known u three.
Message valueCell(double value, double u, std::string_view unit, double k = kCoverageFactor);
/// Name of a level as a word that is translated; a dash for none.
Message levelWord(ShotLevel level);

} // namespace dyncal
