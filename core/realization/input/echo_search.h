// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/progress.h"
#include "core/realization/input/echo.h"
#include "core/realization/input/rate_choice.h"
#include "core/signal/response_window.h"

#include <optional>

namespace dyncal {

/// What looks most like an echo in one response (docs/method/echo.md): at every time behind the
/// first periods of the ringing (rise times, without one) a level and the resonances from there on
/// are tried beside a parabola and the resonances from before. Where they stand out of the noise,
/// the record's own beginning, y(t - delay), takes their place, with the delay that fits best. It
/// takes 12 or more off chi square, in units of what is left, and leaves a tenth of what it
/// explains beyond the noise, at most. Noise alone does so in most records: whether it is an echo
/// is findEchoes()'s to say. Empty without a record of the noise.
std::optional<Echo> findEcho(
    const WindowedResponse &response, const SensorTraits &traits, const JobControl &control = {});

} // namespace dyncal
