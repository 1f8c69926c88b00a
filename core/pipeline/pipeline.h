// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/capture/capture_set.h"
#include "core/decomposition/principal_components.h"
#include "core/model_analysis/sensor_response.h"
#include "core/pipeline/result_cache.h"
#include "core/pipeline/shock_stage.h"
#include "core/project/recipe.h"
#include "core/realization/hankel_decomposition.h"
#include "core/realization/model_input.h"
#include "core/realization/order_evidence.h"
#include "core/realization/sensor_model.h"
#include "core/shock/shock_conditions.h"
#include "core/signal/power_spectrum.h"
#include "core/signal/record_starts.h"
#include "core/signal/response_window.h"

#include <array>
#include <memory>
#include <optional>

namespace dyncal {

/// The steps of the method, in the order in which they are computed.
enum class StageId {
    Captures, ///< roles, units, exclusions applied; recordings checked
    Arrivals, ///< where the records of DUTs and side sensors begin to move
    Expected, ///< the shock by these arrivals: what can be known of it before any model
    Window, ///< start, response window, remap
    Spectrum, ///< power spectra and resonances
    Components, ///< PCA, residuals, average
    ModelInput, ///< resampled, cut
    Decomposition, ///< Hankel singular values, suggested order
    Model, ///< poles, fit
    Shock, ///< velocity, states, pressure step
    Response, ///< frequency response, characteristics, sensitivity
    Assessment, ///< of the model: uncertainties, shots compared; no response waits for it
    Evidence, ///< what all orders say; no result waits for it
    MonteCarlo, ///< of the pressure step; nothing waits for it
};
inline constexpr int kStageCount = 14;
inline constexpr StageId kLastStage = StageId::MonteCarlo;

const char *stageName(StageId stage);

/// Captures after the recipe's import section, with their findings.
struct PreparedCaptures
{
    CaptureSet set;
    Findings findings;
};

struct DecompositionResult
{
    HankelDecomposition hankel;
    OrderSuggestion suggestion;
};

/// All results that exist so far; immutable and shared, so that a copy is a snapshot.
struct CalibrationResults
{
    std::shared_ptr<const PreparedCaptures> captures;
    std::shared_ptr<const RecordStarts> starts;
    std::shared_ptr<const ExpectedShock> expected;
    std::shared_ptr<const WindowResult> window;
    std::shared_ptr<const SpectrumResult> spectrum;
    std::shared_ptr<const ComponentResult> components;
    std::shared_ptr<const ModelInput> input;
    std::shared_ptr<const DecompositionResult> decomposition;
    std::shared_ptr<const SensorModel> model; ///< as fitted; the assessed one once that is there
    std::shared_ptr<const ShockConditionsSet> shock;
    std::shared_ptr<const ResponseResult> response;
    std::shared_ptr<const OrderEvidence> evidence; ///< of the decomposition, not of one order
    std::shared_ptr<const StepMonteCarloSet> monteCarlo;
    std::array<std::string, kStageCount> keys; ///< hash of what each result was computed from

    /// Findings of all stages, in stage order.
    Findings findings() const;

    /// Of the evidence stage: of all orders, and of the model's order in their light (MOD-007).
    Findings evidenceFindings() const;
};

/// How far a run came: everything before the failing stage is there.
struct PipelineOutcome
{
    CalibrationResults results;
    std::optional<Error> error;
    StageId failedStage = StageId::Captures; ///< meaningful with an error
};

/// The method, one line per step: the only place where stages are put together. The window and the
/// command line both call this, so their numbers are the same. Results whose inputs have not
/// changed come from the cache. Never throws; a lack of memory is an Error of kind Internal.
PipelineOutcome runPipeline(const std::shared_ptr<const CaptureSet> &captures, const Recipe &recipe,
    ResultCache &cache, StageId last = kLastStage, const JobControl &control = {});

} // namespace dyncal
