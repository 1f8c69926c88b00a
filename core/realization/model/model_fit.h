// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/realization/hankel/hankel_decomposition.h"
#include "core/realization/input/model_input.h"
#include "core/realization/input/realization_settings.h"
#include "core/realization/model/sensor_model.h"
#include "core/signal/spectrum_analysis.h"

namespace dyncal {

/// Realises the model of one order from the decomposition (eq 3.22 or shift invariance, least
/// squares amplitudes, optional refinement), not yet assessed. Fails (Usage) if order < 1 or larger
/// than the data allow (the message names the largest), and when cancelled.
Result<SensorModel> fitModel(const ModelInput &input, const HankelDecomposition &decomposition,
    Index order, const RealizationSettings &settings, const SpectrumResult &spectrum,
    const JobControl &control = {});

} // namespace dyncal
