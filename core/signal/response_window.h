// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/base/index.h"
#include "core/base/interval.h"
#include "core/capture/capture_set.h"
#include "core/capture/check_settings.h"
#include "core/signal/signal_settings.h"
#include "core/signal/start_detection.h"

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace dyncal {

/// The response of one shot: the DUT's record around the start as doubles, remapped where asked.
/// Times are seconds relative to the start (values[lead] is at time 0).
struct WindowedResponse
{
    Index shot = 0; ///< number from 1 within the capture set
    std::string label;
    ShotLevel level = ShotLevel::None;
    std::string channel;
    std::string unit; ///< of baseline, settled, step, noiseSd
    std::string recordedUnit; ///< of the recording where `unit` is its SI unit; else empty
    double sampleRate_Hz = 0.0;
    double start_s = 0.0; ///< of values[lead], on the record's own axis
    Index startSample = 0; ///< its position in the record
    bool startDetected = true;

    Interval baseline_s; ///< bands as used
    Interval settle_s;
    double end_s = 0.0;

    double baseline = 0.0; ///< level at the start, before the step (baseline_level.h)
    double baselineVarianceFactor = 1.0; ///< of that level's variance over that of a mean
    double baselineSlope_per_s = 0.0;
    double settled = 0.0; ///< mean of the settle band (impulse treatment: 0)
    double settleSlope_per_s = 0.0;
    double step = 0.0; ///< settled - baseline (impulse treatment: peak excursion, signed)
    double resolution = 0.0; ///< step to which the samples were rounded, in `unit` (rounding.h)
    double noiseSd = 0.0; ///< sd about the baseline's line, at least that of rounding
                          ///< (resolution/sqrt(12)), in `unit`; 0 = not known (nothing subtracted)
    double snr_dB = 0.0; ///< 20 log10(|step| / noiseSd); infinite where noiseSd is 0

    double valueScale = 1.0; ///< physical = baseline + valueScale * value; the step if remapped
    Eigen::VectorXd values; ///< from the begin of the baseline (or earlier) past the window's end
    Index lead = 0; ///< samples of `values` before the start
    Index length = 0; ///< samples of the window proper: values[lead .. lead + length)
    Eigen::VectorXd noise; ///< pre-trigger noise in the units of `values`, detrended
    double roundingSd = 0.0; ///< rounding error of `values` that averaging does not remove

    /// Empty below 20 dB SNR; overshoot and settling also below 38 dB, where noise decides them.
    std::optional<double> riseTime_s; ///< 10-90 % of the step, first crossings, interpolated
    std::optional<double> overshoot_percent;
    std::optional<double> settlingTime_s; ///< last entry into +-5 % of the plateau

    /// The window proper.
    Eigen::Ref<const Eigen::VectorXd> window() const { return values.segment(lead, length); }
};

struct WindowResult
{
    std::vector<WindowedResponse> responses; ///< one per included shot, in shot order
    Findings findings;
};

/// What the window stage needs beside its own settings.
struct WindowContext
{
    ResponseTreatment treatment = ResponseTreatment::StepDeflated;
    bool remap = true;
    std::vector<std::optional<double>> plateau_s; ///< per shot of the set; for end "plateau"
    CheckSettings checks; ///< limits of CAP-007, CAP-009 and CAP-014
    /// Of the DUTs, per shot of the set, as detectStart() found them; where empty it is called.
    std::vector<std::optional<DetectedStart>> starts = {};
};

} // namespace dyncal
