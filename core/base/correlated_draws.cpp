// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/correlated_draws.h"

#include "core/base/distributions.h"

#include <Eigen/Eigenvalues>

#include <limits>

namespace dyncal {
namespace {

/// Semidefinite where two inputs are one: a root by eigenvalues takes that, Cholesky's does not.
Eigen::MatrixXd rootOf(const Eigen::MatrixXd &matrix)
{
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(matrix);
    const Eigen::VectorXd roots = solver.eigenvalues().cwiseMax(0.0).cwiseSqrt();
    return solver.eigenvectors() * roots.asDiagonal() * solver.eigenvectors().transpose();
}

Eigen::MatrixXd matrixOf(const std::vector<UncertainInput> &inputs, const std::vector<Index> &at)
{
    const auto n = std::ssize(at);
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(n, n);
    for (Index i = 0; i < n; ++i)
        for (Index j = 0; j < n; ++j)
            for (const Correlation &one :
                inputs[static_cast<std::size_t>(at[static_cast<std::size_t>(i)])].correlated)
                if (one.quantity
                    == inputs[static_cast<std::size_t>(at[static_cast<std::size_t>(j)])].quantity)
                    matrix(i, j) = matrix(j, i) = one.coefficient;
    return matrix;
}

double normalProbability(double z)
{
    return studentSurvival(-z, std::numeric_limits<double>::infinity());
}

} // namespace

CorrelatedDraws::CorrelatedDraws(const std::vector<UncertainInput> &inputs)
{
    for (Index i = 0; i < std::ssize(inputs); ++i)
        if (!inputs[static_cast<std::size_t>(i)].correlated.empty())
            m_at.push_back(i);
    if (!m_at.empty())
        m_root = rootOf(matrixOf(inputs, m_at));
}

void CorrelatedDraws::apply(Eigen::VectorXd &p) const
{
    if (m_at.empty())
        return;
    const Eigen::VectorXd z = m_root * p(m_at).unaryExpr(&normalQuantile);
    p(m_at) = z.unaryExpr(&normalProbability);
}

} // namespace dyncal
