// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/realization/model/sensor_model.h"
#include "ui/stages/frame/shown_table.h"

#include <QString>

namespace dyncal {

/// Main resonance and plateau of every shot, then of every level, fitted to these alone.
ShownTable trendTable(const SensorModel *model);

/// The modes taken out of the model, per shot, with what that did to it.
ShownTable nuisanceTable(const SensorModel *model);

/// The second-order sensor fitted beside the model, and its plateau per shot.
ShownTable secondOrderTable(const SensorModel *model);

/// Whether the shots share their poles, in one sentence; empty where it was not tested.
QString homogeneityText(const SensorModel &model);

} // namespace dyncal
