// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"

#include <Eigen/Core>

#include <optional>

namespace dyncal {

/// A record of which only every `factor`-th sample was measured.
struct InterpolatedSamples
{
    Index factor = 1;
    bool isRepeated = false; ///< else on straight lines between the measured ones
};

/// Whether samples repeat or lie on straight lines but for every n-th place, as an export at a
/// higher rate than the recorder's makes them. Beyond rounding to steps of `resolution` (0 = none)
/// at least half of these places, and 24 of them, must show a change, and all of them four times as
/// much as the places between. All finite.
std::optional<InterpolatedSamples> interpolatedSamples(
    const Eigen::Ref<const Eigen::VectorXd> &values, double resolution);

} // namespace dyncal
