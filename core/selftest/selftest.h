// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/results/method_versions.h"
#include "core/selftest/installation.h"
#include "core/selftest/self_check.h"

#include <string>
#include <vector>

namespace dyncal {

struct SelfTestSettings
{
    /// Of the coverage study, 0 = none; else leastCalibrations() to 10000.
    Index calibrations = 40;
    std::vector<UsedLibrary> libraries; ///< that core does not know of
};

/// What this installation computes against what is known (docs/selftest.md).
struct SelfTestReport
{
    std::vector<SelfCheck> checks; ///< by step, in the order of the method
    MethodVersions methods;
    Installation installation;
    Index calibrations = 0; ///< of the coverage study

    Index deviations() const;
    const SelfCheck *firstDeviation() const; ///< null where all hold
    Message verdict() const; ///< one sentence; names the step of the first deviation
};

/// All checks but those of the coverage study, in the order of the method.
std::vector<CheckSpec> allChecks();

/// The same numbers on every run of one build and machine. Fails (Usage) on settings out of range,
/// and (Cancelled) when stopped.
Result<SelfTestReport> runSelfTest(
    const SelfTestSettings &settings = {}, const JobControl &control = {});

} // namespace dyncal
