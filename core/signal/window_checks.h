// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/base/result.h"
#include "core/capture/channel.h"
#include "core/signal/response_window.h"
#include "core/signal/signal_settings.h"
#include "core/signal/window_bands.h"

#include <optional>

namespace dyncal {

/// CAP-006 when the baseline, the window or what lies between them holds invalid samples, CAP-007
/// when one of the two is saturated on a converter whose rails are known. With both, one stands
/// behind the other in `further`.
std::optional<Error> unusableSamples(
    const Channel &channel, Index shot, const WindowBands &bands, const CheckSettings &checks = {});

/// Samples in a row at one extreme.
struct SaturatedRun
{
    Index begin = 0;
    Index count = 0;
};

/// The first run of at least `leastRun` samples at a rail of the converter; none where the rails
/// are not known.
std::optional<SaturatedRun> runAtRail(const Channel &channel, const SampleRange &range,
    Index leastRun = CheckSettings().saturationRun);

/// The longest run of at least `leastRun` equal samples at an extreme of `values` that was cut off
/// there (isCutOff).
std::optional<SaturatedRun> runAtExtreme(const Eigen::Ref<const Eigen::VectorXd> &values,
    double noiseSd, double codeSize, Index leastRun = CheckSettings().saturationRun);

/// The same of a response's window, with the response's own noise and resolution.
std::optional<SaturatedRun> runAtExtreme(const WindowedResponse &response, Index leastRun);

/// What a line through a band makes of half of it, in shares of the step; u for white noise.
struct HalfDrift
{
    double share = 0.0; ///< 0 or more
    double u = 0.0;
};
HalfDrift halfDrift(const WindowedResponse &response, double slope_per_s, const Interval &band);

/// CAP-007 (caution), CAP-012, CAP-014, WIN-001, WIN-003, WIN-004, WIN-006 of one response.
Findings windowFindings(const WindowedResponse &response, const WindowSettings &settings,
    const WindowContext &context, std::optional<double> plateau_s);

} // namespace dyncal
