// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/pole_refinement.h"

#include "core/base/parallel.h"
#include "core/realization/exponential_regression.h"
#include "core/realization/levenberg_marquardt.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace dyncal {
namespace {

/// Layout of the parameter vector: poles first, then per record n amplitudes, maybe c0, and per
/// nuisance term Re and Im of rate and amplitude. Times are scaled by `unit_s`, so that all
/// parameters of the sensor are of order one.
struct Problem
{
    const std::vector<RefinementRecord> &records;
    std::vector<ExponentialRegression> regressions; ///< one per record
    std::vector<bool> isPair; ///< per mode: conjugate pair, or one real pole
    bool withConstant = false;
    double unit_s = 1.0;

    Index poles() const
    {
        Index n = 0;
        for (const bool pair : isPair)
            n += pair ? 2 : 1;
        return n;
    }
    Index perRecord() const { return poles() + (withConstant ? 1 : 0); }
    Index offset(std::size_t record) const
    {
        Index at = poles();
        for (std::size_t r = 0; r < record; ++r)
            at += perRecord() + 4 * std::ssize(records[r].nuisance);
        return at;
    }
    Index nuisanceOffset(std::size_t record, std::size_t term) const
    {
        return offset(record) + perRecord() + 4 * static_cast<Index>(term);
    }
    Index parameters() const { return offset(records.size()); }
    double step(std::size_t record) const { return 1.0 / records[record].rate_Hz / unit_s; }
    bool isWorthAThread() const
    {
        constexpr Index kMillisecond = 1'000'000; // samples times poles
        Index samples = 0;
        for (const ExponentialRegression &regression : regressions)
            samples += regression.count();
        return samples * poles() > kMillisecond;
    }
};

/// The modes of one record at `theta`: the sensor's, its nuisance terms, c0.
std::vector<RegressionMode> modesOf(
    const Problem &problem, const Eigen::VectorXd &theta, std::size_t record)
{
    const Index offset = problem.offset(record);
    const double dt = problem.step(record);
    std::vector<RegressionMode> modes;
    Index at = 0;
    for (const bool pair : problem.isPair) {
        modes.push_back({{theta[at] * dt, pair ? theta[at + 1] * dt : 0.0},
            {theta[offset + at], pair ? theta[offset + at + 1] : 0.0}, pair, false});
        at += pair ? 2 : 1;
    }
    for (std::size_t i = 0; i < problem.records[record].nuisance.size(); ++i) {
        const Index own = problem.nuisanceOffset(record, i);
        modes.push_back({{theta[own] * dt, theta[own + 1] * dt}, {theta[own + 2], theta[own + 3]},
            true, false});
    }
    if (problem.withConstant)
        modes.push_back({0.0, theta[offset + at], false, true});
    return modes;
}

/// Where the record's amplitudes lie, in the order of modesOf().
std::vector<Index> amplitudePlaces(const Problem &problem, std::size_t record)
{
    const Index n = problem.poles();
    const Index offset = problem.offset(record);
    std::vector<Index> places;
    for (Index i = 0; i < n; ++i)
        places.push_back(offset + i);
    for (std::size_t i = 0; i < problem.records[record].nuisance.size(); ++i) {
        places.push_back(problem.nuisanceOffset(record, i) + 2);
        places.push_back(problem.nuisanceOffset(record, i) + 3);
    }
    if (problem.withConstant)
        places.push_back(offset + n);
    return places;
}

/// Where the parameters of the record's regression lie in the whole: rates, then amplitudes.
std::vector<Index> places(const Problem &problem, std::size_t record)
{
    std::vector<Index> list(static_cast<std::size_t>(problem.poles()));
    std::iota(list.begin(), list.end(), Index(0));
    for (std::size_t i = 0; i < problem.records[record].nuisance.size(); ++i) {
        list.push_back(problem.nuisanceOffset(record, i));
        list.push_back(problem.nuisanceOffset(record, i) + 1);
    }
    const std::vector<Index> amplitudes = amplitudePlaces(problem, record);
    list.insert(list.end(), amplitudes.begin(), amplitudes.end());
    return list;
}

/// J^T J, J^T r and r^T r of all records, weighted.
RegressionEquations normalEquations(const Problem &problem, const Eigen::VectorXd &theta)
{
    const Index count = problem.parameters();
    RegressionEquations sum{Eigen::MatrixXd::Zero(count, count), Eigen::VectorXd::Zero(count), 0.0};
    std::vector<RegressionEquations> ofRecord(problem.records.size());
    forEachPart(std::ssize(ofRecord), problem.isWorthAThread(), [&](Index part) {
        const auto r = static_cast<std::size_t>(part);
        ofRecord[r] = problem.regressions[r].equations(modesOf(problem, theta, r), problem.step(r));
    });
    for (std::size_t r = 0; r < problem.records.size(); ++r) {
        const RegressionEquations &local = ofRecord[r];
        const double weight = problem.records[r].weight * problem.records[r].weight;
        const std::vector<Index> at = places(problem, r);
        sum.matrix(at, at) += weight * local.matrix;
        sum.gradient(at) += weight * local.gradient;
        sum.cost += weight * local.cost;
    }
    return sum;
}

/// Best amplitudes for fixed rates: one Gauss-Newton step in them alone is exact.
void solveAmplitudes(const Problem &problem, Eigen::VectorXd &theta)
{
    for (std::size_t r = 0; r < problem.records.size(); ++r)
        theta(amplitudePlaces(problem, r)).setZero();
    const RegressionEquations equations = normalEquations(problem, theta);
    for (std::size_t r = 0; r < problem.records.size(); ++r) {
        const std::vector<Index> at = amplitudePlaces(problem, r);
        const Eigen::MatrixXd own = equations.matrix(at, at);
        const Eigen::VectorXd gradient = equations.gradient(at);
        const Eigen::VectorXd best = own.ldlt().solve(gradient);
        theta(at) = best;
    }
}

/// Parameters at the realised poles, amplitudes still zero.
Eigen::VectorXd startOf(
    const Problem &problem, const std::vector<std::complex<double>> &start_rad_s)
{
    Eigen::VectorXd theta = Eigen::VectorXd::Zero(problem.parameters());
    Index at = 0;
    for (std::size_t i = 0; i < start_rad_s.size(); ++i) {
        theta[at++] = start_rad_s[i].real() * problem.unit_s;
        if (isUpperOfPair(start_rad_s, i)) {
            theta[at++] = start_rad_s[i].imag() * problem.unit_s;
            ++i;
        }
    }
    for (std::size_t r = 0; r < problem.records.size(); ++r) {
        for (std::size_t i = 0; i < problem.records[r].nuisance.size(); ++i) {
            const std::complex<double> rate = problem.records[r].nuisance[i].rate_rad_s;
            theta[problem.nuisanceOffset(r, i)] = rate.real() * problem.unit_s;
            theta[problem.nuisanceOffset(r, i) + 1] = rate.imag() * problem.unit_s;
        }
    }
    return theta;
}

bool staysNearStart(
    const Problem &problem, const Eigen::VectorXd &theta, const Eigen::VectorXd &start)
{
    Index at = 0;
    for (const bool pair : problem.isPair) {
        if (!(theta[at] < 0.0))
            return false;
        const double before = pair ? std::hypot(start[at], start[at + 1]) : std::abs(start[at]);
        const double now = pair ? std::hypot(theta[at], theta[at + 1]) : std::abs(theta[at]);
        if (!isSameOscillation(before, now))
            return false;
        at += pair ? 2 : 1;
    }
    for (std::size_t r = 0; r < problem.records.size(); ++r) {
        for (std::size_t i = 0; i < problem.records[r].nuisance.size(); ++i) {
            const Index own = problem.nuisanceOffset(r, i) + 1;
            if (!isSameOscillation(start[own], theta[own]))
                return false;
        }
    }
    return true;
}

ExponentialSum recordSum(const Problem &problem, const Eigen::VectorXd &theta,
    const std::vector<std::complex<double>> &rates, std::size_t record)
{
    const Index n = problem.poles();
    const Index offset = problem.offset(record);
    ExponentialSum sum;
    sum.rates_rad_s = Eigen::Map<const Eigen::VectorXcd>(rates.data(), n);
    sum.amplitudes.resize(n);
    Index at = 0;
    for (const bool pair : problem.isPair) {
        if (pair) {
            const std::complex<double> c(theta[offset + at] / 2.0, theta[offset + at + 1] / 2.0);
            sum.amplitudes[at] = c;
            sum.amplitudes[at + 1] = std::conj(c);
            at += 2;
        } else {
            sum.amplitudes[at] = theta[offset + at];
            ++at;
        }
    }
    sum.constant = problem.withConstant ? theta[offset + n] : 0.0;
    return sum;
}

std::vector<NuisanceTerm> recordNuisance(
    const Problem &problem, const Eigen::VectorXd &theta, std::size_t record)
{
    std::vector<NuisanceTerm> terms = problem.records[record].nuisance;
    for (std::size_t i = 0; i < terms.size(); ++i) {
        const Index own = problem.nuisanceOffset(record, i);
        terms[i].rate_rad_s = std::complex<double>(theta[own], theta[own + 1]) / problem.unit_s;
        terms[i].amplitude = {theta[own + 2], theta[own + 3]};
    }
    return terms;
}

/// 1 / unit of time for rates, 1 for everything else.
Eigen::VectorXd unitsOf(const Problem &problem)
{
    Eigen::VectorXd units = Eigen::VectorXd::Ones(problem.parameters());
    units.head(problem.poles()).setConstant(1.0 / problem.unit_s);
    for (std::size_t r = 0; r < problem.records.size(); ++r) {
        for (std::size_t i = 0; i < problem.records[r].nuisance.size(); ++i)
            units.segment(problem.nuisanceOffset(r, i), 2).setConstant(1.0 / problem.unit_s);
    }
    return units;
}

/// Whether the data tell all parameters apart: else a pivot is rounding, and its variance anything,
/// zero too.
bool isDetermined(const Eigen::MatrixXd &matrix)
{
    const Eigen::VectorXd scale = matrix.diagonal().cwiseSqrt().cwiseInverse();
    const Eigen::MatrixXd scaled = scale.asDiagonal() * matrix * scale.asDiagonal();
    const double rounding
        = std::numeric_limits<double>::epsilon() * static_cast<double>(matrix.rows());
    return scaled.allFinite() && scaled.ldlt().vectorD().minCoeff() > rounding;
}

double reducedChiSquare(const Problem &problem, const RegressionEquations &equations)
{
    Index samples = 0;
    for (const ExponentialRegression &regression : problem.regressions)
        samples += regression.count();
    return equations.cost
        / static_cast<double>(std::max<Index>(1, samples - equations.gradient.size()));
}

/// Ends a descent at a thousandth of the uncertainties, below every digit that is printed, and one
/// that does not come back to where it started: a model of too high an order wanders to the last
/// iteration.
class RefinementEnd
{
public:
    RefinementEnd(const Problem &problem, const Eigen::VectorXd &start)
        : m_problem(problem)
        , m_start(start)
    {
    }

