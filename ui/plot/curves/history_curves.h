// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/history/control_chart.h"
#include "ui/plot/values/plot_content.h"

#include <vector>

namespace dyncal {

/// A value of one calibration of a sensor.
struct DatedValue
{
    double year = 0.0; ///< 2026.5 is the middle of 2026
    double value = 0.0;
    double U = kUnknown; ///< NaN: not known
    bool isBeyond = false; ///< the limits, or not within U of the one before
};

/// A quantity over the years with bars of ± U, the conspicuous values marked, and the lines of a
/// control chart, which the first view holds. `quantity` is the title and names the axis.
PlotContent historyCurves(const QString &quantity, const QString &unit,
    const std::vector<DatedValue> &values, const std::optional<ControlLimits> &limits);

} // namespace dyncal
