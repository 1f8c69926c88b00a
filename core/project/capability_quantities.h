// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <array>

namespace dyncal {

/// What an entry of uncertainty.cmc may be the least U of. The last eleven are values of the model,
/// named with their units.
inline constexpr std::array kCapabilityQuantities{"sensitivity", "magnitude", "phase_rad", "f0_hz",
    "damping_ratio", "q", "resonance_hz", "resonance_gain", "within_5_percent_hz",
    "within_10_percent_hz", "minus_3_db_hz", "rise_time_s", "overshoot_percent", "settling_time_s"};

} // namespace dyncal
