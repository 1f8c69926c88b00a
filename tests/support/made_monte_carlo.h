// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/monte_carlo/chain_monte_carlo.h"

namespace dyncal::testing {

/// An interval of +-U about a value, seen in 10000 trials.
inline DrawnQuantity drawnAround(double value, double U)
{
    return {10000, 0, value, 0.5 * U, value - U, value + U, value - U, value + U, U, U, U};
}

/// A Monte Carlo that is written down: f0 validated, the 5 % edge not (2.4 % by the law, 2.9 % by
/// trials), a value that does not exist in some trials; three rows, the last one withheld.
inline ChainMonteCarlo madeMonteCarlo()
{
    ChainMonteCarlo made;
    made.trials = 10000;
    made.seed = 7;
    made.values = {{"sensitivity", "V/Pa", 5e-6, drawnAround(5e-6, 1e-7), {}},
        {"sensitivity.per_level[0]", "V/Pa", 5.1e-6, drawnAround(5.1e-6, 1e-7), {}},
        {"f0_hz", "Hz", 1e5, drawnAround(1e5, 200.0), {}},
        {"within_5_percent_hz", "Hz", 2e4, drawnAround(2e4, 580.0), {}},
        {"settling_time_s", "s", 1e-5, {}, {}}};
    made.values[4].drawn.trials = 10000;
    made.values[4].drawn.undefined = 3;
    const auto validate = [](DrawnValue &one, double U) {
        one.gum = validateGum(
            one.value, U / 1.959964, std::numeric_limits<double>::infinity(), 0.95, one.drawn);
    };
    const double U[]{1e-7, 1e-7, 200.0, 480.0, 1e-7};
    for (std::size_t i = 0; i < made.values.size(); ++i)
        validate(made.values[i], U[i]);
    for (const double f_Hz : {1e3, 1e4, 1e5}) {
        DrawnRow row;
        row.frequency_Hz = f_Hz;
        row.withMagnitude = row.withPhase = f_Hz < 5e4;
        if (row.withPhase) {
            row.magnitude = drawnAround(5e-6, 1e-7);
            row.phase = drawnAround(-0.1, 0.01);
            row.gumMagnitude = validateGum(5e-6, 1e-7 / 1.959964,
                std::numeric_limits<double>::infinity(), 0.95, row.magnitude);
            row.gumPhase = validateGum(
                -0.1, 0.02 / 1.959964, std::numeric_limits<double>::infinity(), 0.95, row.phase);
            row.varRe = row.varIm = 1e-15;
            row.covReIm = 0.0;
        }
        made.rows.push_back(row);
    }
    made.refits = {50, 0, {{"f0_hz", 10.0, 11.0, 0.5, true}}};
    return made;
}

} // namespace dyncal::testing
