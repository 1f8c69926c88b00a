// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/refinement/refinement.h"

namespace dyncal {

ExponentialSum perturbed(const Refinement &refinement, Index record, Index index, double delta)
{
    ExponentialSum sum = refinement.records[static_cast<std::size_t>(record)];
    const Index n = refinement.poleParameters;
    if (index == 2 * n) {
        sum.constant += delta;
        return sum;
    }
    const bool movesPole = index < n;
    const Index i = movesPole ? index : index - n;
    Eigen::VectorXcd &values = movesPole ? sum.poles_rad_s : sum.amplitudes;
    const double share = movesPole ? delta : delta / 2.0; // amplitudes are fitted as 2 Re, 2 Im
    const std::vector<std::complex<double>> &poles = refinement.poles_rad_s;
    if (isUpperOfPair(poles, static_cast<std::size_t>(i))) {
        values[i] += share;
        values[i + 1] += share;
    } else if (i > 0 && isUpperOfPair(poles, static_cast<std::size_t>(i - 1))) {
        values[i - 1] += std::complex<double>(0.0, share);
        values[i] -= std::complex<double>(0.0, share);
    } else {
        values[i] += delta;
    }
    return sum;
}

Eigen::MatrixXd recordCovariance(const Refinement &refinement, Index record)
{
    const Index n = refinement.poleParameters;
    const Index m = n + (refinement.withConstant ? 1 : 0);
    const Index offset = refinement.offsets[static_cast<std::size_t>(record)];
    Eigen::MatrixXd covariance(n + m, n + m);
    covariance.topLeftCorner(n, n) = refinement.covariance.topLeftCorner(n, n);
    covariance.topRightCorner(n, m) = refinement.covariance.block(0, offset, n, m);
    covariance.bottomLeftCorner(m, n) = refinement.covariance.block(offset, 0, m, n);
    covariance.bottomRightCorner(m, m) = refinement.covariance.block(offset, offset, m, m);
    return covariance;
}

Eigen::Matrix4d nuisanceCovariance(const Refinement &refinement, Index record, Index term)
{
    const Index own = refinement.poleParameters + (refinement.withConstant ? 1 : 0);
    const Index at = refinement.offsets[static_cast<std::size_t>(record)] + own + 4 * term;
    return refinement.covariance.block<4, 4>(at, at);
}

} // namespace dyncal
