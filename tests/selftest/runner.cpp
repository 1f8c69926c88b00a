// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The self-test alone, for programs with a fault in them (faults.py): prints "holds", or the step
// of the first deviation; the argument is the number of virtual calibrations.

#include "core/base/message.h"
#include "core/selftest/selftest.h"

#include <cstdlib>
#include <iostream>

int main(int argc, char **argv)
{
    const long calibrations = argc > 1 ? std::strtol(argv[1], nullptr, 10) : 0;
    const auto report = dyncal::runSelfTest({calibrations, {}});
    if (!report) {
        std::cout << dyncal::english(report.error().message) << '\n';
        return 1;
    }
    const dyncal::SelfCheck *first = report->firstDeviation();
    std::cout << (first ? first->step + ": " + dyncal::english(first->name) : "holds") << '\n';
    return 0;
}
