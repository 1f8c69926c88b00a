// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/pipeline/pipeline.h"

#include <string>
#include <vector>

namespace dyncal {

/// A model order as typed: a whole number from 1; empty if it is none.
std::optional<Index> typedOrder(const std::string &text);

/// The recipe with --order put in ("" leaves it alone); checked as if it had been written there.
Result<Recipe> withOrder(Recipe recipe, const std::string &order);

/// Reads the files by the recipe, with progress on stderr.
Result<CaptureSet> readForCalibration(const std::vector<std::string> &files, const Recipe &recipe);

/// The outcome, or nothing but the error of checkStillWhole if the recordings are not.
PipelineOutcome ofWholeRecordings(PipelineOutcome outcome, const CaptureSet &set);

/// Runs the method up to `last`, with progress on stderr; stops on Ctrl-C. What was computed of
/// recordings that did not stay whole meanwhile is not given out.
PipelineOutcome calibrate(const CaptureSet &set, const Recipe &recipe, StageId last = kLastStage);
/// The same beside what an earlier run of the same recordings left in the cache.
PipelineOutcome calibrate(
    const CaptureSet &set, const Recipe &recipe, StageId last, ResultCache &cache);

/// Reports the findings and, where they do not say it, the error that stopped the run; the exit
/// code.
int reportOutcome(const PipelineOutcome &outcome);

} // namespace dyncal
