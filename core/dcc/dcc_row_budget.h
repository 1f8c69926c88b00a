// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/dcc/dcc_source.h"

#include <vector>

namespace dyncal {

/// The budgets of the rows of S(f), magnitude and phase, as dcc:result elements: that of the
/// response, at its marks, and of a comparison beside it. A list has a row for each frequency and a
/// column for each source with its contribution, signed, in the unit of the value; the root of
/// their sum of squares is u of that row (but for correlated ones). NaN where a row is withheld or
/// has no such source. More than kMostBudgetRows rows are left out, as in results.json, which is
/// said.
std::vector<XmlElement> dccRowBudgets(const DccSource &source);

} // namespace dyncal
