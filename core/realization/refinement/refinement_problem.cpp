// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/refinement/refinement_problem.h"

#include "core/base/parallel.h"
#include "core/realization/refinement/levenberg_marquardt.h"
#include "core/signal/window_bands.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace dyncal {

RefinementProblem::RefinementProblem(const std::vector<RefinementRecord> &records,
    const std::vector<std::complex<double>> &startPoles_rad_s, bool withConstant,
    bool realPolesAnywhere)
    : m_records(records)
    , m_withConstant(withConstant)
    , m_realPolesAnywhere(realPolesAnywhere)
{
    double fastest = 0.0;
    for (const std::complex<double> &pole : startPoles_rad_s)
        fastest = std::max(fastest, std::abs(pole));
    for (const RefinementRecord &record : records) {
        m_regressions.emplace_back(record.y, record.used);
        if (startPoles_rad_s.empty() && !record.nuisance.empty())
            fastest = std::max(fastest, std::abs(record.nuisance.front().pole_rad_s));
    }
    m_unit_s = fastest > 0.0 ? 1.0 / fastest : 0.0;
    for (const RefinementRecord &record : records)
        m_length
            = std::max(m_length, static_cast<double>(record.y.size()) / record.rate_Hz / m_unit_s);
    std::vector<double> start;
    for (std::size_t i = 0; i < startPoles_rad_s.size(); ++i) {
        m_isPair.push_back(isUpperOfPair(startPoles_rad_s, i));
        start.push_back(startPoles_rad_s[i].real() * m_unit_s);
        if (m_isPair.back()) {
            start.push_back(startPoles_rad_s[i].imag() * m_unit_s);
            ++i;
        }
    }
    m_start = Eigen::Map<const Eigen::VectorXd>(start.data(), std::ssize(start));
    Index at = 0;
    for (const bool pair : m_isPair) {
        if (!pair && m_withConstant && isRelaxing(m_start[at] * m_length))
            m_relaxing.push_back(at);
        at += pair ? 2 : 1;
    }
}

Eigen::VectorXd RefinementProblem::amplitudes(const Eigen::VectorXd &theta) const
{
    Eigen::VectorXd result = theta;
    for (std::size_t r = 0; r < m_records.size(); ++r) {
        const Index begin = offset(r);
        for (const Index i : m_relaxing) {
            result[begin + i] /= theta[i];
            result[begin + poles()] -= result[begin + i];
        }
    }
    return result;
}

Index RefinementProblem::offset(std::size_t record) const
{
    Index at = poles();
    for (std::size_t r = 0; r < record; ++r)
        at += perRecord() + 4 * std::ssize(m_records[r].nuisance);
    return at;
}

Index RefinementProblem::nuisanceOffset(std::size_t record, std::size_t term) const
{
    return offset(record) + perRecord() + 4 * static_cast<Index>(term);
}

Index RefinementProblem::samples() const
{
    Index samples = 0;
    for (const ExponentialRegression &regression : m_regressions)
        samples += regression.count();
    return samples;
}

bool RefinementProblem::isWorthAThread() const
{
    constexpr Index kWork = 250'000; // samples times poles: some 0.3 ms; a thread starts in 50 us
    return samples() * poles() > kWork;
}

/// `theta` with amplitudes().
std::vector<RegressionMode> RefinementProblem::modes(
    const Eigen::VectorXd &theta, std::size_t record) const
{
    const Index begin = offset(record);
    const double dt = step(record);
    std::vector<RegressionMode> modes;
    Index at = 0;
    for (const bool pair : m_isPair) {
        modes.push_back({{theta[at] * dt, pair ? theta[at + 1] * dt : 0.0},
            {theta[begin + at], pair ? theta[begin + at + 1] : 0.0}, pair, false});
        at += pair ? 2 : 1;
    }
    for (std::size_t i = 0; i < m_records[record].nuisance.size(); ++i) {
        const Index own = nuisanceOffset(record, i);
        modes.push_back({{theta[own] * dt, theta[own + 1] * dt}, {theta[own + 2], theta[own + 3]},
            true, false});
    }
    if (m_withConstant)
        modes.push_back({0.0, theta[begin + at], false, true});
    return modes;
}

