// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"
#include "core/realization/hankel/lanczos.h"
#include "core/signal/fft.h"

#include <Eigen/Core>

#include <vector>

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
    bool isSymmetric() const { return m_rows == m_columns && !m_projectOnes; }

    Eigen::VectorXd times(const Eigen::Ref<const Eigen::VectorXd> &x) const; ///< H x
    Eigen::VectorXd transposedTimes(const Eigen::Ref<const Eigen::VectorXd> &x) const; ///< H^T x
    Eigen::MatrixXd dense() const;

private:
    friend class HankelGram;
    friend class SymmetricHankel;
    Eigen::VectorXd correlate(const Eigen::VectorXd &x, Index count) const;

    Eigen::VectorXd m_y;
    Index m_rows;
    Index m_columns;
    bool m_projectOnes;
    RealFft m_fft;
    Eigen::VectorXcd m_spectrum; ///< of y, over the length of the FFT
};

/// x -> sum_i H_i H_i^T x of [H_1 H_2 ...]: its eigenvalues are the squared singular values. Costs
/// 2 + 2 FFTs per block: the sum is formed in the frequency domain. Refers to `blocks`.
class HankelGram : public SymmetricOperator
{
public:
    explicit HankelGram(const std::vector<HankelOperator> &blocks);
    Index size() const override { return m_blocks.front().rows(); }
    void apply(const Eigen::Ref<const Eigen::MatrixXd> &X, Eigen::Ref<Eigen::MatrixXd> Y) override;

private:
    struct Buffers
    {
        Eigen::VectorXd time;
        Eigen::VectorXcd input; ///< spectrum of x
        Eigen::VectorXcd middle; ///< of H^T x
        Eigen::VectorXcd sum; ///< of the sum over the blocks
    };
    void applyToColumn(const double *x, double *y, Buffers &buffers) const;
    const std::vector<HankelOperator> &m_blocks;
    std::vector<Buffers> m_buffers; ///< one set per column of a block of vectors
};

/// x -> H x of one square, unprojected matrix: H = H^T, so the singular values are the magnitudes
/// of its eigenvalues, at two FFTs each and without squaring. Refers to `H`.
class SymmetricHankel : public SymmetricOperator
{
public:
    explicit SymmetricHankel(const HankelOperator &H);
    Index size() const override { return m_H.rows(); }
    void apply(const Eigen::Ref<const Eigen::MatrixXd> &X, Eigen::Ref<Eigen::MatrixXd> Y) override;

private:
    struct Buffers
    {
        Eigen::VectorXd time;
        Eigen::VectorXcd spectrum;
    };
    const HankelOperator &m_H;
    std::vector<Buffers> m_buffers;
};

} // namespace dyncal
