// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/uncertainty/budgets.h"
#include "ui/text/typed_quantity.h"

namespace dyncal {

/// What a budget is of, without its frequency: "Sensitivity, Low", "Magnitude of S(f)".
QString quantityName(const Budget &budget);
/// With it: "Magnitude of S(f) at 100 kHz".
QString budgetName(const Budget &budget);

QString lineName(const UncertaintyLine &line); ///< "Arrival, Side 1, shot 2"

/// What the u of a line is shown and typed in: percent of the value where it is relative or has
/// the value's own unit (degrees of a phase), else the input's unit with the prefix that fits.
ShownUnit unitOfU(const UncertaintyLine &line, const ReportedValue &reported);
/// In that unit.
QString uText(double u, const UncertaintyLine &line, const ReportedValue &reported);

/// U of a value, in percent of it; of a phase in degrees.
QString relativeText(double U, const Budget &budget);
QString factorText(const ReportedValue &reported); ///< k

} // namespace dyncal
