// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/consistency/fault_isolation.h"

#include "core/base/distributions.h"
#include "core/consistency/faults.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace dyncal {
namespace {

constexpr double kLeastChance = 1e-3;
constexpr double kShareLeft = 0.02;

/// Least squares over the sizes of one fault.
class Isolation
{
public:
    Isolation(const ComparedShots &shots, const Fault &fault)
        : m_shots(shots)
        , m_fault(fault)
        , m_solver(shots.covariance())
    {
    }

    std::optional<ExplainedBy> find()
    {
        const Index count = m_fault.perShot ? std::ssize(m_shots.ways()) : 1;
        Eigen::VectorXd size = Eigen::VectorXd::Zero(count);
        Eigen::VectorXd left = differencesAt(size);
        if (left.size() == 0)
            return std::nullopt;
        double chiSquare = squares(left);
        Eigen::MatrixXd J;
        for (int i = 0; i < 40; ++i) {
            auto slope = jacobian(size, left);
            if (!slope)
                break;
            J = std::move(*slope);
            if (!step(J, size, left, chiSquare))
                break;
        }
        if (J.size() == 0 || size.cwiseAbs().maxCoeff() > m_fault.largest)
            return std::nullopt;
        return explained(J, size, chiSquare);
    }

private:
    Eigen::VectorXd differencesAt(const Eigen::VectorXd &size) const
    {
        std::vector<CheckPoint> points;
        for (std::size_t i = 0; i < m_shots.ways().size(); ++i) {
            const ShotWays &ways = *m_shots.ways()[i];
            points.push_back(ways.nominal());
            const double s = size[m_fault.perShot ? static_cast<Index>(i) : 0];
            if (!m_fault.takeBack(ways.evidence(), s, points.back()))
                return {};
        }
        return m_shots.differencesAt(points);
    }

    double squares(const Eigen::VectorXd &d) const { return d.dot(m_solver.solve(d)); }

    std::optional<Eigen::MatrixXd> jacobian(
        const Eigen::VectorXd &size, const Eigen::VectorXd &at) const
    {
        const double h = 1e-3 * m_fault.usual;
        Eigen::MatrixXd J(at.size(), size.size());
        for (Index k = 0; k < size.size(); ++k) {
            Eigen::VectorXd moved = size;
            moved[k] += h;
            Eigen::VectorXd there = differencesAt(moved);
            double width = h;
            if (there.size() == 0) { // at the end of its range
                moved[k] -= 2.0 * h;
                there = differencesAt(moved);
                width = -h;
            }
            if (there.size() == 0)
                return std::nullopt;
            J.col(k) = (there - at) / width;
        }
        return J;
    }

    /// A damped Gauss-Newton step; false where nothing is gained any more.
    bool step(const Eigen::MatrixXd &J, Eigen::VectorXd &size, Eigen::VectorXd &left,
        double &chiSquare) const
    {
        Eigen::MatrixXd normal = J.transpose() * m_solver.solve(J);
        normal.diagonal().array() += 1e-30;
        Eigen::VectorXd change = -normal.ldlt().solve(J.transpose() * m_solver.solve(left));
        const double longest = change.cwiseAbs().maxCoeff();
        if (!(longest > 0.0) || !std::isfinite(longest))
            return false;
        change *= std::min(1.0, m_fault.usual / longest);
        for (int half = 0; half < 12; ++half, change *= 0.5) {
            const Eigen::VectorXd there = differencesAt(size + change);
            if (there.size() == 0 || !there.allFinite())
                continue;
            const double smaller = squares(there);
            if (!(smaller < chiSquare))
                continue;
            const bool worthwhile = chiSquare - smaller > 1e-6 * chiSquare;
            size += change;
            left = there;
            chiSquare = smaller;
            return worthwhile;
        }
        return false;
    }

    ExplainedBy explained(
        const Eigen::MatrixXd &J, const Eigen::VectorXd &size, double chiSquare) const
    {
        ExplainedBy result{m_fault.cause, chiSquare, {}};
        const Eigen::VectorXd u = m_shots.covariance().diagonal().cwiseSqrt();
        for (Index row = 0; row < J.rows(); ++row)
            result.moves.push_back(
                (J.row(row).transpose().cwiseProduct(size)).cwiseAbs().maxCoeff() > 0.5 * u[row]);
        // A surprising size counts against it, so that the likeliest comes first.
        result.chiSquare += (size / m_fault.usual).squaredNorm();
        return result;
    }

    const ComparedShots &m_shots;
    const Fault &m_fault;
    Eigen::LDLT<Eigen::MatrixXd> m_solver;
};

double degreesLeft(const ComparedShots &shots, bool perShot)
{
    const Index used = perShot ? std::ssize(shots.ways()) : 1;
    return static_cast<double>(std::max<Index>(shots.differences().size() - used, 1));
}

/// Of all shots, each once.
std::vector<std::string> sideSensorsOf(const ComparedShots &shots)
{
    std::vector<std::string> sensors;
    for (const ShotWays *ways : shots.ways())
        for (const SideReading &reading : ways->evidence().readings)
            if (!reading.isDut && std::ranges::find(sensors, reading.channel) == sensors.end())
                sensors.push_back(reading.channel);
    return sensors;
}

/// Several places or sensors may give the same cause: the one that leaves least stands for it.
void keepBest(std::vector<ExplainedBy> &list)
{
    std::ranges::stable_sort(list, {}, &ExplainedBy::chiSquare);
    std::vector<ExplainedBy> best;
    for (ExplainedBy &candidate : list)
        if (std::ranges::find(best, candidate.cause, &ExplainedBy::cause) == best.end())
            best.push_back(std::move(candidate));
    list = std::move(best);
}

} // namespace

std::vector<ExplainedBy> explanations(const ComparedShots &shots)
{
    std::vector<ExplainedBy> likely, others;
    const Eigen::VectorXd &d = shots.differences();
    if (d.size() == 0)
        return likely;
    const double whole = shots.chiSquare();
    for (const Fault &fault : possibleFaults(sideSensorsOf(shots))) {
        auto found = Isolation(shots, fault).find();
        if (!found || found->chiSquare > 0.9 * whole)
            continue;
        const double chance
            = chiSquareSurvival(found->chiSquare, degreesLeft(shots, fault.perShot));
        const bool explains = chance > kLeastChance || found->chiSquare < kShareLeft * whole;
        (explains ? likely : others).push_back(std::move(*found));
    }
    keepBest(likely);
    keepBest(others);
    if (likely.empty() && !others.empty())
        likely.push_back(others.front());
    return likely;
}

} // namespace dyncal
