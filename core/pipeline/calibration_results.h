// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/capture_set.h"
#include "core/consistency/way_comparison.h"
#include "core/decomposition/component_result.h"
#include "core/model_analysis/sensor_response.h"
#include "core/pipeline/reference_stage.h"
#include "core/pipeline/shock_stage.h"
#include "core/realization/hankel/hankel_decomposition.h"
#include "core/realization/hankel/order_suggestion.h"
#include "core/realization/input/model_input.h"
#include "core/realization/model/model_assessment.h"
#include "core/realization/model/sensor_model.h"
#include "core/realization/order/order_evidence.h"
#include "core/shock/shock_conditions.h"
#include "core/shock/step_monte_carlo.h"
#include "core/signal/record_starts.h"
#include "core/signal/response_window.h"
#include "core/signal/spectrum_analysis.h"
#include "core/uncertainty/transducer_comparison.h"
#include "core/uncertainty/uncertainty_report.h"

#include <array>
#include <memory>
#include <string>

namespace dyncal {

struct ChainMonteCarlo; // core/monte_carlo/chain_monte_carlo.h

/// The steps of the method, in the order in which they are computed; stage_table.cpp describes
/// each, and CalibrationResults below holds what each leaves.
enum class StageId {
    Captures, ///< roles, units, exclusions applied; recordings checked
    Arrivals, ///< where the records of DUTs and side sensors begin to move
    Expected, ///< the shock from these arrivals, before any model
    Window, ///< start, response window, remap
    Spectrum, ///< power spectra and resonances
    Components, ///< PCA, residuals, average
    ModelInput, ///< resampled, cut
    Decomposition, ///< Hankel singular values, suggested order
    Model, ///< poles, fit
    Shock, ///< velocity, states, pressure step
    Reference, ///< a reference transducer: what it is, its records
    Response, ///< frequency response, characteristics, sensitivity
    Checks, ///< the independent ways to one quantity, compared
    Assessment, ///< of the model: uncertainties, shots compared; no response waits for it
    Uncertainty, ///< the budget of everything that is stated; no response waits for it
    Comparison, ///< reference transducer and step, compared
    Evidence, ///< what all orders show; no result waits for it
    MonteCarlo, ///< of the pressure step; nothing waits for it
    ChainMonteCarlo, ///< of everything that is stated; nothing waits for it
};
inline constexpr StageId kLastStage = StageId::ChainMonteCarlo;
inline constexpr int kStageCount = static_cast<int>(kLastStage) + 1;

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
    std::shared_ptr<const SensorModel> model;
    std::shared_ptr<const ShockConditionsSet> shock;
    std::shared_ptr<const ReferenceStageResult> reference;
    std::shared_ptr<const ResponseResult> response;
    std::shared_ptr<const ConsistencyResult> checks;
    std::shared_ptr<const ModelAssessment> assessment; ///< of `model` and no other
    std::shared_ptr<const UncertaintyReport> uncertainty;
    std::shared_ptr<const ComparisonResult> comparison;
    std::shared_ptr<const OrderEvidence> evidence; ///< of the decomposition, not of one order
    std::shared_ptr<const StepMonteCarloSet> monteCarlo;
    std::shared_ptr<const ChainMonteCarlo> chainMonteCarlo;
    std::array<std::string, kStageCount> keys; ///< hash of what each result was computed from
};

} // namespace dyncal
