// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/second_order/front_fit.h"

#include "core/realization/input/whitening.h"
#include "core/realization/refinement/levenberg_marquardt.h"
#include "core/realization/second_order/soft_step.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dyncal {
namespace {

/// Parameters: ln w0, ln zeta, (ln T,) then K and onset of each record; times in 1/w0 of the start.
class FrontProblem
{
public:
    FrontProblem(
        const std::vector<EarlyRecord> &records, double unit_s, double given_s, bool isFree)
        : m_records(records)
        , m_unit_s(unit_s)
        , m_given_s(given_s)
        , m_isFree(isFree)
    {
    }

    Index shared() const { return m_isFree ? 3 : 2; }
    Index parameters() const { return shared() + 2 * std::ssize(m_records); }
    Index plateauAt(std::size_t record) const { return shared() + 2 * static_cast<Index>(record); }

    double duration_s(const Eigen::VectorXd &theta) const
    {
        return m_isFree ? std::exp(theta[2]) * m_unit_s : m_given_s;
    }

    RegressionEquations equations(const Eigen::VectorXd &theta) const
    {
        const Index count = parameters();
        RegressionEquations sum{
            Eigen::MatrixXd::Zero(count, count), Eigen::VectorXd::Zero(count), 0.0};
        for (std::size_t r = 0; r < m_records.size(); ++r)
            add(theta, r, sum);
        return sum;
    }

private:
    const std::vector<EarlyRecord> &m_records;
    double m_unit_s;
    double m_given_s;
    bool m_isFree;

    Eigen::VectorXd response(const Eigen::VectorXd &theta, std::size_t r) const
    {
        const EarlyRecord &record = m_records[r];
        const double plateau = theta[plateauAt(r)];
        const double onset_s = theta[plateauAt(r) + 1] * m_unit_s;
        Eigen::VectorXd y(record.y.size());
        for (Index k = 0; k < y.size(); ++k)
            y[k] = plateau
                * softStep(std::exp(theta[0]) / m_unit_s, std::exp(theta[1]), duration_s(theta),
                    record.first_s + static_cast<double>(k) / record.rate_Hz - onset_s);
        return record.weight * whitened(y, record.whitening);
    }

    void add(const Eigen::VectorXd &theta, std::size_t r, RegressionEquations &sum) const
    {
        constexpr double kStep = 1e-5; // of a logarithm, a plateau, and 1/w0
        std::vector<Index> places;
        for (Index i = 0; i < shared(); ++i)
            places.push_back(i);
        places.insert(places.end(), {plateauAt(r), plateauAt(r) + 1});
        const EarlyRecord &record = m_records[r];
        const Eigen::VectorXd residual
            = record.weight * whitened(record.y, record.whitening) - response(theta, r);
        Eigen::MatrixXd J(residual.size(), std::ssize(places));
        for (Index c = 0; c < J.cols(); ++c) {
            const Index at = places[static_cast<std::size_t>(c)];
            const double step = at == plateauAt(r) ? kStep * std::abs(theta[at]) : kStep;
            Eigen::VectorXd moved = theta;
            moved[at] += step;
            J.col(c) = response(moved, r);
            moved[at] -= 2.0 * step;
            J.col(c) = (J.col(c) - response(moved, r)).eval() / (2.0 * step);
        }
        sum.matrix(places, places) += J.transpose() * J;
        sum.gradient(places) += J.transpose() * residual;
        sum.cost += residual.squaredNorm();
    }
};

bool isSensible(const FrontProblem &problem, const Eigen::VectorXd &theta)
{
    constexpr double kFarthest = 2.3; // ln 10 from the start, in frequency
    constexpr double kLeastDamping = 1e-4;
    constexpr double kMostDamping = 10.0;
    if (!theta.allFinite() || std::abs(theta[0]) > kFarthest)
        return false;
    const double zeta = std::exp(theta[1]);
    return zeta > kLeastDamping && zeta < kMostDamping
        && (problem.shared() < 3 || std::abs(theta[2]) < 2.0 * kFarthest);
}

} // namespace

double whitenedSquares(const EarlyRecord &record, const Eigen::VectorXd &residual)
{
    return (record.weight * whitened(residual, record.whitening)).squaredNorm();
}

std::optional<FrontFit> fitFront(const std::vector<EarlyRecord> &records,
    const SecondOrderStart &start, double start_s, bool isFree, const JobControl &control)
{
    const double unit_s = 1.0 / (2.0 * std::numbers::pi * start.f0_Hz);
    const FrontProblem problem(records, unit_s, start_s, isFree);
    Eigen::VectorXd theta(problem.parameters());
    theta.head(2) << 0.0, std::log(start.zeta);
    if (isFree)
        theta[2] = std::log(start_s / unit_s);
    for (std::size_t r = 0; r < records.size(); ++r)
        theta.segment(problem.plateauAt(r), 2) << start.plateau[r], start.onset_s[r] / unit_s;
    const auto last = descend(
        theta, {60, 1e-3}, [&](const Eigen::VectorXd &at) { return problem.equations(at); },
        [&](const Eigen::VectorXd &at) { return isSensible(problem, at); }, control);
    if (!last || !isSensible(problem, theta))
        return std::nullopt;
    FrontFit fit{std::exp(theta[0]) * start.f0_Hz, std::exp(theta[1]), problem.duration_s(theta),
        0.0, last->cost, problem.parameters()};
    if (isFree) {
        const Eigen::VectorXd unit = Eigen::VectorXd::Unit(theta.size(), 2);
        fit.u_duration_s = fit.duration_s * std::sqrt(last->matrix.ldlt().solve(unit)[2]);
    }
    return fit;
}

} // namespace dyncal
