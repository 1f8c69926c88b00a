// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/progress.h"
#include "core/realization/hankel/hankel_decomposition.h"
#include "core/realization/hankel/order_suggestion.h"
#include "core/realization/input/model_input.h"
#include "core/realization/refinement/model_draft.h"
#include "core/realization/second_order/second_order_fit.h"

#include <optional>

namespace dyncal {

/// Of a response that does not ring (no overshoot beyond 5 %) two poles are known badly and their
/// amplitudes worse, while level and slope at the onset are known to be 0. So the second-order
/// sensor competes with the draft by the BIC of the pre-whitened records (docs/method/model.md).
/// Against a draft that could not be refined it must also leave at most 1.2 times the noise. Empty
/// where the draft's BIC is smaller, where the sensor's damping ratio is below 0.75, for records
/// that are no step response with a plateau, and in thesis mode.
std::optional<SecondOrderFit> betterSecondOrder(
    const ModelInput &input, const ModelDraft &draft, const JobControl &control = {});

/// The draft with the sensor's poles, amplitudes and onsets.
void takeSecondOrder(const SecondOrderFit &fit, ModelDraft &draft);

/// Makes the suggestion 2 where the second-order sensor is better than the order suggested: of a
/// response damped that much the realised poles tell little.
void considerSecondOrder(const ModelInput &input, const HankelDecomposition &decomposition,
    OrderSuggestion &suggestion, const JobControl &control = {});

} // namespace dyncal
