// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/pipeline/pipeline.h"
#include "core/results/json_record.h"

#include <string>

namespace dyncal {

/// Input of every section of results.json. Internal to core/results.
struct ResultsContext
{
    const PipelineOutcome &outcome;
    const Recipe &recipe;

    const CalibrationResults &results() const { return outcome.results; }
    /// Why there is no result of a stage: the sentence of the error that stopped the run.
    std::string whyMissing() const;
    /// The response of a shot (number from 1), or null if there is none.
    const WindowedResponse *responseOf(Index shot) const;
    /// The fit of that shot's own series, or null (no model, or fitted to the average).
    const SeriesFit *fitOf(Index shot) const;
};

inline constexpr const char *kNoUncertainty
    = "Not evaluated: this version computes no uncertainty for it.";

} // namespace dyncal
