// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/realization/hankel/order_suggestion.h"
#include "core/realization/order/order_evidence.h"
#include "core/signal/spectrum_analysis.h"
#include "ui/plot/values/plot_content.h"

namespace dyncal {

/// Stabilisation strip: order over frequency, a marker per class of stability, the mean spectrum of
/// the shots behind it on an axis of its own, and the row of the chosen order.
PlotContent stabilisationCurves(
    const OrderEvidence &evidence, const SpectrumResult &spectrum, Index order);

/// FIT of every order with the attainable one, the error of leaving out one shot at a time, and the
/// information criterion on an axis of its own. The chosen order is marked.
PlotContent evidenceCurves(const OrderEvidence *evidence, const OrderSuggestion &suggestion,
    double attainable_percent, Index order);

} // namespace dyncal
