// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/realization/model/sensor_model.h"
#include "core/uncertainty/known_value.h"
#include "core/uncertainty/uncertainty_report.h"

#include <vector>

namespace dyncal {

/// A model and the treatment of the response it was made from.
struct FittedModel
{
    const SensorModel &model;
    ResponseTreatment treatment;
};

/// Each value of another calibration beside this one's: below the band the sensitivity, times what
/// the model's gain rises from 0 to that frequency; in the band the row of S(f) at exactly the
/// frequency (ResponseResult::atMarks). Both are taken as independent. Not compared where S(f) is
/// not per pressure, in another unit, withheld, above the band, or without a complete u.
std::vector<KnownValue> compareKnown(const std::vector<KnownSensitivity> &known,
    const ResponseResult &response, const UncertaintyReport &report, const FittedModel &fitted);

/// UNC-004: one that differs by more than both U; UNC-005: one that cannot be compared.
Findings judgeKnown(const std::vector<KnownValue> &known);

} // namespace dyncal
