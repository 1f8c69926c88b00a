// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/text/quantity_format.h"

#include <QStringList>

#include <limits>
#include <vector>

namespace dyncal {

/// A value and its standard uncertainty, not finite where unknown.
struct Estimate
{
    double value = std::numeric_limits<double>::quiet_NaN();
    double u = std::numeric_limits<double>::quiet_NaN();
};

/// What stands in one column (or one row of one quantity): all in one unit, prefix included, that
/// of the largest, and to the same decimal place, zeros kept: the largest has `digits` significant
/// digits, the smallest at least two where three more places are enough. "–" where there is none.
QStringList shownColumn(const std::vector<double> &values, const QString &unit, int digits);
QStringList shownColumn(
    const std::vector<std::optional<double>> &values, const QString &unit, int digits);

/// Values with their uncertainties: each to the place of its own u, two significant digits of which
/// are kept (shownResult), all in one unit.
std::vector<ShownResult> shownColumn(const std::vector<Estimate> &values, const QString &unit);

/// The same as "value ± u".
QStringList shownColumnWithU(const std::vector<Estimate> &values, const QString &unit);

} // namespace dyncal