/// Where the record's amplitudes lie, in the order of modes().
std::vector<Index> RefinementProblem::amplitudePlaces(std::size_t record) const
{
    std::vector<Index> places(static_cast<std::size_t>(poles()));
    std::iota(places.begin(), places.end(), offset(record));
    for (std::size_t i = 0; i < m_records[record].nuisance.size(); ++i) {
        places.push_back(nuisanceOffset(record, i) + 2);
        places.push_back(nuisanceOffset(record, i) + 3);
    }
    if (m_withConstant)
        places.push_back(offset(record) + poles());
    return places;
}

/// Where the parameters of the record's regression lie in the whole: poles, then amplitudes.
std::vector<Index> RefinementProblem::places(std::size_t record) const
{
    std::vector<Index> list(static_cast<std::size_t>(poles()));
    std::iota(list.begin(), list.end(), Index(0));
    for (std::size_t i = 0; i < m_records[record].nuisance.size(); ++i) {
        list.push_back(nuisanceOffset(record, i));
        list.push_back(nuisanceOffset(record, i) + 1);
    }
    const std::vector<Index> amplitudes = amplitudePlaces(record);
    list.insert(list.end(), amplitudes.begin(), amplitudes.end());
    return list;
}

/// The chain rule for c = slope / s and c0 = level - sum c, on the equations of one record.
void RefinementProblem::toSlopes(
    const Eigen::VectorXd &amplitudes, std::size_t record, RegressionEquations &local) const
{
    const Index count = local.gradient.size();
    const Index first = poles() + 2 * std::ssize(m_records[record].nuisance); // amplitude
    Eigen::MatrixXd derivatives = Eigen::MatrixXd::Identity(count, count);
    for (const Index i : m_relaxing) {
        const double rate = amplitudes[i];
        const double byRate = -amplitudes[offset(record) + i] / rate;
        derivatives(first + i, first + i) = 1.0 / rate;
        derivatives(first + i, i) = byRate;
        derivatives(count - 1, first + i) = -1.0 / rate;
        derivatives(count - 1, i) = -byRate;
    }
    local.matrix = derivatives.transpose() * local.matrix * derivatives;
    local.gradient = derivatives.transpose() * local.gradient;
}

RegressionEquations RefinementProblem::equations(const Eigen::VectorXd &theta) const
{
    const Index count = parameters();
    const Eigen::VectorXd at = amplitudes(theta);
    RegressionEquations sum{Eigen::MatrixXd::Zero(count, count), Eigen::VectorXd::Zero(count), 0.0};
    std::vector<RegressionEquations> ofRecord(m_records.size());
    forEachPart(std::ssize(ofRecord), isWorthAThread(), [&](Index part) {
        const auto r = static_cast<std::size_t>(part);
        ofRecord[r] = m_regressions[r].equations(modes(at, r), step(r));
        if (!m_relaxing.empty())
            toSlopes(at, r, ofRecord[r]);
    });
    for (std::size_t r = 0; r < m_records.size(); ++r) {
        const RegressionEquations &local = ofRecord[r];
        const double weight = m_records[r].weight * m_records[r].weight;
        const std::vector<Index> rows = places(r);
        sum.matrix(rows, rows) += weight * local.matrix;
        sum.gradient(rows) += weight * local.gradient;
        sum.cost += weight * local.cost;
    }
    return sum;
}

