// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/realization/model/model_assessment.h"
#include "ui/stages/frame/shown_table.h"

#include <QString>

namespace dyncal {

/// Main resonance and plateau of every shot, then of every level, fitted to these alone.
ShownTable trendTable(const ModelAssessment *assessment);

/// The modes taken out of the model, per shot, with what that did to it once it is assessed.
ShownTable nuisanceTable(const SensorModel *model, const ModelAssessment *assessment);

/// The second-order sensor fitted beside the model, and its plateau per shot.
ShownTable secondOrderTable(const ModelAssessment *assessment);

/// Whether the shots share their poles, in one sentence; empty where it was not tested.
QString homogeneityText(const ModelAssessment &assessment);

} // namespace dyncal
