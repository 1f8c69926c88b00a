// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/base/index.h"
#include "core/realization/hankel/hankel_decomposition.h"
#include "core/realization/hankel/order_suggestion.h"
#include "core/realization/order/order_evidence.h"

#include <optional>
#include <vector>

namespace dyncal {

/// Why the suggested order, sentence by sentence: BIC, singular values against the noise, stable
/// poles with their spread, leave-one-shot-out, pairs, and the lowest order that reaches 98 % of
/// the attainable FIT without a pole at the Nyquist frequency.
std::vector<Message> wordsFor(const HankelDecomposition &decomposition,
    const OrderSuggestion &suggestion, const OrderEvidence &evidence);

/// The lowest order whose FIT is at least 98 % of the attainable one and which has neither unstable
/// nor Nyquist poles; empty if there is none, or the attainable FIT is meaningless (10 % or less).
std::optional<Index> lowestSufficientOrder(const OrderEvidence &evidence);

} // namespace dyncal
