// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/model_analysis/model_characteristics.h"
#include "core/model_analysis/response_result.h"

namespace dyncal::testing {

/// A response to the model whose band and window leave everything to be stated.
inline ResponseResult wideOpen(
    const SensorModel &model, ResponseTreatment treatment = ResponseTreatment::StepDeflated)
{
    ResponseResult response;
    response.fLow_Hz = 1e3;
    response.fHigh_Hz = response.modelLimit_Hz = 4e6;
    response.window_s = 1.0;
    response.resolution_s = 1e-9;
    response.characteristics = stepCharacteristics(model, treatment);
    return response;
}

} // namespace dyncal::testing
