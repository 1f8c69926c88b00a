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

/// A second-order sensor beside a draft.
struct SecondOrderRival
{
    SecondOrderFit fit;
    double lead = 0.0; ///< BIC of the draft less its own; -HUGE_VAL where the records cannot hold
                       ///< its fastest pole
    bool addsPole = false; ///< it has more poles than the draft

    Index poles() const { return std::ssize(fit.refinement.poles_rad_s); }
};

/// Of a response that does not ring (no overshoot beyond 5 %) two poles are known badly and their
/// amplitudes worse, while level and slope at the onset are known to be 0. So the second-order
/// sensor competes with the draft by the BIC of the pre-whitened records (docs/method/model.md),
/// and beside it, where the draft has a drift, the sensor with that drift. Against a draft that
/// could not be refined it must also leave at most 1.2 times the noise. None where the sensor's
/// damping ratio is below 0.75, for records that are no step response with a plateau, and in thesis
/// mode.
std::vector<SecondOrderRival> secondOrderRivals(
    const ModelInput &input, const ModelDraft &draft, const JobControl &control = {});

/// The best of those of at most so many poles that lead; null without one. A pole more needs very
/// strong evidence, a lead of 10: of weaker ones just those win whose noise exaggerates it.
const SecondOrderRival *leader(const std::vector<SecondOrderRival> &rivals, Index mostPoles);

/// A draft with one real pole (beside a drift) leaves out what is much faster, and BIC does so as
/// long as noise hides it: the rest of it moves pole and onset. So the difference to a rival with
/// the same drift and two real poles joins u of the pole, and its onsets come beside the draft's.
void allowForSecondPole(const std::vector<SecondOrderRival> &rivals, ModelDraft &draft);

/// The real pole of a draft that is at most a tenth as fast as each other; empty without one.
std::optional<DriftStart> driftOf(const ModelDraft &draft);

/// The draft with the sensor's poles, amplitudes and onsets.
void takeSecondOrder(const SecondOrderFit &fit, ModelDraft &draft);

/// Makes the suggestion 2 (3 with a drift) where the second-order sensor is better than the order
/// suggested: of a response damped that much the realised poles tell little.
void considerSecondOrder(const ModelInput &input, const HankelDecomposition &decomposition,
    OrderSuggestion &suggestion, const JobControl &control = {});

} // namespace dyncal
