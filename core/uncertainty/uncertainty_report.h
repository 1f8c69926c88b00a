// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/model_analysis/sensor_response.h"
#include "core/realization/input/model_input.h"
#include "core/realization/model/model_assessment.h"
#include "core/realization/model/sensor_model.h"
#include "core/shock/shock_conditions.h"
#include "core/uncertainty/known_value.h"
#include "core/uncertainty/reported_value.h"
#include "core/uncertainty/row_uncertainty.h"

#include <optional>
#include <vector>

namespace dyncal {

/// One budget for everything that a calibration states (docs/method/uncertainty.md).
struct UncertaintyReport
{
    std::optional<ReportedValue> sensitivity; ///< mean over the shots, per pressure
    std::vector<ReportedValue> perLevel; ///< in the order of the summary
    std::vector<ReportedValue> ofShots; ///< sensitivity of each shot, as in ResponseResult::shots
    std::vector<ReportedValue> ofModel; ///< modelValues()
    std::vector<ReportedValue> amplitudes; ///< poleAmplitudes()
    RowUncertainty rows;
    RowUncertainty rowsAtMarks; ///< of ResponseResult::atMarks
    ChainEffects chain;
    std::vector<KnownValue> known; ///< of compareKnown(), in the recipe's order
    Findings findings; ///< UNC-001, UNC-002, UNC-004, UNC-005

    const ReportedValue *find(const std::string &of) const; ///< null without it
};

/// Complete u of the mean sensitivity, of that of a shot (position in ResponseResult::shots; with
/// the k of its degrees of freedom), and of what is reported of the model; unknown where there is
/// none, or no report yet.
double uOfSensitivity(const UncertaintyReport *report);
double uOfShot(const UncertaintyReport *report, std::size_t shot);
double kOfShot(const UncertaintyReport *report, std::size_t shot);
double uOf(const UncertaintyReport *report, const std::string &of);

/// The mean of a level (position in SensitivitySummary::perLevel); null where there is none.
const ReportedValue *levelOf(const UncertaintyReport *report, std::size_t level);

/// Needs a step response; of a free decay the model's values alone are reported.
UncertaintyReport reportUncertainty(const ModelInput &input, const SensorModel &model,
    const ModelAssessment &assessment, const ResponseResult &response,
    const ShockConditionsSet &shock, const std::vector<StatedUncertainty> &stated);

} // namespace dyncal
