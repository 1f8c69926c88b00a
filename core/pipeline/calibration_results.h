// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/capture_set.h"
#include "core/decomposition/component_result.h"
#include "core/model_analysis/sensor_response.h"
#include "core/pipeline/shock_stage.h"
#include "core/pipeline/stage.h"
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

#include <array>
#include <memory>
#include <string>

namespace dyncal {

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
    std::shared_ptr<const ResponseResult> response;
    std::shared_ptr<const ModelAssessment> assessment; ///< of `model` and no other
    std::shared_ptr<const OrderEvidence> evidence; ///< of the decomposition, not of one order
    std::shared_ptr<const StepMonteCarloSet> monteCarlo;
    std::array<std::string, kStageCount> keys; ///< hash of what each result was computed from
};

} // namespace dyncal
