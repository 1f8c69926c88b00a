// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/realization/model/sensor_model.h"
#include "core/results/json_record.h"
#include "core/uncertainty/stated_poles.h"

#include <vector>

namespace dyncal {

/// A pole as results.json and model.json list it: in the sampled plane, and as frequency (Hz) and
/// damping ratio with their u (k = 1) and coverage factor; null with a reason where unknown.
JsonRecord::Json poleJson(const Pole &pole);

/// Positions of polesOf() in the order in which results.json lists them (sortPoles()).
std::vector<std::size_t> listedPoles(const std::vector<Pole> &poles);

/// With the uncertainties that are stated of it; `u_...` and `coverage_factor` have the noise
/// alone.
JsonRecord::Json statedPoleJson(const Pole &pole, const PoleUncertainty &stated);

} // namespace dyncal
