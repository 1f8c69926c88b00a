// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/realization/hankel/hankel_decomposition.h"
#include "core/realization/hankel/order_suggestion.h"
#include "core/realization/input/model_input.h"
#include "core/signal/response_window.h"
#include "ui/plot/values/plot_content.h"

namespace dyncal {

/// What the identification gets: each series at its full rate (thin) and at the model's (markers).
PlotContent modelInputCurves(const ModelInput &input, const WindowResult &window);

/// Singular values over a logarithmic axis with the noise floor and the suggested order. In thesis
/// mode the value that belongs to the step is marked. The page draws the cut as a line.
PlotContent singularValueCurves(const HankelDecomposition &decomposition,
    const OrderSuggestion &suggestion, ResponseTreatment treatment);

/// Position from 0 of the singular value that belongs to the step: its left vector is constant.
/// Empty where the step was projected out or no value is that clear.
std::optional<Index> stepValue(
    const HankelDecomposition &decomposition, ResponseTreatment treatment);

/// BIC over the order, smallest value marked.
PlotContent bicCurves(const OrderSuggestion &suggestion);

} // namespace dyncal
