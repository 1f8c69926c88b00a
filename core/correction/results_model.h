// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "core/correction/known_response.h"
#include "core/results/results_reading.h"

namespace dyncal {

// Internal to core/correction: parts of a results.json as values.

/// The continuous form of the model of a step that results.json has as sampled A, B, C, D: with the
/// residues r_i of D + C (z - A)^-1 B at the poles z_i, s_i = ln z_i/dt and c_i = r_i/(z_i - 1)
/// (docs/method/correction.md). Real poles with |s| below 2 pi fLow_Hz count as settled. Fails as
/// calibratedResponse().
Result<PoleShape> shapeOf(const nlohmann::json &model, double fLow_Hz);

/// What a standard deviation of f0 and of the damping of each pole moves the poles of `shape` by;
/// of `knots` knots. Fails (DataBlocked) where a pole of the shape has no u.
Result<std::vector<ResponseError>> poleErrors(
    const nlohmann::json &model, const PoleShape &shape, Index knots);

} // namespace dyncal
