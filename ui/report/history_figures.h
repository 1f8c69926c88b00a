// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/history/sensor_history.h"
#include "ui/report/report_figures.h"

#include <vector>

namespace dyncal {

/// The figures of the section "history" of a certificate (historySection()), each drawn from values
/// of its own. Titles are in the language installed when one is made.
std::vector<FigureMaker> historyFigureMakers(const SensorHistory &history);

} // namespace dyncal
