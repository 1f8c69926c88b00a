// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/certificate/certificate_data.h"
#include "core/history/sensor_history.h"

namespace dyncal {

/// The history as the section of a certificate (docs/history.md): for each quantity that some
/// calibration states a table with a line a calibration, and a figure "history-" + its name; below,
/// drift and what the numbers rest on. Rounded as on the certificates themselves.
CertificateSection historySection(const SensorHistory &history);

/// The id of the figure of a series, and whether it has one: two values or more.
std::string historyFigureId(const HistorySeries &series);
bool hasHistoryFigure(const HistorySeries &series);

/// What a series is called in a document.
Message historyTitle(const FollowedQuantity &quantity);

} // namespace dyncal
