// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"
#include "core/realization/order/order_evidence.h"

#include <optional>

namespace dyncal {

/// Spread of the pole nearest `frequency_Hz` of one order over the orders next to it in which it
/// stays stable; empty where that order has no pole within 10 % of it.
std::optional<OrderSpread> spreadAround(
    const OrderEvidence &evidence, Index order, double frequency_Hz);

} // namespace dyncal
