// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/realization/hankel/hankel_decomposition.h"
#include "core/realization/hankel/order_suggestion.h"
#include "tests/support/simulated_calibration.h"

#include <map>
#include <string>
#include <vector>

namespace dyncal::testing {

/// One row of the table of order suggestions.
struct OrderTrial
{
    std::string name;
    SimulatedCalibration calibration;
    Index trueOrder = 0;
};

/// The cases the suggestion must get right in at least 93 % of 400 trials each.
inline std::vector<OrderTrial> orderTrials()
{
    const std::vector<SimulatedMode> one{{1.0, 30e3, 0.05}};
    const std::vector<SimulatedMode> two{{0.9, 30e3, 0.05}, {0.1, 110e3, 0.02}};
    const auto coloured = [](SimulatedCalibration calibration) {
        calibration.ar1 = 0.9;
        return calibration;
    };
    return {
        {"one mode, 40 dB", {one, 40.0}, 2},
        {"two modes, 40 dB", {two, 40.0}, 4},
        {"two modes, 25 dB", {two, 25.0}, 4},
        {"two modes, 30 dB, AR(0.9)", coloured({two, 30.0}), 4},
    };
}

/// Suggested orders of `trials` simulated calibrations: order -> how often.
inline std::map<Index, int> suggestedOrders(const OrderTrial &trial, int trials)
{
    std::map<Index, int> orders;
    for (int seed = 1; seed <= trials; ++seed) {
        const ModelInput input
            = simulateCalibration(trial.calibration, static_cast<std::uint64_t>(seed));
        if (const auto hankel = decomposeHankel(input, {}))
            ++orders[suggestOrder(input, *hankel).order];
    }
    return orders;
}

} // namespace dyncal::testing
