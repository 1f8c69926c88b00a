// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/realization/hankel/hankel_decomposition.h"
#include "core/realization/hankel/order_suggestion.h"
#include "core/realization/input/model_input.h"
#include "core/realization/input/realization_settings.h"
#include "core/realization/order/order_evidence.h"

namespace dyncal {

/// Poles, FIT and leave-one-shot-out error of every order up to 60 (fewer for long inputs). Fails
/// (Cancelled) on request only.
Result<OrderEvidence> gatherOrderEvidence(const ModelInput &input,
    const HankelDecomposition &decomposition, const OrderSuggestion &suggestion,
    const RealizationSettings &settings, const JobControl &control = {});

} // namespace dyncal
