// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/history/sensor_history.h"

#include <string>

namespace dyncal {

/// The answer for people: what the calibrations are, then every quantity as a table with its limits
/// and its drift, then what was left out and what the numbers rest on.
std::string historyText(const SensorHistory &history);

} // namespace dyncal