void RefinementProblem::solveAmplitudes(Eigen::VectorXd &theta) const
{
    for (std::size_t r = 0; r < m_records.size(); ++r)
        theta(amplitudePlaces(r)).setZero();
    const RegressionEquations equations = this->equations(theta);
    for (std::size_t r = 0; r < m_records.size(); ++r) {
        // One Gauss-Newton step in the amplitudes alone is exact.
        const std::vector<Index> at = amplitudePlaces(r);
        const Eigen::MatrixXd own = equations.matrix(at, at);
        const Eigen::VectorXd gradient = equations.gradient(at);
        const Eigen::VectorXd best = own.ldlt().solve(gradient);
        theta(at) = best;
    }
}

Eigen::VectorXd RefinementProblem::start() const
{
    Eigen::VectorXd theta = Eigen::VectorXd::Zero(parameters());
    theta.head(poles()) = m_start;
    for (std::size_t r = 0; r < m_records.size(); ++r) {
        for (std::size_t i = 0; i < m_records[r].nuisance.size(); ++i) {
            const std::complex<double> pole = m_records[r].nuisance[i].pole_rad_s;
            theta[nuisanceOffset(r, i)] = pole.real() * m_unit_s;
            theta[nuisanceOffset(r, i) + 1] = pole.imag() * m_unit_s;
        }
    }
    return theta;
}

void RefinementProblem::leaveZero(Eigen::VectorXd &theta) const
{
    constexpr double kLeast = 2e-3; // time constants over the record
    for (const Index i : m_relaxing)
        if (std::abs(theta[i]) * m_length < kLeast)
            theta[i] = std::copysign(kLeast / m_length, theta[i]);
}

/// Whether the pole at this place started and still is unsettled at the record's end.
bool RefinementProblem::isUnsettled(Index place, double rate) const
{
    const double timeConstants = rate * m_length;
    return std::ranges::find(m_relaxing, place) != m_relaxing.end()
        && (isNearlyRamp(timeConstants) || (timeConstants < 0.0 && isRelaxing(timeConstants)));
}

bool RefinementProblem::isNearStart(const Eigen::VectorXd &theta) const
{
    Index at = 0;
    for (const bool pair : m_isPair) {
        // What has not died out has no well-known rate; nearly a ramp, not even its sign.
        if (!pair && isUnsettled(at, theta[at])) {
            ++at;
            continue;
        }
        if (!(theta[at] < 0.0))
            return false;
        const double before
            = pair ? std::hypot(m_start[at], m_start[at + 1]) : std::abs(m_start[at]);
        const double now = pair ? std::hypot(theta[at], theta[at + 1]) : std::abs(theta[at]);
        if (!isSameOscillation(before, now) && (pair || !m_realPolesAnywhere))
            return false;
        at += pair ? 2 : 1;
    }
    for (std::size_t r = 0; r < m_records.size(); ++r) {
        for (std::size_t i = 0; i < m_records[r].nuisance.size(); ++i) {
            const double before = m_records[r].nuisance[i].pole_rad_s.imag() * m_unit_s;
            if (!isSameOscillation(before, theta[nuisanceOffset(r, i) + 1]))
                return false;
        }
    }
    return true;
}

std::vector<RefinementRecord> averaged(const std::vector<RefinementRecord> &records, Index factor)
{
    std::vector<RefinementRecord> result;
    for (const RefinementRecord &record : records) {
        const Index count = record.y.size() / factor;
        const auto columns = record.y.head(count * factor).reshaped(factor, count);
        RefinementRecord means{columns.colwise().mean().transpose(),
            record.rate_Hz / static_cast<double>(factor),
            record.weight * std::sqrt(static_cast<double>(factor)), record.nuisance, {}};
        for (const SampleRange &range : record.used) {
            const SampleRange whole{(range.begin + factor - 1) / factor, range.end / factor};
            if (whole.begin < whole.end)
                means.used.push_back(whole);
        }
        if (means.used.empty() && !record.used.empty())
            means.used.push_back({0, 0}); // no mean takes part; an empty list would mean all
        result.push_back(std::move(means));
    }
    return result;
}

} // namespace dyncal
