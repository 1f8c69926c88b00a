// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/message.h"
#include "core/model_analysis/response_result.h"
#include "core/signal/response_window.h"

#include <optional>

namespace dyncal {

/// One characteristic as it may be stated: a value, or a bound, or neither.
struct StatedValue
{
    std::optional<double> value;
    std::optional<double> above; ///< a lower bound, where the value is beyond what is known
    std::optional<double> below; ///< an upper bound
    /// What is printed: "508 kHz", "above 4.00 MHz (the band of the response ends there)", "not
    /// determined (a free decay has no step)". No value has an uncertainty: three digits; bounds
    /// are rounded so that they stay true.
    Message words;
};

struct StatedCharacteristics
{
    StatedValue riseTime_s;
    StatedValue overshoot_percent;
    StatedValue settlingTime_s;
    StatedValue within5percent_Hz;
    StatedValue within10percent_Hz;
    StatedValue minus3dB_Hz;
};

/// Highest frequency at which both answers hold: the measured band ends (fHigh_Hz), or the model
/// does, at half its rate.
double answersEnd_Hz(const ResponseResult &response);

/// Of the model's characteristics what the records can show (docs/method/response.md): a band edge
/// inside the band of the answers, a rise of at least two samples, and rise, top and settling
/// before the window ends. Everything else is a bound, or is not determined.
StatedCharacteristics statedCharacteristics(const ResponseResult &response);

/// Rise time of one shot's record, 10 % to 90 %: shorter than two samples it is a bound. Empty
/// words where there is neither.
StatedValue statedRise(const WindowedResponse &response);

/// Overshoot of one shot's record: none where it rises within two samples, because then the top
/// lies between samples (read 2 % low at six samples per period, worse below).
std::optional<double> statedOvershoot_percent(const WindowedResponse &response);

} // namespace dyncal
