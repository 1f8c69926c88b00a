// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/base/progress.h"
#include "core/realization/input/echo.h"
#include "core/realization/input/rate_choice.h"
#include "core/signal/response_window.h"

#include <vector>

namespace dyncal {

/// The echoes of all shots (echo_search.h), and the time before the earliest: what comes after it
/// is no longer the answer to one step. An echo hides behind a stronger one, so the records are
/// searched again up to the earliest, until they have none. Nothing is shortened where `mayShorten`
/// is false.
Echoes findEchoes(const std::vector<WindowedResponse> &responses, const SensorTraits &traits,
    bool mayShorten, const JobControl &control = {});

/// The responses up to a time after their start; values behind it are gone too, so that no filter
/// sees them.
std::vector<WindowedResponse> endingAt(
    const std::vector<WindowedResponse> &responses, double end_s);

/// MIN-007 for every echo.
Findings judgeEchoes(const Echoes &echoes);

} // namespace dyncal
