// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/propagation.h"

#include <Eigen/Core>

#include <vector>

namespace dyncal {

/// Makes draws of independent probabilities into draws of correlated inputs, each with its own
/// distribution (a Gaussian copula: NORTA, M. C. Cario, B. L. Nelson 1997). The coefficients are
/// those of the normal deviates behind the draws; of rectangles they come out as 6/pi asin(r/2), at
/// most 2 % of r less.
class CorrelatedDraws
{
public:
    explicit CorrelatedDraws(const std::vector<UncertainInput> &inputs);

    /// `p`: a probability for each input; those of inputs without a correlation stay as they are.
    void apply(Eigen::VectorXd &p) const;

private:
    std::vector<Index> m_at; ///< the inputs that are correlated with others
    Eigen::MatrixXd m_root; ///< symmetric root of their correlation matrix
};

} // namespace dyncal
