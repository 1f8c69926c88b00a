// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/model_analysis/sensor_response.h"
#include "core/realization/model/model_assessment.h"
#include "core/realization/model/model_variation.h"
#include "core/uncertainty/chain_effects.h"
#include "core/uncertainty/reported_value.h"

#include <vector>

namespace dyncal {

/// What is reported of the model, each with its budget: f0_hz, damping_ratio, q, resonance_hz,
/// resonance_gain (|S| there over the sensitivity), within_5_percent_hz, within_10_percent_hz,
/// minus_3_db_hz, rise_time_s, overshoot_percent, settling_time_s; only those that may be stated
/// (statedCharacteristics()) and, of f0 to the gain, that exist. Lines: "noise", what the
/// refinement's covariance does (modelVariations()), f0 and damping as assessed, all the others
/// wider in proportion where the shots' scatter stands for the noise; "clock_relative" of
/// frequencies and times; and of what depends on amplitudes the front, which changes those of the
/// ringing by frontFactor(): "front_duration_s" by its u where it is stated, else "front_unknown"
/// as in frontLine(); "mounting_relative", withMounting() at both ends of its u; and "weak_mode"
/// (withoutWeakModes()). Without a refinement u is absent.
std::vector<ReportedValue> modelValues(const SensorModel &model, const ModelAssessment &assessment,
    const ResponseResult &response, const std::vector<ModelVariation> &variations,
    ResponseTreatment treatment, const ChainEffects &chain);

} // namespace dyncal
