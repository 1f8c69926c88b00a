// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Prints how often the suggested order is the true one: order_trials [TRIALS]

#include "tests/support/order_trials.h"

#include <cstdio>
#include <cstdlib>

using namespace dyncal;

int main(int argc, char **argv)
{
    const int trials = argc > 1 ? std::atoi(argv[1]) : 400;
    std::printf("| case | order | right | suggested |\n|---|---|---|---|\n");
    for (const testing::OrderTrial &trial : testing::orderTrials()) {
        std::string list;
        int right = 0;
        for (const auto &[order, count] : testing::suggestedOrders(trial, trials)) {
            list += (list.empty() ? "" : ", ") + std::to_string(order) + ": "
                + std::to_string(count);
            right += order == trial.trueOrder ? count : 0;
        }
        std::printf("| %s | %td | %.1f %% | %s |\n", trial.name.c_str(), trial.trueOrder,
            100.0 * right / trials, list.c_str());
        std::fflush(stdout);
    }
    return 0;
}
