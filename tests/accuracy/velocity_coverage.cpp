// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Prints how often the 95 % interval of the shock's velocity holds the truth: velocity_coverage
// [RUNS].

#include "tests/support/velocity_coverage.h"

#include <cstdio>
#include <cstdlib>

using namespace dyncal;

int main(int argc, char **argv)
{
    const Index runs = argc > 1 ? std::strtol(argv[1], nullptr, 10) : 1000;
    const auto print = [&](const char *what, const std::vector<double> &distances_m, bool stated) {
        const Coverage c = velocityCoverage(distances_m, stated, runs);
        std::printf("%-46s %6.2f %% of %td runs\n", what, c.percent(), c.runs);
    };
    print("two sensors, uncertainties stated", {0.9, 0.1}, true);
    print("three sensors, uncertainties stated", {0.9, 0.5, 0.1}, true);
    print("three sensors, scatter estimated (Student)", {0.9, 0.5, 0.1}, false);
    print("five sensors, uncertainties stated", {0.9, 0.7, 0.5, 0.3, 0.1}, true);
    print("five sensors, scatter estimated (Student)", {0.9, 0.7, 0.5, 0.3, 0.1}, false);
    return 0;
}
