// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/history/earlier_response.h"
#include "core/uncertainty/budgets.h"
#include "ui/plot/values/plot_content.h"

#include <vector>

namespace dyncal {

/// |S(f)| of these budgets with bars of ± U, each with its own k, over the model's curve; and at
/// the right U in percent of each. Of `budgets` only the magnitudes are drawn. `tried` (same
/// order) are the budgets with other u; empty where none are tried. A frequency is marked.
PlotContent expandedMagnitudeCurves(const ResponseResult &response,
    const std::vector<Budget> &budgets, const std::vector<Budget> &tried = {},
    std::optional<double> marked_Hz = {});

/// The magnitudes of budgets as rows, with the U that is reported.
std::vector<ResponseRow> rowsOf(const std::vector<Budget> &budgets);

/// Lays |S(f)| of earlier results over a content of the function above, with bars of ± U.
void layOver(const EarlierResponse &earlier, const QString &name, PlotContent &content);

} // namespace dyncal
