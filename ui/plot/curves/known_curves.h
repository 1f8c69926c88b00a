// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/uncertainty/uncertainty_report.h"
#include "ui/plot/values/plot_content.h"

namespace dyncal {

/// |S(f)| and the values of other calibrations, each with bars of ± U, over the model's curve. A
/// static value stands an octave below all frequencies, where a mark says so. Values that are not
/// compared are not drawn.
PlotContent knownMagnitudeCurves(const ResponseResult &response, const UncertaintyReport &report);

/// The same in percent of the sensitivity, from it, as far as the values of other calibrations
/// reach: what a logarithmic axis over a resonance cannot show. Needs a sensitivity.
PlotContent knownDeviationCurves(const ResponseResult &response, const UncertaintyReport &report);

} // namespace dyncal
