// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/capture/capture_set.h"
#include "core/signal/response_window.h"
#include "core/signal/signal_settings.h"

namespace dyncal {

/// Cuts the response of every included shot (thesis 3.7 step 2): start, baseline, window, settle
/// band, remap to 0..1. Rules of each "auto": docs/method/window.md. Fails (DataBlocked) with the
/// finding's id on CAP-002 (no DUT), CAP-006 (invalid samples inside), CAP-007 (saturated inside),
/// CAP-009 (no step), WIN-002 (baseline over the step or too short), and on a window that leaves
/// the record; all errors carry the shot. A shot whose baseline is not at rest is reported
/// (CAP-020, block) and not used; fails if no shot is left. Findings: CAP-007 (caution, rails
/// unknown), CAP-012, CAP-014, CAP-020, CAP-034, WIN-001, WIN-003, WIN-004, WIN-006, WIN-010.
/// Drifts are percent of the step per ms.
Result<WindowResult> cutWindows(const CaptureSet &set, const WindowSettings &settings,
    const WindowContext &context, const JobControl &control = {});

/// The same stretch of time of another channel of the same shot, with the same baseline and settle
/// band as `dut`, remapped to 0..1 of its own step: a reference transducer beside the DUT. Its
/// start is the sample nearest to the DUT's. Fails (DataBlocked; CAP-006, CAP-007, CAP-009) where
/// samples are invalid or saturated, where there is no step, or where its record does not hold the
/// window. Only of step treatments.
Result<WindowedResponse> cutAlongside(const Shot &shot, const Channel &channel,
    const WindowedResponse &dut, const CheckSettings &checks);

} // namespace dyncal
