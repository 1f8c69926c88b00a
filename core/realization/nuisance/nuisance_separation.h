// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/progress.h"
#include "core/realization/input/model_input.h"
#include "core/realization/input/realization_settings.h"
#include "core/signal/response_window.h"

#include <optional>
#include <vector>

namespace dyncal {

/// Finds the modes in every series and fits them together with the sensor on the records
/// themselves, over six periods of the slowest mode or the model input, whichever is longer, at
/// most the window. Fills nuisance and correction of the series and lengthens their fullRate. The
/// number of sensor states is that of the smallest BIC of the response without the modes. Stretches
/// that are left out take no part and are bridged by the fit. Findings: NUI-001 (fewer than two
/// periods in the window), NUI-002 (above 0.4 of the record's sample rate), NUI-003 (not found in a
/// shot), NUI-004 (averaged shots have no modes of their own), NUI-005 (no frequency for a shot);
/// such modes stay in. Only for step treatments and free decays of stacked shots.
void separateNuisance(ModelInput &input, const std::vector<WindowedResponse> &responses,
    const std::vector<NuisanceMode> &modes,
    const std::vector<std::optional<double>> &soundSpeeds_m_s, const JobControl &control = {});

} // namespace dyncal
