// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/dcc/dcc_finding.h"
#include "core/dcc/dcc_tree.h"

namespace dyncal {

/// Rules about the lists of numbers of a DCC. Internal to core/dcc.
void checkLists(const DccTree &tree, std::vector<DccFinding> &findings);
void checkLengths(const DccTree &tree, std::vector<DccFinding> &findings);
void checkUnits(const DccTree &tree, std::vector<DccFinding> &findings);

} // namespace dyncal
