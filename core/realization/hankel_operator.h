// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"
#include "core/signal/fft.h"

#include <Eigen/Core>

namespace dyncal {

/// The Hankel matrix H(i, j) = y(i + j), r x s with r + s - 1 <= y.size(), as products only:
/// H x is a correlation, so it costs two FFTs and the matrix is never formed. With
/// `projectOnes` the matrix is H (I - 11^T / s): each row without its mean, which removes a
/// constant from y exactly (docs/method/hankel.md).
class HankelOperator
{
public:
    HankelOperator(const Eigen::VectorXd &y, Index rows, Index columns, bool projectOnes);

    Index rows() const { return m_rows; }
    Index columns() const { return m_columns; }

    Eigen::VectorXd times(const Eigen::Ref<const Eigen::VectorXd> &x) const; ///< H x
    Eigen::VectorXd transposedTimes(const Eigen::Ref<const Eigen::VectorXd> &x) const; ///< H^T x
    Eigen::MatrixXd dense() const;

private:
    Eigen::VectorXd correlate(const Eigen::VectorXd &x, Index count) const;

    Eigen::VectorXd m_y;
    Index m_rows;
    Index m_columns;
    bool m_projectOnes;
    RealFft m_fft;
    Eigen::VectorXcd m_spectrum;
};

} // namespace dyncal
