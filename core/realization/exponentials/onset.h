// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/realization/exponentials/exponential_sum.h"

#include <optional>

namespace dyncal {

/// Time at which a step response described by `response` begins (sub-sample): for a sensor of
/// relative degree two its first derivative vanishes there; with one real pole more (relative
/// degree three) the second; for a first-order lag, alone or with a drift (the slower of two real
/// poles, whose part is the smaller one, as it never is of a sensor's two), the value itself
/// (docs/method/model.md: y = 0 is a double root and ill-posed for higher degrees). Searched within
/// `search_s` on either side of time 0, where the start was detected. Empty if there is no such
/// point.
std::optional<double> findOnset_s(const ExponentialSum &response, double search_s);

} // namespace dyncal
