// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/realization/model/sensor_model.h"
#include "core/results/json_record.h"

namespace dyncal {

/// A pole as results.json and model.json list it: in the sampled plane, and as frequency (Hz) and
/// damping ratio with their u (k = 1) and coverage factor; null with a reason where unknown.
JsonRecord::Json poleJson(const Pole &pole);

} // namespace dyncal
