// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/uncertainty/known_value.h"
#include "ui/stages/frame/shown_table.h"

#include <vector>

namespace dyncal {

/// "Works calibration, static: 1.02 µV/Pa ± 0.01 µV/Pa", as the recipe has it.
QString knownText(const KnownSensitivity &stated);

/// How many of them agree with this calibration; empty where there are none.
QString knownVerdict(const std::vector<KnownValue> &known);

/// One row each: what it states, what this calibration finds there, E_n, whether it is joined.
ShownTable knownTable(const std::vector<KnownValue> &known);

} // namespace dyncal
