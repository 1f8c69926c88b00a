// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/history/control_chart.h"
#include "core/history/followed_value.h"
#include "core/history/sensor_calibrations.h"

#include <optional>
#include <string>
#include <vector>

namespace dyncal {

/// A value of a series beside those before it.
struct SeriesEntry
{
    FollowedValue stated;
    double position = kUnknown; ///< the value; a phase on the turn nearest to the one before
    double En = kUnknown; ///< against the one before that has U
    Index before = -1; ///< which point that is; -1: none
    std::string whyNoEn; ///< empty: there is one
    std::optional<ControlState> state; ///< empty without limits or value
};

/// One quantity over time; an entry for every point of the history.
struct HistorySeries
{
    FollowedQuantity quantity;
    std::string unit; ///< of the newest that is stated; values in another one take no part
    std::vector<SeriesEntry> entries;
    std::optional<ControlLimits> limits;
    std::string whyNoLimits; ///< empty: there are some
    std::optional<YearlyDrift> drift;
    std::string whyNoDrift; ///< empty: there is one

    /// Some |E_n| above 1 or some value beyond the warning limits.
    bool isConspicuous() const;
};

struct SensorHistory
{
    SensorCalibrations sensor;
    std::vector<std::string> methodChanges; ///< of each point since the one before; empty: none
    std::vector<HistorySeries> series;

    bool isConspicuous() const;
};

/// What the numbers rest on, in sentences; they go with every answer.
const std::vector<std::string> &historyAssumptions();

/// f0, damping ratio and sensitivity of the points, and magnitude and phase of S at each of `at_Hz`
/// (followedValue(), servingRow_Hz()). Blocked points state nothing. E_n, limits and drift as in
/// control_chart.h, from the values in the unit of the newest one; the drift from those with U.
SensorHistory sensorHistory(SensorCalibrations sensor, const std::vector<double> &at_Hz);

} // namespace dyncal
