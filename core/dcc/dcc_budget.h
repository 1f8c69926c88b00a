// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/dcc/dcc_source.h"

#include <vector>

namespace dyncal {

/// The budgets of the reported values (dccValues()) as one dcc:result, a list for each. Those
/// of single frequencies: dccRowBudgets().
std::vector<XmlElement> dccBudgets(const DccSource &source);

} // namespace dyncal
