// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/progress.h"
#include "core/selftest/self_check.h"

namespace dyncal {

/// The fewest of `count` intervals that must hold the truth, when each does so with the probability
/// `coverage`: fewer have a probability below `risk`. All between 0 and 1; count at least 1.
Index fewestInside(Index count, double coverage, double risk);

/// The fewest calibrations of which each check of the study can fail: some number within U must be
/// too few, and a root mean square of errors over u near 0 must lie outside its bounds.
Index leastCalibrations();

/// `count` virtual calibrations, two at a time: how many intervals hold the truth, and how large
/// the errors are over their u, of each quantity. Bounds at 0.1 %. Nothing after a stop.
std::vector<SelfCheck> coverageStudy(Index count, const JobControl &control = {});

} // namespace dyncal
