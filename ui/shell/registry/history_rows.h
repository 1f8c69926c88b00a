// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/plot/values/plot_content.h"

#include <QJsonObject>
#include <QVariantList>

#include <vector>

namespace dyncal {

/// Words and numbers of an answer of `dyncal history --json` (docs/history.md), of which `series`
/// is one of `series[]`.
QString seriesTitle(const QJsonValue &series); ///< "Magnitude at 1.259 kHz"

/// Day, certificate, value, U, k, E_n, state in the chart, remark: a row for each calibration.
std::vector<QVariantList> historyRows(const QJsonObject &history, int series);

/// The quantity over the years; calibrations without a value are not drawn.
PlotContent historyContent(const QJsonObject &history, int series);

/// What is said of the series as a whole: drift in a year, limits or why there are none, results
/// that were left out.
QString historySummary(const QJsonObject &history, int series);

} // namespace dyncal
