// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/constants.h"
#include "core/pipeline/order_comparison.h"
#include "ui/plot/values/plot_content.h"

#include <QStringList>

#include <optional>

namespace dyncal {

/// What cards and table say of one pinned order.
struct CandidateRow
{
    Index order = 0;
    bool isChosen = false; ///< the order of the recipe
    bool isAdopted = false;
    std::optional<CurveRole> overlaid; ///< its style in the plots
    bool isKnown = false; ///< the model is there; else it is computed, or the note says why not
    bool diverges = false;
    std::optional<double> fit_percent, attainable_percent, f0_Hz, zeta, whiteness_p, bic;
    double u_f0_Hz = kUnknown; ///< standard uncertainties, where the poles were refined
    double u_zeta = kUnknown;
    int unstable = 0;
    int nyquist = 0;
    QString note; ///< what the program says of it
    QString remark; ///< what the operator wrote of it
};

/// `compared` may be null: not computed yet.
CandidateRow candidateRow(
    Index order, const ComparedOrder *compared, const CalibrationResults &results);

/// "FIT 89.4 of 89.5 %", resonance, counts, whiteness: a line each.
QStringList cardLines(const CandidateRow &row);

/// "< 0.001" or the p value.
QString probabilityShown(std::optional<double> p);

/// A reason to adopt this order, for the operator to edit: only what is true of it.
QString proposedReason(const SensorModel &model, const CalibrationResults &results);

} // namespace dyncal
