// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/input_draws.h"
#include "core/base/portable_random.h"
#include "core/base/propagation.h"

#include <Eigen/Core>

#include <cstdint>
#include <memory>
#include <vector>

namespace dyncal {

/// The sources that trials draw: one random stream for each name, one number of it for each trial,
/// so that a trial is the same whatever else is drawn, in whatever order.
class SourceDraws
{
public:
    /// Position of the source. One that is not `common` is each shot's own. A source may be added
    /// again, as known to another shot: the same error, each with its own u and distribution.
    Index add(const UncertainInput &input, Index shot = 0);

    /// The probability below the drawn deviate of each source (correlated ones joined), in the
    /// order of their positions, in trial `trial`, from 0.
    Eigen::VectorXd probabilities(std::uint64_t seed, Index trial) const;

    Index size() const { return std::ssize(m_sources); }

private:
    std::vector<UncertainInput> m_sources;
    std::vector<Index> m_streams;
    std::shared_ptr<const CorrelatedDraws> m_correlated;
};

/// One input of a value: how it is distributed, and which source it follows.
struct DrawnInput
{
    UncertainInput input;
    Index source = 0;

    double value(const Eigen::VectorXd &probabilities) const;
};

/// Chi square with `dof` > 0 degrees of freedom over dof, by rejection (G. Marsaglia, W. W. Tsang,
/// ACM TOMS 26 (2000) 363): the variance that so many observations find in place of 1. 1 where dof
/// is infinite or not known.
double drawnVariance(RandomStream &stream, double dof);

} // namespace dyncal
