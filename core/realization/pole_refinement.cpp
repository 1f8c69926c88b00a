// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/pole_refinement.h"

#include "core/realization/exponential_regression.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

constexpr int kIterations = 60;
constexpr double kConverged = 1e-12; ///< relative decrease of the cost
constexpr double kFrequencyFactor = 1.5;
constexpr double kLargestDamping = 1e8;

/// Layout of the parameter vector: poles first, then per record n amplitudes and maybe c0.
/// Times are scaled by `unit_s`, so that all parameters are of order one.
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
    Index parameters() const { return poles() + perRecord() * static_cast<Index>(records.size()); }
    Index offset(std::size_t record) const
    {
        return poles() + perRecord() * static_cast<Index>(record);
    }
    double step(std::size_t record) const { return 1.0 / records[record].rate_Hz / unit_s; }
};

/// The modes of one record at `theta`.
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
    if (problem.withConstant)
        modes.push_back({0.0, theta[offset + at], false, true});
    return modes;
}

/// J^T J, J^T r and r^T r of all records, weighted.
RegressionEquations normalEquations(const Problem &problem, const Eigen::VectorXd &theta)
{
    const Index n = problem.poles();
    const Index m = problem.perRecord();
    RegressionEquations sum{Eigen::MatrixXd::Zero(problem.parameters(), problem.parameters()),
        Eigen::VectorXd::Zero(problem.parameters()), 0.0};
    for (std::size_t r = 0; r < problem.records.size(); ++r) {
        const RegressionEquations local
            = problem.regressions[r].equations(modesOf(problem, theta, r), problem.step(r));
        const double weight = problem.records[r].weight * problem.records[r].weight;
        const Index offset = problem.offset(r);
        sum.matrix.topLeftCorner(n, n) += weight * local.matrix.topLeftCorner(n, n);
        sum.matrix.block(offset, offset, m, m) = weight * local.matrix.bottomRightCorner(m, m);
        sum.matrix.block(offset, 0, m, n) = weight * local.matrix.bottomLeftCorner(m, n);
        sum.matrix.block(0, offset, n, m) = weight * local.matrix.topRightCorner(n, m);
        sum.gradient.head(n) += weight * local.gradient.head(n);
        sum.gradient.segment(offset, m) = weight * local.gradient.tail(m);
        sum.cost += weight * local.cost;
    }
    return sum;
}

/// Best amplitudes for fixed poles: one Gauss-Newton step in them alone is exact.
void solveAmplitudes(const Problem &problem, Eigen::VectorXd &theta)
{
    const Index n = problem.poles();
    theta.tail(theta.size() - n).setZero();
    const RegressionEquations equations = normalEquations(problem, theta);
    const Index m = theta.size() - n;
    theta.tail(m)
        = equations.matrix.bottomRightCorner(m, m).ldlt().solve(equations.gradient.tail(m));
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
        if (!(now < kFrequencyFactor * before && now > before / kFrequencyFactor))
            return false;
        at += pair ? 2 : 1;
    }
    return true;
}

ExponentialSum recordSum(const Problem &problem, const Eigen::VectorXd &theta,
    const std::vector<std::complex<double>> &rates, Index record)
{
    const Index n = problem.poles();
    const Index offset = n + problem.perRecord() * record;
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
    for (std::size_t r = 0; r < problem.records.size(); ++r)
        result.records.push_back(
            recordSum(problem, theta, result.rates_rad_s, static_cast<Index>(r)));
    Index samples = 0;
    for (const RefinementRecord &record : problem.records)
        samples += record.y.size();
    const double freedom = static_cast<double>(std::max<Index>(1, samples - theta.size()));
    const double chiSquare = last.cost / freedom;
    result.residualToNoise = std::sqrt(chiSquare);
    result.covariance
        = last.matrix.ldlt().solve(Eigen::MatrixXd::Identity(theta.size(), theta.size()));
    result.covariance *= std::max(1.0, chiSquare);
    result.covariance.topRows(result.poleParameters) /= problem.unit_s;
    result.covariance.leftCols(result.poleParameters) /= problem.unit_s;
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
    const Index offset = n + m * record;
    Eigen::MatrixXd covariance(n + m, n + m);
    covariance.topLeftCorner(n, n) = refinement.covariance.topLeftCorner(n, n);
    covariance.topRightCorner(n, m) = refinement.covariance.block(0, offset, n, m);
    covariance.bottomLeftCorner(m, n) = refinement.covariance.block(offset, 0, m, n);
    covariance.bottomRightCorner(m, m) = refinement.covariance.block(offset, offset, m, m);
    return covariance;
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
    if (problem.isPair.empty() || !(fastest > 0.0))
        return std::nullopt;
    problem.unit_s = 1.0 / fastest;
    for (const RefinementRecord &record : records)
        problem.regressions.emplace_back(record.y);

    const Eigen::VectorXd start = startOf(problem, start_rad_s);
    Eigen::VectorXd theta = start;
    solveAmplitudes(problem, theta);
    RegressionEquations equations = normalEquations(problem, theta);
    double damping = 1e-4;
    for (int iteration = 0; iteration < kIterations; ++iteration) {
        if (control.stopRequested())
            return std::nullopt;
        Eigen::MatrixXd damped = equations.matrix;
        damped.diagonal() *= 1.0 + damping;
        const Eigen::VectorXd next = theta + damped.ldlt().solve(equations.gradient);
        RegressionEquations tried = next.allFinite() ? normalEquations(problem, next) : equations;
        if (!(tried.cost < equations.cost)) {
            damping *= 10.0;
            if (damping > kLargestDamping)
                break;
            continue;
        }
        const double decrease = (equations.cost - tried.cost) / equations.cost;
        theta = next;
        equations = std::move(tried);
        damping = std::max(1e-12, damping / 10.0);
        if (decrease < kConverged)
            break;
    }
    if (!theta.allFinite() || !staysNearStart(problem, theta, start))
        return std::nullopt;
    return unpack(problem, theta, equations);
}

} // namespace dyncal
