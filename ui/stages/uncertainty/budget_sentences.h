// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/uncertainty/budgets.h"
#include "core/uncertainty/wanted_u.h"

#include <QString>

namespace dyncal {

/// "Sensitivity = 5.018 µV/Pa, U = 0.106 µV/Pa (k = 2), 2.1 %", or why it has no U.
QString resultSentence(const Budget &budget);

/// What stands in the way of the wanted U: which inputs are enough alone, and the smallest set that
/// is it together.
QString wantedSentence(
    const Budget &budget, const WantedU &wanted, const std::optional<WayToU> &way);

/// "U by the number of shots: 1: 2.3 %, 3: 2.1 %, 6: 1.6 %; never below 1.2 %.", or that more shots
/// do not help.
QString shotsSentence(const Budget &budget);

} // namespace dyncal
