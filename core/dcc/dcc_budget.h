// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/dcc/dcc_source.h"

#include <vector>

namespace dyncal {

/// The budgets of sensitivity and model as one dcc:result, a list for each quantity, and what Monte
/// Carlo found of the same values as another. Those of single frequencies stand in results.json.
std::vector<XmlElement> dccBudgets(const DccSource &source);

} // namespace dyncal
