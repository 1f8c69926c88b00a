// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/realization/model/sensor_model.h"
#include "core/realization/order/order_evidence.h"

namespace dyncal {

/// MOD-007: the FIT of a shot by the poles of the other shots (orders 1..20) lies more than 15
/// points below the FIT by the model's poles.
Findings judgeOtherShots(const SensorModel &model, const OrderEvidence &evidence);

} // namespace dyncal
