// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"

#include <Eigen/Core>

#include <optional>

namespace dyncal {

/// One value at which a record stood still.
struct StuckValues
{
    Index begin = 0; ///< of the longest run
    Index longest = 0; ///< samples of that run
    Index total = 0; ///< samples of all runs at this value that noise does not explain
};

/// Longest run of equal samples, among `size` samples, that the noise of `quiet` (a stretch at
/// rest) explains: a longer run would occur in less than one of a million records. The larger of
/// two estimates: one from the runs in `quiet`, one from noise of the same spread with the level in
/// the middle of a code. Empty where `quiet` shows no noise: it is constant, as a computed record
/// is, or so coarse that its noise cannot be known.
std::optional<double> longestExplainedRun(
    const Eigen::Ref<const Eigen::VectorXd> &quiet, Index size);

/// The value at which `values` stood still longest although `quiet` shows noise; empty if no run is
/// longer than that noise explains. All finite.
std::optional<StuckValues> stuckValues(const Eigen::Ref<const Eigen::VectorXd> &values,
    const Eigen::Ref<const Eigen::VectorXd> &quiet);

} // namespace dyncal
