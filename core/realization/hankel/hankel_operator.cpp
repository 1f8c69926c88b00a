// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/hankel/hankel_operator.h"

#include "core/base/parallel.h"

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

namespace {

constexpr Index kThreadLength
    = 20'000; ///< an FFT of this length takes longer than starting a thread

} // namespace

HankelGram::HankelGram(const std::vector<HankelOperator> &blocks)
    : m_blocks(blocks)
{
}

void HankelGram::apply(const Eigen::Ref<const Eigen::MatrixXd> &X, Eigen::Ref<Eigen::MatrixXd> Y)
{
    if (static_cast<Index>(m_buffers.size()) < X.cols())
        m_buffers.resize(static_cast<std::size_t>(X.cols()));
    forEachPart(X.cols(), m_blocks.front().m_fft.length() > kThreadLength, [&](Index j) {
        applyToColumn(X.col(j).data(), Y.col(j).data(), m_buffers[static_cast<std::size_t>(j)]);
    });
}

void HankelGram::applyToColumn(const double *x, double *y, Buffers &buffers) const
{
    const Index rows = size();
    const RealFft &fft = m_blocks.front().m_fft; // all blocks have one length
    const Index length = fft.length();
    buffers.time.resize(length);
    buffers.input.resize(length / 2 + 1);
    buffers.middle.resize(length / 2 + 1);
    buffers.sum.setZero(length / 2 + 1);

    buffers.time.head(rows) = Eigen::Map<const Eigen::VectorXd>(x, rows);
    buffers.time.tail(length - rows).setZero();
    fft.forward(buffers.time, buffers.input);
    const double scale = 1.0 / static_cast<double>(length);
    for (const HankelOperator &block : m_blocks) {
        buffers.middle = block.m_spectrum.cwiseProduct(buffers.input.conjugate());
        fft.inverseUnscaled(buffers.middle, buffers.time);
        const double mean = block.m_projectOnes ? buffers.time.head(block.columns()).mean() : 0.0;
        buffers.time.head(block.columns()).array() -= mean;
        buffers.time.tail(length - block.columns()).setZero();
        fft.forward(buffers.time, buffers.middle);
        buffers.sum += block.m_spectrum.cwiseProduct(buffers.middle.conjugate());
    }
    fft.inverseUnscaled(buffers.sum, buffers.time);
    Eigen::Map<Eigen::VectorXd>(y, rows) = buffers.time.head(rows) * (scale * scale);
}

SymmetricHankel::SymmetricHankel(const HankelOperator &H)
    : m_H(H)
{
    eigen_assert(H.isSymmetric());
}

void SymmetricHankel::apply(
    const Eigen::Ref<const Eigen::MatrixXd> &X, Eigen::Ref<Eigen::MatrixXd> Y)
{
    if (static_cast<Index>(m_buffers.size()) < X.cols())
        m_buffers.resize(static_cast<std::size_t>(X.cols()));
    const RealFft &fft = m_H.m_fft;
    const Index length = fft.length();
    forEachPart(X.cols(), length > kThreadLength, [&](Index j) {
        Buffers &buffers = m_buffers[static_cast<std::size_t>(j)];
        buffers.time.resize(length);
        buffers.spectrum.resize(length / 2 + 1);
        buffers.time.head(size()) = X.col(j);
        buffers.time.tail(length - size()).setZero();
        fft.forward(buffers.time, buffers.spectrum);
        buffers.spectrum = m_H.m_spectrum.cwiseProduct(buffers.spectrum.conjugate());
        fft.inverseUnscaled(buffers.spectrum, buffers.time);
        Y.col(j) = buffers.time.head(size()) / static_cast<double>(length);
    });
}

} // namespace dyncal
