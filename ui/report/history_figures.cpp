// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/report/history_figures.h"

#include "core/history/history_section.h"
#include "ui/plot/curves/history_curves.h"
#include "ui/text/core_text.h"
#include "ui/text/shown_text.h"

#include <cmath>

namespace dyncal {

namespace {

constexpr double kFirstYear = 1970.0;

bool isBeyond(const SeriesEntry &entry)
{
    return std::abs(entry.En) > 1.0
        || entry.state.value_or(ControlState::Inside) != ControlState::Inside;
}

std::vector<DatedValue> datedValues(
    const HistorySeries &series, const std::vector<EarlierCalibration> &points)
{
    std::vector<DatedValue> values;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (const SeriesEntry &entry = series.entries[i]; std::isfinite(entry.position))
            values.push_back({kFirstYear + points[i].day / kDaysOfYear, entry.position,
                entry.stated.U(), isBeyond(entry)});
    return values;
}

} // namespace

std::vector<FigureMaker> historyFigureMakers(const SensorHistory &history)
{
    std::vector<FigureMaker> makers;
    for (const HistorySeries &series : history.series)
        if (hasHistoryFigure(series))
            makers.push_back([series, values = datedValues(series, history.sensor.points)] {
                return ReportFigure{historyFigureId(series),
                    historyCurves(printed(historyTitle(series.quantity)), shownText(series.unit),
                        values, series.limits)};
            });
    return makers;
}

} // namespace dyncal
