// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Prints how often the 95 % intervals of the shock's velocity and of the step hold the truth:
// velocity_coverage [RUNS].

#include "tests/support/velocity_coverage.h"

#include <cstdio>
#include <cstdlib>

using namespace dyncal;

int main(int argc, char **argv)
{
    const Index runs = argc > 1 ? std::strtol(argv[1], nullptr, 10) : 1000;
    const auto print = [&](const char *what, const CoverageCase &c) {
        const StepCoverage s = stepCoverage(c, runs);
        std::printf("| %s | %.1f %% | %+.2f | %.1f %% | %+.2f |\n", what, s.velocity.percent(),
            s.velocity.meanZ(), s.step.percent(), s.step.meanZ());
    };
    constexpr double kRise_s = 3e-6;
    const std::vector<double> three{0.8, 0.5, 0.2, 0.0};
    std::printf("| arrival sensors, truth | W inside | mean z | step inside | mean z |\n");
    print("one, late, drawn from the range", {{0.8, 0.0}, true, {}, kRise_s});
    print("three, drawn from the range", {three, true, {}});
    print("three, 0 %/m", {three, true, 0.0});
    print("three, 0.2 %/m", {three, true, 0.002});
    print("three, 0.4 %/m", {three, true, 0.004});
    print("three, 0.8 %/m", {three, true, 0.008});
    print("three, late, drawn from the range", {three, true, {}, kRise_s});
    print("three, late, 0 %/m", {three, true, 0.0, kRise_s});
    print("three, late, 0.2 %/m", {three, true, 0.002, kRise_s});
    print("three, late, 0.4 %/m", {three, true, 0.004, kRise_s});
    print("three, late, 0.8 %/m", {three, true, 0.008, kRise_s});
    print("three, scatter estimated (Student)", {three, false, {}, 0.0});
    print("five, late, drawn from the range", {{0.9, 0.7, 0.5, 0.3, 0.1}, true, {}, kRise_s});
    print("five, scatter estimated (Student)", {{0.9, 0.7, 0.5, 0.3, 0.1}, false, {}, 0.0});
    return 0;
}
