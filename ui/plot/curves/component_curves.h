// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/decomposition/component_result.h"
#include "core/signal/response_window.h"
#include "ui/plot/values/plot_content.h"

namespace dyncal {

/// Share of the shots' energy that the first 1, 2, ... components explain, as bars; empty with one
/// shot.
PlotContent explainedCurves(const ComponentResult &components);

/// What the first 1, 2, ... components leave of it, in percent, logarithmic; not all of them, which
/// leave nothing.
PlotContent remainderCurves(const ComponentResult &components);

/// Every shot reconstructed from the components kept.
PlotContent reconstructionCurves(const ComponentResult &components, const WindowResult &window);

/// What the reconstruction leaves of every shot.
PlotContent residualCurves(const ComponentResult &components, const WindowResult &window);

/// Autocovariance of the residuals with the bounds of white noise. `shot` (a number from 1) shows
/// that one alone.
PlotContent autocovarianceCurves(const ComponentResult &components, const WindowResult &window,
    std::optional<Index> shot = std::nullopt);

/// Power spectra of the residuals, prominent maxima marked.
PlotContent residualSpectrumCurves(const ComponentResult &components, const WindowResult &window);

/// Average of the reconstructions.
PlotContent averageCurves(const ComponentResult &components, const WindowResult &window);

} // namespace dyncal
