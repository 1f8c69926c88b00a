// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/plot/values/curve_samples.h"

#include <QString>

#include <array>
#include <optional>
#include <vector>

namespace dyncal {

/// One curve where the two cursors stand.
struct CursorRow
{
    QString curve; ///< its name
    QString unit; ///< SI
    std::array<std::optional<double>, 2> y; ///< empty: no cursor, or no sample there
};

/// All visible curves of one plot at its cursors A and B.
struct CursorValues
{
    QString quantity; ///< of the x axis
    QString unit;
    std::array<std::optional<double>, 2> x;
    std::vector<CursorRow> rows;
};

/// The sample nearest to `x`; none before the first and behind the last by more than half an
/// interval.
std::optional<Index> sampleNear(const CurveSamples &samples, double x);

/// Its y; empty where that is no number too.
std::optional<double> valueNear(const CurveSamples &samples, double x);

} // namespace dyncal
