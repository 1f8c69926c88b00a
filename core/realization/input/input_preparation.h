// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/decomposition/component_result.h"
#include "core/realization/exponentials/front.h"
#include "core/realization/input/model_input.h"
#include "core/signal/response_window.h"
#include "core/signal/signal_settings.h"
#include "core/signal/spectrum_analysis.h"

#include <vector>

namespace dyncal {

/// Resamples to the model rate, cuts the model input and reports the part of the response that is
/// lost (thesis 3.7 4d-5). What lies within a front (docs/method/front.md) is left out. Rules of
/// "auto" for rate, offset and length: docs/method/model-input.md.
Result<ModelInput> prepareModelInput(const std::vector<WindowedResponse> &responses,
    const SpectrumResult &spectrum, const ComponentResult &components,
    const InputSettings &settings, const FrontDuration &front = {}, const JobControl &control = {});

} // namespace dyncal
