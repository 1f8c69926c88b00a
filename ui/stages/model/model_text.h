// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/realization/model/sensor_model.h"

#include <QStringList>
#include <QVector>

#include <vector>

namespace dyncal {

/// "FIT 89.4 % of attainable 89.5 %", or that it diverges.
QString fitText(const SensorModel &model);

/// What is known of the noise that the uncertainties rest on: "white", "AR(3), of the residual".
QString noiseText(const SensorModel &model);

/// Poles as a table, complex pairs on one line.
enum class PoleColumns {
    Few,
    All
}; ///< frequency, damping, class; All: uncertainties and flags too
QStringList poleHeaders(PoleColumns columns);
QVector<QStringList> poleRows(const std::vector<Pole> &poles, PoleColumns columns);

} // namespace dyncal
