// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <optional>

namespace dyncal {

/// Characteristics of the model's step response and bands, all from the parametric model, wherever
/// they lie: what of them may be stated is statedCharacteristics().
struct StepCharacteristics
{
    std::optional<double> riseTime_s;
    std::optional<double> overshoot_percent;
    std::optional<double> settlingTime_s;
    std::optional<double> within5percent_Hz;
    std::optional<double> within10percent_Hz;
    std::optional<double> minus3dB_Hz;
    std::optional<double> top_s = std::nullopt; ///< where the response is highest, after the onset
};

} // namespace dyncal
