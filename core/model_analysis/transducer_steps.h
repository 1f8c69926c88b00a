// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/reference/reference_records.h"
#include "core/shock/shock_conditions.h"
#include "core/shock/step_inputs.h"

#include <Eigen/Core>

#include <vector>

namespace dyncal {

inline constexpr const char *kReferenceGain = "reference_gain_relative";

/// The pressure step of each shot as the reference transducer saw it: the settled level of its
/// record over its sensitivity at the lowest frequency of its calibration (docs/method/
/// comparison.md). Inputs of its u: reference_sensitivity_relative (where the calibration begins
/// above the level also what may change below it; unknown of a single row) and
/// reference_gain_relative
/// (chain of the reference; +-0.5 % unless stated) common to all shots, reference_level_relative
/// (noise) of each. What else is known of a shot is kept from `shock`.
ShockConditionsSet stepsByTransducer(const ReferenceRecords &reference,
    const ShockConditionsSet &shock, const std::vector<StatedUncertainty> &stated);

/// Such a step with other values of these inputs, in that order, each of which is 1 as found.
double stepByTransducer(double step_Pa, const Eigen::VectorXd &inputs);

} // namespace dyncal
