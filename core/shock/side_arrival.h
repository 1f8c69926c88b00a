// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/channel.h"

#include <optional>

namespace dyncal {

/// Time (record axis) at which a side-wall sensor crosses 50 % of its own step p1 -> p2: level
/// before from the detected start, level after as the median of the second and third quarter
/// between the start and `reflectionFree_s` (a time until which the reflected shock cannot be
/// back, such as the arrival at the end wall). Where that is unknown or not after the start, the
/// half millisecond behind the start serves. Empty where no arrival is found.
std::optional<double> sideArrival_s(
    const Channel &channel, const std::optional<double> &reflectionFree_s);

} // namespace dyncal
