// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/hankel_operator.h"

namespace dyncal {

HankelOperator::HankelOperator(
    const Eigen::VectorXd &y, Index rows, Index columns, bool projectOnes)
    : m_y(y.head(rows + columns - 1))
    , m_rows(rows)
    , m_columns(columns)
    , m_projectOnes(projectOnes)
    , m_fft(fastFftLength(m_y.size()))
    , m_spectrum(m_fft.forward(m_y))
{
}

// sum_j y(i + j) x(j) for i < count: circular over L >= rows + columns - 1, so nothing wraps.
Eigen::VectorXd HankelOperator::correlate(const Eigen::VectorXd &x, Index count) const
{
    const Eigen::VectorXcd product = m_spectrum.cwiseProduct(m_fft.forward(x).conjugate());
    return m_fft.inverse(product).head(count);
}

Eigen::VectorXd HankelOperator::times(const Eigen::Ref<const Eigen::VectorXd> &x) const
{
    Eigen::VectorXd input = x;
    if (m_projectOnes)
        input.array() -= input.mean();
    return correlate(input, m_rows);
}

Eigen::VectorXd HankelOperator::transposedTimes(const Eigen::Ref<const Eigen::VectorXd> &x) const
{
    Eigen::VectorXd result = correlate(x, m_columns);
    if (m_projectOnes)
        result.array() -= result.mean();
    return result;
}

Eigen::MatrixXd HankelOperator::dense() const
{
    Eigen::MatrixXd matrix(m_rows, m_columns);
    for (Index j = 0; j < m_columns; ++j)
        matrix.col(j) = m_y.segment(j, m_rows);
    if (m_projectOnes)
        matrix.colwise() -= matrix.rowwise().mean().eval();
    return matrix;
}

} // namespace dyncal
