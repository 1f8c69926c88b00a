// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/pipeline/pipeline.h"
#include "ui/session/session.h"

namespace dyncal::test {

/// The real pipeline with few trials of the Monte Carlo, which takes three times as long as all
/// else; for tests that ask nothing of it.
inline Session::Pipeline quickPipeline()
{
    return [](const std::shared_ptr<const CaptureSet> &captures, const Recipe &recipe,
               ResultCache &cache, StageId last, const JobControl &control) {
        constexpr Index kQuickTrials = 100;
        Recipe quick = recipe;
        quick.uncertainty.monteCarloTrials = kQuickTrials;
        return runPipeline(captures, quick, cache, last, control);
    };
}

} // namespace dyncal::test
