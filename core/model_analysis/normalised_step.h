// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/realization/exponentials/exponential_sum.h"
#include "core/realization/model/sensor_model.h"

namespace dyncal {

/// The sensor's answer to a step of 1, t from the onset: without what drifts slower than it.
ExponentialSum normalisedStep(const SensorModel &model);

} // namespace dyncal
