// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/monte_carlo/chain_monte_carlo.h"
#include "core/uncertainty/budgets.h"

#include <QString>
#include <QStringList>

#include <vector>

namespace dyncal {

/// One value by Monte Carlo, beside its budget.
struct DrawnBudget
{
    const DrawnQuantity *drawn = nullptr; ///< null: it was not drawn
    const GumValidation *gum = nullptr;
};

/// Of each of allBudgets(), in their order; `drawn`: null = there is no Monte Carlo of this run.
std::vector<DrawnBudget> drawnOf(const std::vector<Budget> &budgets, const ChainMonteCarlo *drawn);

/// For a cell beside U: "validated", "U = 2.9 %", or a dash.
QString drawnCell(const DrawnBudget &drawn, const Budget &budget);

/// "Monte Carlo, 10000 trials: from 4.97 µV/Pa to 5.07 µV/Pa, U = 1.9 %. It validates the law of
/// propagation, which gives U = 2.0 %.", or that it does not, or why there is none.
QString drawnSentence(const DrawnBudget &drawn, const Budget &budget);

} // namespace dyncal
