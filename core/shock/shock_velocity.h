// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/message.h"
#include "core/base/result.h"
#include "core/capture/capture_set.h"
#include "core/shock/shock_settings.h"

#include <optional>

namespace dyncal {

inline constexpr const char *kEndWall = "end-wall";
inline constexpr const char *kSideWall = "side-wall";

/// Shock velocity of one shot, or why there is none.
struct VelocityEstimate
{
    std::optional<double> velocity_m_s;
    std::optional<double> arrival_s; ///< at the sensor farthest from the end wall, record axis
    double distance_m = 0.0; ///< of that sensor to the end wall
    double relativeDistanceUncertainty = 0.0; ///< what u(distance) alone does to the velocity
    std::optional<Message> missing; ///< an input that is not there
    std::optional<Error> problem; ///< inputs that contradict each other
};

/// The typed velocity; else the straight line through where and when the shock was seen: the
/// arrival sensors (of the recipe; else the first driven-side channel at the tube's
/// "endflange_to_sensor2_m") and, for a DUT in the end wall, the DUT itself. Two places are
/// needed; with more the line is fitted by least squares, times against distances.
VelocityEstimate estimateVelocity(const CaptureSet &set, const Shot &shot,
    const std::optional<double> &dutArrival_s, const ShockSettings &settings);

} // namespace dyncal
