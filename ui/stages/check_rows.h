// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/consistency/way_comparison.h"

#include <QStringList>
#include <QVector>

#include <vector>

namespace dyncal {

/// The table of comparisons as the window shows it: quantity, shot, place, both values, difference
/// with its u, how many u that is, the smallest fault it could see, verdict.
QStringList checkHeaders();
QVector<QStringList> checkRows(const std::vector<WayComparison> &checks);

/// "18 comparisons made, 1 contradicts, 3 could not be made."
QString checkSummary(const std::vector<WayComparison> &checks);

} // namespace dyncal