    bool operator()(const Eigen::VectorXd &theta, const RegressionEquations &equations)
    {
        constexpr double kNothing = 1e-3; // standard uncertainties
        constexpr int kPatience = 25;
        m_outside = staysNearStart(m_problem, theta, m_start) ? 0 : m_outside + 1;
        const double noise = std::sqrt(std::min(1.0, reducedChiSquare(m_problem, equations)));
        return m_outside > kPatience || distanceToGo(equations) < kNothing * noise;
    }

private:
    const Problem &m_problem;
    const Eigen::VectorXd &m_start;
    int m_outside = 0; ///< iterations in a row
};

/// Whether nothing is left to gain that the uncertainties would show.
bool hasArrived(const Problem &problem, const RegressionEquations &last)
{
    constexpr double kUnseen = 0.1; // standard uncertainties
    const double unit = std::sqrt(std::max(1.0, reducedChiSquare(problem, last)));
    return distanceToGo(last) < kUnseen * unit;
}

Eigen::MatrixXd covarianceOf(
    const Problem &problem, const RegressionEquations &last, double chiSquare)
{
    const Index count = problem.parameters();
    const Eigen::VectorXd units = unitsOf(problem);
    const Eigen::MatrixXd inverse
        = last.matrix.ldlt().solve(Eigen::MatrixXd::Identity(count, count));
    return std::max(1.0, chiSquare) * (units.asDiagonal() * inverse * units.asDiagonal());
}

Refinement unpack(
    const Problem &problem, const Eigen::VectorXd &theta, const RegressionEquations &last)
{
    Refinement result;
    result.poleParameters = problem.poles();
    result.withConstant = problem.withConstant;
    Index at = 0;
    for (const bool pair : problem.isPair) {
        const std::complex<double> s(
            theta[at] / problem.unit_s, pair ? theta[at + 1] / problem.unit_s : 0.0);
        result.rates_rad_s.push_back(s);
        if (pair)
            result.rates_rad_s.push_back(std::conj(s));
        at += pair ? 2 : 1;
    }
    for (std::size_t r = 0; r < problem.records.size(); ++r) {
        result.records.push_back(recordSum(problem, theta, result.rates_rad_s, r));
        result.nuisance.push_back(recordNuisance(problem, theta, r));
        result.offsets.push_back(problem.offset(r));
    }
    const double chiSquare = reducedChiSquare(problem, last);
    result.residualToNoise = std::sqrt(chiSquare);
    result.covariance = covarianceOf(problem, last, chiSquare);
    return result;
}

} // namespace

