// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Prints how often the stated 95 % intervals of f0 and zeta hold the truth: pole_coverage [RUNS]

#include "tests/support/pole_coverage.h"

#include <cstdio>
#include <cstdlib>

using namespace dyncal;

int main(int argc, char **argv)
{
    const int runs = argc > 1 ? std::atoi(argv[1]) : 1000;
    int first = 1;
    std::printf(
        "| case | f0 inside | zeta inside | rms error/u of f0 | of zeta | told apart | no model |\n|---|---|---|---|---|---|---|\n");
    for (const testing::CoverageCase &test : testing::coverageCases()) {
        const testing::PoleCoverage c = testing::poleCoverage(test, runs, first);
        first += 100000; // other noise in every case
        std::printf("| %s | %.1f %% | %.1f %% | %.3f | %.3f | %d | %d |\n", test.name.c_str(),
            c.percentF0(), c.percentZeta(), std::sqrt(c.squaresF0 / c.runs),
            std::sqrt(c.squaresZeta / c.runs), c.heterogeneous, c.failed);
        std::fflush(stdout);
    }
    return 0;
}
