// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/base/result.h"
#include "core/signal/response_window.h"
#include "core/signal/spectrum_analysis.h"

#include <optional>
#include <vector>

namespace dyncal {

/// A resonance that stands out of the spectra.
struct RingingTraits
{
    double frequency_Hz = 0.0;
    std::optional<double> ringTime_s; ///< Q / (pi f): its decay time; empty without a Q
};

/// What is known of the sensor before any model: enough to choose rate and length of the input.
struct SensorTraits
{
    std::vector<RingingTraits> ringing; ///< the most prominent, and those within 6 dB of it
                                        ///< that are none of its harmonics
    std::optional<double> riseTime_s; ///< 10-90 %, mean over the shots that show it
    bool drifts = false; ///< nothing rings, and the level changes behind twenty rise times
};

SensorTraits sensorTraits(
    const std::vector<WindowedResponse> &responses, const SpectrumResult &spectrum);

/// Rule "auto" of input.sample_rate_hz: the largest reduction 1, 2, 5, 10, 20 ... that leaves four
/// samples per period of every resonance that stands out, and a filter no longer than the shortest
/// of their ring times; without a resonance ten samples
/// per rise time and a filter no longer than half of it; with neither, no reduction.
Index chooseReduction(double rate_Hz, const SensorTraits &traits);

/// Rule "auto" of input.samples: twelve of the longest ring times (twenty rise times), within
/// 200..1000; 2000 where the level drifts behind twenty rise times, or the drift moves the poles
/// and no part of the model says so.
Index chooseSamples(double rate_Hz, const SensorTraits &traits);

/// MIN-001 as an error (the rate cannot represent the most prominent resonance), MIN-002 as a
/// finding.
Result<Findings> judgeRate(double rate_Hz, const SensorTraits &traits);

/// MIN-006: the input starts while the anti-alias filter still sees the time before the onset.
Finding insideFilterFinding(double offset_s, double needed_s);

} // namespace dyncal