ExponentialSum perturbed(const Refinement &refinement, Index record, Index index, double delta)
{
    ExponentialSum sum = refinement.records[static_cast<std::size_t>(record)];
    const Index n = refinement.poleParameters;
    if (index == 2 * n) {
        sum.constant += delta;
        return sum;
    }
    const bool movesPole = index < n;
    const Index i = movesPole ? index : index - n;
    Eigen::VectorXcd &values = movesPole ? sum.rates_rad_s : sum.amplitudes;
    const double share = movesPole ? delta : delta / 2.0; // amplitudes are fitted as 2 Re, 2 Im
    const std::vector<std::complex<double>> &rates = refinement.rates_rad_s;
    if (isUpperOfPair(rates, static_cast<std::size_t>(i))) {
        values[i] += share;
        values[i + 1] += share;
    } else if (i > 0 && isUpperOfPair(rates, static_cast<std::size_t>(i - 1))) {
        values[i - 1] += std::complex<double>(0.0, share);
        values[i] -= std::complex<double>(0.0, share);
    } else {
        values[i] += delta;
    }
    return sum;
}

Eigen::MatrixXd recordCovariance(const Refinement &refinement, Index record)
{
    const Index n = refinement.poleParameters;
    const Index m = n + (refinement.withConstant ? 1 : 0);
    const Index offset = refinement.offsets[static_cast<std::size_t>(record)];
    Eigen::MatrixXd covariance(n + m, n + m);
    covariance.topLeftCorner(n, n) = refinement.covariance.topLeftCorner(n, n);
    covariance.topRightCorner(n, m) = refinement.covariance.block(0, offset, n, m);
    covariance.bottomLeftCorner(m, n) = refinement.covariance.block(offset, 0, m, n);
    covariance.bottomRightCorner(m, m) = refinement.covariance.block(offset, offset, m, m);
    return covariance;
}

