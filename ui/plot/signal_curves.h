// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/capture_set.h"
#include "core/signal/power_spectrum.h"
#include "core/signal/response_window.h"
#include "ui/plot/plot_content.h"

namespace dyncal {

inline constexpr Index kRawBuckets = 4000;

/// Records of one channel role, all included shots over each other, each on its own time axis.
/// Records longer than 2 kRawBuckets samples are shown as exact min/max of at most kRawBuckets
/// stretches, taken from the counts (display only; a spike of one sample stays visible).
PlotContent rawCurves(const CaptureSet &set, ChannelRole role);

/// Responses aligned at their starts, as the analysis uses them.
PlotContent windowCurves(const WindowResult &window);

/// The first moments of the same responses: from just before the start over some twenty rise
/// times.
PlotContent startCurves(const WindowResult &window);

/// Power spectral densities in dB over log frequency, resonances marked.
PlotContent spectrumCurves(const SpectrumResult &spectrum, const WindowResult &window);

} // namespace dyncal
