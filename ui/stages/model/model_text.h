// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/uncertainty/stated_poles.h"

#include <QStringList>
#include <QVector>

#include <vector>

namespace dyncal {

/// "FIT 89.4 % of attainable 89.5 %", or that it diverges.
QString fitText(const SensorModel &model);

/// What is known of the noise that the uncertainties rest on: "white", "AR(3), of the residual".
QString noiseText(const SensorModel &model);

/// Poles as a table, complex pairs on one line, with the uncertainties that are stated of them.
QStringList poleHeaders();
QVector<QStringList> poleRows(
    const std::vector<Pole> &poles, const std::vector<PoleUncertainty> &stated);

} // namespace dyncal
