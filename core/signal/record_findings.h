// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/signal/response_window.h"

namespace dyncal {

/// What the samples of a response of `channel` tell of how they were recorded; cautions. WIN-010:
/// the record is not quiet before its start (unrest.h), by more than 0.3 % of the step, over the
/// baseline or over the record's first 20000 samples. WIN-011: the record before the start is not
/// at the baseline's level (0.5 % of the step), or has left it by 10 % where the start was typed;
/// or a typed start lies before the response: more than four times as long (and two samples) to a
/// quarter of the step as from there to the half.
/// CAP-034: most of its samples were not measured (interpolated_samples.h).
Findings recordFindings(const WindowedResponse &response, const Channel &channel);

} // namespace dyncal
