// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/exponentials/exponential_sum.h"

#include "core/base/least_squares.h"

#include <algorithm>
#include <cmath>

namespace dyncal {

double ExponentialSum::derivative(double t_s, int k) const
{
    std::complex<double> sum = k == 0 ? constant : 0.0;
    for (Index i = 0; i < poles_rad_s.size(); ++i) {
        std::complex<double> term = amplitudes[i] * std::exp(poles_rad_s[i] * t_s);
        for (int d = 0; d < k; ++d)
            term *= poles_rad_s[i];
        sum += term;
    }
    return sum.real();
}

std::vector<std::complex<double>> pairedPoles(const Eigen::VectorXcd &eigenvalues)
{
    std::vector<std::complex<double>> upper;
    for (const std::complex<double> &z : eigenvalues) {
        if (z.imag() >= 0.0)
            upper.push_back(z);
    }
    std::sort(upper.begin(), upper.end(), [](const auto &a, const auto &b) {
        const double left = std::abs(std::arg(a));
        const double right = std::abs(std::arg(b));
        return left != right ? left < right : std::abs(a) < std::abs(b);
    });
    std::vector<std::complex<double>> poles;
    for (const std::complex<double> &z : upper) {
        poles.push_back(z);
        if (z.imag() > 0.0)
            poles.push_back(std::conj(z));
    }
    return poles;
}

bool isUpperOfPair(const std::vector<std::complex<double>> &poles, std::size_t i)
{
    return poles[i].imag() > 0.0;
}

Eigen::MatrixX2d exponentials(std::complex<double> exponent, Index count, Index origin)
{
    constexpr Index kStep = 64;
    constexpr double kSafe = 600.0; // e^kSafe and its inverse are finite
    const bool isSteep = std::abs(exponent.real()) * static_cast<double>(kStep) > kSafe;
    const Index step = isSteep ? 1 : kStep;
    Eigen::ArrayX2d near(step, 2);
    for (Index j = 0; j < step; ++j) {
        const std::complex<double> power = std::exp(exponent * static_cast<double>(j));
        near.row(j) << power.real(), power.imag();
    }
    Eigen::MatrixX2d all(count, 2);
    for (Index from = 0; from < count; from += step) {
        const std::complex<double> head
            = std::polar(std::exp(exponent.real() * static_cast<double>(from - origin)),
                exponent.imag() * static_cast<double>(from));
        const Index rows = std::min(step, count - from);
        const auto re = near.col(0).head(rows);
        const auto im = near.col(1).head(rows);
        all.col(0).segment(from, rows) = head.real() * re - head.imag() * im;
        all.col(1).segment(from, rows) = head.imag() * re + head.real() * im;
    }
    return all;
}

Eigen::MatrixXd exponentialBasis(const std::vector<std::complex<double>> &poles, Index count,
    bool withConstant, Eigen::VectorXd *scales)
{
    const Index n = static_cast<Index>(poles.size());
    Eigen::MatrixXd basis(count, n + (withConstant ? 1 : 0));
    Eigen::VectorXd divisors = Eigen::VectorXd::Ones(basis.cols());
    for (Index i = 0; i < n; ++i) {
        const std::complex<double> p = poles[static_cast<std::size_t>(i)];
        // Growing exponentials are computed backwards from 1 at the last sample, which avoids
        // overflow.
        const double magnitude = std::abs(p);
        const bool grows = magnitude > 1.0;
        const double log_p = magnitude > 0.0 ? std::log(magnitude) : 0.0;
        if (grows)
            divisors[i] = std::exp(std::min(700.0, log_p * static_cast<double>(count - 1)));
        if (magnitude == 0.0)
            basis.col(i) = Eigen::VectorXd::Unit(count, 0) * (p.imag() >= 0.0 ? 1.0 : 0.0);
        else if (p.imag() >= 0.0)
            basis.col(i) = exponentials({log_p, std::arg(p)}, count, grows ? count - 1 : 0).col(0);
        else
            basis.col(i) = exponentials({log_p, std::arg(p)}, count, grows ? count - 1 : 0).col(1);
    }
    if (withConstant)
        basis.rightCols(1).setOnes();
    if (scales)
        *scales = divisors;
    return basis;
}

AmplitudeFit fitAmplitudes(
    const Eigen::VectorXd &y, const std::vector<std::complex<double>> &poles, bool withConstant)
{
    return fitAmplitudesTogether(Eigen::MatrixXd(y), poles, withConstant).front();
}

std::vector<AmplitudeFit> fitAmplitudesTogether(const Eigen::MatrixXd &records,
    const std::vector<std::complex<double>> &poles, bool withConstant)
{
    Eigen::VectorXd scales;
    const Eigen::MatrixXd basis = exponentialBasis(poles, records.rows(), withConstant, &scales);
    const Eigen::MatrixXd solutions = leastSquares(basis, records);
    std::vector<AmplitudeFit> fits;
    for (const auto &x : solutions.colwise()) {
        AmplitudeFit &fit = fits.emplace_back();
        fit.fitted = basis * x;
        const Index n = static_cast<Index>(poles.size());
        fit.constant = withConstant ? x[n] : 0.0;
        fit.amplitudes.resize(n);
        for (Index i = 0; i < n; ++i) {
            if (isUpperOfPair(poles, static_cast<std::size_t>(i))) {
                // a cos + b (-sin) = 2 Re(c e^(j angle)) with c = (a + j b) / 2
                const std::complex<double> c(
                    x[i] / scales[i] / 2.0, x[i + 1] / scales[i + 1] / 2.0);
                fit.amplitudes[i] = c;
                fit.amplitudes[i + 1] = std::conj(c);
                ++i;
            } else {
                fit.amplitudes[i] = x[i] / scales[i];
            }
        }
    }
    return fits;
}

Eigen::MatrixX2d powerTable(std::complex<double> exponent, Index rows)
{
    const std::complex<double> factor = std::exp(exponent);
    Eigen::MatrixX2d table(rows, 2);
    std::complex<double> power = 1.0;
    for (Index k = 0; k < rows; ++k, power *= factor)
        table.row(k) << power.real(), power.imag();
    return table;
}

ExponentialSampler::ExponentialSampler(const ExponentialSum &sum, double dt_s)
    : m_sum(sum)
    , m_dt_s(dt_s)
    , m_powers(kBlock, 2 * sum.poles_rad_s.size())
{
    for (Index i = 0; i < sum.poles_rad_s.size(); ++i)
        m_powers.middleCols(2 * i, 2) = powerTable(sum.poles_rad_s[i] * dt_s, kBlock);
}

Eigen::VectorXd ExponentialSampler::block(Index block) const
{
    const double t_s = static_cast<double>(block * kBlock) * m_dt_s;
    Eigen::VectorXd gains(m_powers.cols());
    for (Index i = 0; i < m_sum.poles_rad_s.size(); ++i) {
        const std::complex<double> gain
            = m_sum.amplitudes[i] * std::exp(m_sum.poles_rad_s[i] * t_s);
        gains[2 * i] = gain.real();
        gains[2 * i + 1] = -gain.imag();
    }
    return (m_powers * gains).array() + m_sum.constant;
}

} // namespace dyncal
