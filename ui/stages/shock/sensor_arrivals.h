// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/shock/shock_conditions.h"

#include <optional>

namespace dyncal {

/// The typed arrival of a sensor in a shot (from 1), on the record's own axis.
std::optional<double> typedArrival_s(const ArrivalSensor &sensor, Index shot);

/// The arrival used in a shot: typed, or found in the record.
std::optional<double> usedArrival_s(const ShockConditions &shot, const ArrivalSensor &sensor);

/// Sets the typed arrival in one of `shots` shots; without a value it is found in the record again.
/// The other shots stay as they are.
void typeArrival(
    ArrivalSensor &sensor, Index shot, std::size_t shots, const std::optional<double> &arrival_s);

} // namespace dyncal
