// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/capture_set.h"

#include <Eigen/Core>

#include <string>

namespace dyncal {

/// A channel of doubles in V whose first sample is at time 0.
Channel knownChannel(
    const std::string &name, ChannelRole role, const Eigen::VectorXd &values, double rate_Hz);

/// One shot of such channels.
CaptureSet knownSet(std::vector<Channel> channels);

/// A step from `baseline` by `height` at sample `at`.
Eigen::VectorXd sharpStep(Index count, Index at, double baseline, double height);

inline constexpr double kShockRecordRate_Hz = 1e6;

/// A shot at 1 MHz: sensors "far" and "near" see the step at 2 and 3 ms, the DUT at 4 ms.
CaptureSet shockRecords();

} // namespace dyncal
