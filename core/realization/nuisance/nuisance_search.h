// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/realization/input/model_input.h"
#include "core/realization/input/nuisance_term.h"
#include "core/signal/response_window.h"

#include <vector>

namespace dyncal {

/// The modes of every series, as far as they can be found in its tail: a first estimate.
/// NUI-001..005.
void searchNuisance(ModelInput &input, const std::vector<WindowedResponse> &responses);

/// Removes the terms from the series at the model rate: subtracts them in `series.correction`,
/// which keeps its other corrections.
void setNuisance(const ModelInput &input, ModelSeries &series, std::vector<NuisanceTerm> terms);

} // namespace dyncal
