// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/uncertainty/transducer_comparison.h"
#include "ui/plot/values/plot_content.h"

namespace dyncal {

/// |S(f)| against the reference transducer and against the pressure step (where it is known), each
/// with bars of ± U, over the model's curve. `comparison` must have been made.
PlotContent comparedMagnitudeCurves(const ComparisonResult &comparison);

/// The same two in percent of the mean of both, from it, at frequencies that both have: what a
/// logarithmic axis over a resonance cannot show.
PlotContent comparedDeviationCurves(const ComparisonResult &comparison);

/// E_n of every row over frequency between its limits -1 and 1; no curve where none is known.
PlotContent normalisedErrorCurves(const ComparisonResult &comparison);

} // namespace dyncal
