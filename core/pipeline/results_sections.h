// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/pipeline/json_record.h"
#include "core/pipeline/pipeline.h"

#include <string>

namespace dyncal {

/// What every section of results.json is written from. Internal to core/pipeline.
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

/// What all orders say: keys of the section "realization".
void addOrderEvidence(JsonRecord &section, const ResultsContext &context);
void addInputs(JsonRecord &root, const ResultsContext &context);
void addShots(JsonRecord &root, const ResultsContext &context);
void addShock(JsonRecord &root, const ResultsContext &context);
/// Resonances of the tube beside those of the spectrum; part of the section "spectrum".
void addCandidates(JsonRecord &section, const ResultsContext &context);
void addSpectrum(JsonRecord &root, const ResultsContext &context);
void addComponents(JsonRecord &root, const ResultsContext &context);
void addModelInput(JsonRecord &root, const ResultsContext &context);
void addRealization(JsonRecord &root, const ResultsContext &context);
void addModel(JsonRecord &root, const ResultsContext &context);
/// Uncertainty, shots and levels one by one; part of the section "model".
void addShotPoles(JsonRecord &section, const ResultsContext &context);
void addResponse(JsonRecord &root, const ResultsContext &context);
void addBands(JsonRecord &root, const ResultsContext &context);
void addBudget(JsonRecord &root);
void addFindings(JsonRecord &root, const ResultsContext &context);

} // namespace dyncal
