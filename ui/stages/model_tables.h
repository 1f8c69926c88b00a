// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/realization/sensor_model.h"

#include <QStringList>
#include <QVector>

namespace dyncal {

/// A table as the page shows it.
struct TextTable
{
    QStringList headers;
    QVector<QStringList> rows;
};

/// Main resonance and plateau of every shot, then of every level, fitted to these alone.
TextTable trendTable(const SensorModel *model);

/// The modes taken out of the model, per shot, with what that did to it.
TextTable nuisanceTable(const SensorModel *model);

/// The second-order sensor fitted beside the model, and its plateau per shot.
TextTable secondOrderTable(const SensorModel *model);

/// Whether the shots share their poles, in one sentence; empty where it was not tested.
QString homogeneityText(const SensorModel &model);

} // namespace dyncal
