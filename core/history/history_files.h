// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/history/sensor_history.h"

#include <string>
#include <vector>

namespace dyncal {

/// What was given and could not be read.
struct UnreadResults
{
    std::string file;
    std::string reason;
};

/// Schema "dyncal-history/1" (docs/history.md): `sensor`, `points[]`, `series[]` with a value for
/// each point, `left_out[]`, `unread[]`, `assumptions[]`; null with "<key>_reason" beside it.
std::string historyJson(
    const SensorHistory &history, const std::vector<UnreadResults> &unread = {});

/// Schema "dyncal-history-sensors/1": `sensors[]` with `serial` and `calibrations`, `unread[]`.
std::string sensorsJson(
    const std::vector<CalibrationCount> &sensors, const std::vector<UnreadResults> &unread = {});

/// A line for every value, series after series, each in the order of time: quantity, frequency_hz,
/// unit, time, certificate, value, u, k, u_expanded, e_n, control_state, mean, warning_low,
/// warning_high, action_low, action_high, drift_per_year, u_drift_per_year, methods_changed,
/// reason, file. A cell is empty where there is no value.
std::string historyCsv(const SensorHistory &history);

} // namespace dyncal
