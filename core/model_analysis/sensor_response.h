// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"
#include "core/base/result.h"
#include "core/model_analysis/response_result.h"
#include "core/model_analysis/response_settings.h"
#include "core/realization/input/model_input.h"
#include "core/realization/model/sensor_model.h"
#include "core/reference/reference_records.h"
#include "core/shock/shock_conditions.h"
#include "core/signal/response_window.h"

#include <vector>

namespace dyncal {

/// k of a row's 95 % interval, Student's for its degrees of freedom; not known where it has none.
double coverageFactorAt(const ResponseResult &response, Index row);

/// `shock`: the pressure steps. With settings.reference "transducer" S(f) is that against
/// `reference`, which must then be given, and the steps are those that it saw
/// (stepsByTransducer()). `chain`: divided out of S(f) and of the model's curve; null = none
/// stated.
Result<ResponseResult> computeResponse(const std::vector<WindowedResponse> &responses,
    const ModelInput &input, const SensorModel &model, const ShockConditionsSet &shock,
    const ResponseSettings &settings, const ReferenceRecords *reference = nullptr,
    const ReferenceSensitivity *chain = nullptr);

/// The part of computeResponse() that needs the model only and is quick: curve, unit and
/// sensitivities. The caller gives the band; nothing is taken from the records.
ResponseResult computeModelResponse(const std::vector<WindowedResponse> &responses,
    const ModelInput &input, const SensorModel &model, const ShockConditionsSet &shock,
    const ResponseSettings &settings, double from_Hz, double to_Hz,
    const ReferenceSensitivity *chain = nullptr);

} // namespace dyncal