Eigen::Matrix4d nuisanceCovariance(const Refinement &refinement, Index record, Index term)
{
    const Index own = refinement.poleParameters + (refinement.withConstant ? 1 : 0);
    const Index at = refinement.offsets[static_cast<std::size_t>(record)] + own + 4 * term;
    return refinement.covariance.block<4, 4>(at, at);
}

std::optional<Refinement> refinePoles(const std::vector<RefinementRecord> &records,
    const std::vector<std::complex<double>> &start_rad_s, bool withConstant,
    const JobControl &control)
{
    Problem problem{records, {}, {}, withConstant, 1.0};
    double fastest = 0.0;
    for (std::size_t i = 0; i < start_rad_s.size(); ++i) {
        problem.isPair.push_back(isUpperOfPair(start_rad_s, i));
        fastest = std::max(fastest, std::abs(start_rad_s[i]));
        if (problem.isPair.back())
            ++i;
    }
    for (const RefinementRecord &record : records) {
        problem.regressions.emplace_back(record.y, record.used);
        if (start_rad_s.empty() && !record.nuisance.empty())
            fastest = std::max(fastest, std::abs(record.nuisance.front().rate_rad_s));
    }
    if (!(fastest > 0.0))
        return std::nullopt;
    problem.unit_s = 1.0 / fastest;

    const Eigen::VectorXd start = startOf(problem, start_rad_s);
    Eigen::VectorXd theta = start;
    solveAmplitudes(problem, theta);
    const auto equations = descend(
        theta, {60, 1e-4}, [&](const Eigen::VectorXd &at) { return normalEquations(problem, at); },
        [](const Eigen::VectorXd &at) { return at.allFinite(); }, control,
        RefinementEnd(problem, start));
    if (!equations || !theta.allFinite() || !staysNearStart(problem, theta, start)
        || !isDetermined(equations->matrix) || !hasArrived(problem, *equations))
        return std::nullopt;
    return unpack(problem, theta, *equations);
}

} // namespace dyncal
