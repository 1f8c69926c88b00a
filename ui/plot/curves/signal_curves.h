// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/capture_set.h"
#include "core/capture/channel_envelope.h"
#include "core/signal/response_window.h"
#include "core/signal/spectrum_analysis.h"
#include "ui/plot/values/plot_content.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace dyncal {

inline constexpr Index kRawColumns = 4000;

/// More than 2 kRawColumns samples: shown as exact extremes of columns.
bool isLongRecord(const Channel &channel);

/// The long records among those that plots show.
std::vector<Channel> longRecords(const CaptureSet &set);

/// Where envelopes of long records come from; null while one is not there yet.
using EnvelopeSource = std::function<std::shared_ptr<const ChannelEnvelope>(const Channel &)>;

/// Units of the records of one channel role, in the order of the shots: each needs an axis of its
/// own.
std::vector<std::string> unitsOf(const CaptureSet &set, ChannelRole role);

/// Records of one channel role, all included shots over each other, each on its own time axis; of
/// those that differ in unit the ones in `unit`, by default that of the first. Of
/// long records the points are exact minima and maxima of at most kRawColumns stretches (a spike
/// of one sample stays visible). With `envelopeOf`, views of them are drawn at full resolution and
/// a record without envelope yet has no points; without it, the records are read here and now.
PlotContent rawCurves(const CaptureSet &set, ChannelRole role,
    const EnvelopeSource &envelopeOf = {}, const std::optional<std::string> &unit = {});

/// Responses aligned at their starts, as the analysis uses them.
PlotContent windowCurves(const WindowResult &window);

/// Values of all responses: about as many points have the curves made of them.
Index pointsOf(const WindowResult &window);

/// How long after the start the responses ring: what a first view of a long plateau shows large.
double ringingEnd_s(const WindowResult &window);

/// The first moments of the same responses: from just before the start over some twenty rise
/// times.
PlotContent startCurves(const WindowResult &window);

/// Power spectral densities in dB over log frequency, resonances marked.
PlotContent spectrumCurves(const SpectrumResult &spectrum, const WindowResult &window);

} // namespace dyncal
