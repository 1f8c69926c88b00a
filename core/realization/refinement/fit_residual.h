// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/realization/exponentials/exponential_sum.h"
#include "core/realization/input/nuisance_term.h"
#include "core/realization/refinement/refinement.h"
#include "core/signal/window_bands.h"

#include <Eigen/Core>

#include <vector>

namespace dyncal {

/// The stretches of a record that take part in a fit, in order.
std::vector<SampleRange> usedRanges(const RefinementRecord &record);

/// What a fit leaves of the samples that took part, one stretch after the other.
Eigen::VectorXd fitResidual(const RefinementRecord &record, const ExponentialSum &sum,
    const std::vector<NuisanceTerm> &terms);

} // namespace dyncal
