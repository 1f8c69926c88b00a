// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/realization/order_evidence.h"

namespace dyncal {

/// Why the suggested order, sentence by sentence: BIC, singular values against the noise, stable
/// poles, leave-one-shot-out, pairs, FIT.
std::vector<Message> wordsFor(const ModelInput &input, const HankelDecomposition &decomposition,
    const OrderSuggestion &suggestion, const OrderEvidence &evidence);

} // namespace dyncal
