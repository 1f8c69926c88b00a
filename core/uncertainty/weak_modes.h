// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/realization/model/sensor_model.h"

#include <optional>
#include <utility>

namespace dyncal {

/// Strongest mode, at the onset and of the level, that may be the mount's or the wall's: their
/// acceleration is felt with some tenths of a percent of a step (docs/method/uncertainty.md).
inline constexpr double kWeakMode = 0.01;

/// The same model as the characteristics need it, without the oscillations that are weaker than
/// kWeakMode, `main` (positions of the two poles of f0) excepted; empty where there are none. What
/// a record shows cannot tell whether they are the sensor's.
std::optional<SensorModel> withoutWeakModes(
    const SensorModel &model, const std::pair<std::size_t, std::size_t> &main);

} // namespace dyncal
