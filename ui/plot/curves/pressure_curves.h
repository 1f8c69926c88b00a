// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/correction/correction_files.h"
#include "ui/plot/values/plot_content.h"

namespace dyncal {

/// The pressure of every shot of a correction over the recording's own time, with its band of 95 %:
/// pressure +- k u.
PlotContent pressureCurves(const CorrectionOutcome &outcome, const CaptureSet &captures);

/// Values of all shots: about as many points have the curves made of them.
Index pointsOf(const CorrectionOutcome &outcome);

} // namespace dyncal
