// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"

#include <QString>

#include <vector>

namespace dyncal {

/// Findings that say the same of several shots: one id, one severity, one sentence.
using FindingGroup = Findings;

/// What blocks first, then cautions, then what is good to know; each kind in the order given.
std::vector<FindingGroup> grouped(const Findings &findings);

/// "▲ Caution WIN-001, shots 2 and 3: Shot 2 / 3: the window ends 0.31 ms / 0.42 ms after ...";
/// that of the finding itself where it is alone.
QString groupLine(const FindingGroup &group);

/// "2 and 3", "1 to 4", "1, 3 and 5 to 8".
QString shotList(std::vector<Index> shots);

} // namespace dyncal
