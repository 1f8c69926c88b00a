// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/second_order/second_order_problem.h"

#include <numeric>
#include <utility>

namespace dyncal {
namespace {

using Complex = std::complex<double>;

/// Parameters of one record: plateau, onset, amplitude of the drift, modes.
Index ownParameters(const RefinementRecord &record, Index drifts)
{
    return 2 + drifts + 4 * std::ssize(record.nuisance);
}

/// `x` of SecondOrderStep::exponentials(), as the regression wants it.
std::vector<RegressionMode> modesOf(
    const SecondOrderStep &local, const Eigen::VectorXd &x, double dt)
{
    const Index first = local.drifts();
    const Index gains = first + 2 + 2 * std::ssize(local.modes);
    std::vector<RegressionMode> modes;
    const auto addReal = [&](Index at) {
        modes.push_back({x[at] * dt, x[gains + at], false, false});
    };
    const auto addPair = [&](Index at) {
        modes.push_back(
            {Complex(x[at], x[at + 1]) * dt, {x[gains + at], x[gains + at + 1]}, true, false});
    };
    if (local.drift)
        addReal(0);
    if (local.rings()) {
        addPair(first);
    } else {
        addReal(first);
        addReal(first + 1);
    }
    for (Index i = 0; i < std::ssize(local.modes); ++i)
        addPair(first + 2 + 2 * i);
    modes.push_back({0.0, local.plateau, false, true});
    return modes;
}

/// `x` of SecondOrderStep::exponentials(), without the tube's modes.
ExponentialSum sumOf(const SecondOrderStep &local, const Eigen::VectorXd &x)
{
    const Index poles = local.drifts() + 2;
    const auto s = x.segment(local.drifts(), 2);
    const auto gain = x.segment(poles + 2 * std::ssize(local.modes) + local.drifts(), 2);
    ExponentialSum sum;
    sum.constant = local.plateau;
    sum.poles_rad_s.resize(poles);
    sum.amplitudes.resize(poles);
    if (local.drift) {
        sum.poles_rad_s[0] = x[0];
        sum.amplitudes[0] = x[poles + 2 * std::ssize(local.modes)];
    }
    if (local.rings()) {
        sum.poles_rad_s.tail(2) << Complex(s[0], s[1]), Complex(s[0], -s[1]);
        sum.amplitudes.tail(2) << 0.5 * Complex(gain[0], gain[1]), 0.5 * Complex(gain[0], -gain[1]);
    } else {
        sum.poles_rad_s.tail(2) << s[0], s[1];
        sum.amplitudes.tail(2) << gain[0], gain[1];
    }
    return sum;
}

} // namespace

SecondOrderProblem::SecondOrderProblem(
    const std::vector<RefinementRecord> &records, double unit_s, double front_s, bool withDrift)
    : m_records(records)
    , m_unit_s(unit_s)
    , m_front_s(front_s)
    , m_drifts(withDrift ? 1 : 0)
{
    for (const RefinementRecord &record : records)
        m_regressions.emplace_back(record.y, record.used);
}

Index SecondOrderProblem::samples() const
{
    Index sum = 0;
    for (const ExponentialRegression &regression : m_regressions)
        sum += regression.count();
    return sum;
}

Index SecondOrderProblem::plateauAt(std::size_t record) const
{
    Index at = shared();
    for (std::size_t i = 0; i < record; ++i)
        at += ownParameters(m_records[i], m_drifts);
    return at;
}

std::vector<Index> SecondOrderProblem::places(std::size_t record) const
{
    const Index own = ownParameters(m_records[record], m_drifts);
    std::vector<Index> list(static_cast<std::size_t>(shared() + own));
    std::iota(list.begin(), list.begin() + shared(), Index(0));
    std::iota(list.begin() + shared(), list.end(), plateauAt(record));
    return list;
}

SecondOrderStep SecondOrderProblem::step(const Eigen::VectorXd &theta, std::size_t record) const
{
    SecondOrderStep step;
    step.front = m_front_s / m_unit_s;
    if (withDrift())
        step.drift.emplace();
    for (const NuisanceTerm &term : m_records[record].nuisance)
        step.modes.push_back({{}, {}, term.startsWithStep});
    step.setParameters(theta(places(record)));
    return step;
}

void SecondOrderProblem::setStep(
    const SecondOrderStep &step, std::size_t record, Eigen::VectorXd &theta) const
{
    theta(places(record)) = step.parameterValues();
}

RegressionEquations SecondOrderProblem::normalEquations(const Eigen::VectorXd &theta) const
{
    const Index count = parameters();
    RegressionEquations sum{Eigen::MatrixXd::Zero(count, count), Eigen::VectorXd::Zero(count), 0.0};
    for (std::size_t r = 0; r < m_records.size(); ++r) {
        const SecondOrderStep local = step(theta, r);
        const double dt = interval(r);
        const RegressionEquations own
            = m_regressions[r].equations(modesOf(local, local.exponentials(), dt), dt);
        const Eigen::MatrixXd J = local.derivatives();
        const std::vector<Index> at = places(r);
        const double weight = m_records[r].weight * m_records[r].weight;
        sum.matrix(at, at) += weight * (J.transpose() * own.matrix * J);
        sum.gradient(at) += weight * (J.transpose() * own.gradient);
        sum.cost += weight * own.cost;
    }
    return sum;
}

Refinement SecondOrderProblem::asExponentials(const Eigen::VectorXd &theta) const
{
    Refinement fit;
    fit.poleParameters = shared();
    fit.withConstant = true;
    Index offset = shared();
    for (std::size_t r = 0; r < m_records.size(); ++r) {
        const SecondOrderStep local = step(theta, r);
        ExponentialSum sum = sumOf(local, local.exponentials());
        sum.poles_rad_s /= m_unit_s;
        fit.poles_rad_s.assign(sum.poles_rad_s.begin(), sum.poles_rad_s.end());
        fit.records.push_back(std::move(sum));
        std::vector<NuisanceTerm> terms = m_records[r].nuisance;
        for (std::size_t i = 0; i < terms.size(); ++i) {
            terms[i].pole_rad_s = local.modes[i].pole / m_unit_s;
            terms[i].amplitude = local.modes[i].amplitude;
        }
        fit.nuisance.push_back(std::move(terms));
        fit.offsets.push_back(offset);
        offset += shared() + 1 + 4 * std::ssize(local.modes);
    }
    return fit;
}

Eigen::MatrixXd SecondOrderProblem::derivatives(
    const Eigen::VectorXd &theta, const Refinement &fit) const
{
    const Index poles = shared();
    const Index rows = fit.offsets.back() + poles + 1 + 4 * std::ssize(fit.nuisance.back());
    Eigen::MatrixXd J = Eigen::MatrixXd::Zero(rows, parameters());
    for (std::size_t r = 0; r < m_records.size(); ++r) {
        const Eigen::MatrixXd own = step(theta, r).derivatives();
        const std::vector<Index> at = places(r);
        const Index modes = std::ssize(fit.nuisance[r]);
        const Index gains = poles + 2 * modes;
        const auto put = [&](Index row, Index from, Index count, double unit) {
            J.middleRows(row, count)(Eigen::all, at) = own.middleRows(from, count) / unit;
        };
        put(0, 0, poles, m_unit_s);
        put(fit.offsets[r], gains, poles, 1.0);
        put(fit.offsets[r] + poles, own.rows() - 1, 1, 1.0);
        for (Index i = 0; i < modes; ++i) {
            const Index row = fit.offsets[r] + poles + 1 + 4 * i;
            put(row, poles + 2 * i, 2, m_unit_s);
            put(row + 2, gains + poles + 2 * i, 2, 1.0);
        }
    }
    return J;
}

} // namespace dyncal
