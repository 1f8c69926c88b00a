// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/pole_refinement.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

constexpr int kIterations = 60;
constexpr double kConverged = 1e-12; ///< relative decrease of the cost
constexpr double kFrequencyFactor = 1.5;

/// Layout of the parameter vector: poles first, then per record n amplitudes and maybe c0.
/// Times are scaled by `unit_s`, so that all parameters are of order one.
struct Problem
{
    const std::vector<RefinementRecord> &records;
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
};

/// Model and its derivatives at one time, for one record.
class Row
{
public:
    explicit Row(const Problem &problem)
        : m_problem(problem)
        , pole(problem.poles())
        , linear(problem.perRecord())
    {
    }

    /// Value at scaled time t; fills the derivatives.
    double evaluate(double t, const Eigen::VectorXd &theta, Index offset)
    {
        double value = 0.0;
        Index at = 0;
        for (const bool pair : m_problem.isPair) {
            const double envelope = std::exp(theta[at] * t);
            if (pair) {
                const double c = envelope * std::cos(theta[at + 1] * t);
                const double s = -envelope * std::sin(theta[at + 1] * t);
                const double a = theta[offset + at];
                const double b = theta[offset + at + 1];
                linear[at] = c;
                linear[at + 1] = s;
                pole[at] = t * (a * c + b * s);
                pole[at + 1] = t * (a * s - b * c);
                value += a * c + b * s;
                at += 2;
            } else {
                linear[at] = envelope;
                pole[at] = t * envelope * theta[offset + at];
                value += envelope * theta[offset + at];
                ++at;
            }
        }
        if (m_problem.withConstant) {
            linear[at] = 1.0;
            value += theta[offset + at];
        }
        return value;
    }

private:
    const Problem &m_problem;

public:
    Eigen::VectorXd pole;
    Eigen::VectorXd linear;
};

struct NormalEquations
{
    Eigen::MatrixXd matrix;
    Eigen::VectorXd gradient;
    double cost = 0.0;
    Index samples = 0;
};

/// J^T J and J^T r, summed sample by sample; the Jacobian is never stored.
NormalEquations normalEquations(const Problem &problem, const Eigen::VectorXd &theta)
{
    const Index n = problem.poles();
    const Index m = problem.perRecord();
    NormalEquations sum{Eigen::MatrixXd::Zero(problem.parameters(), problem.parameters()),
        Eigen::VectorXd::Zero(problem.parameters())};
    Row row(problem);
    Eigen::VectorXd both(n + m);
    for (std::size_t r = 0; r < problem.records.size(); ++r) {
        const RefinementRecord &record = problem.records[r];
        const Index offset = n + m * static_cast<Index>(r);
        const double dt = 1.0 / record.rate_Hz / problem.unit_s;
        Eigen::MatrixXd local = Eigen::MatrixXd::Zero(n + m, n + m);
        Eigen::VectorXd localGradient = Eigen::VectorXd::Zero(n + m);
        for (Index k = 0; k < record.y.size(); ++k) {
            const double model = row.evaluate(static_cast<double>(k) * dt, theta, offset);
            const double residual = record.weight * (record.y[k] - model);
            both << row.pole, row.linear;
            both *= record.weight;
            local.selfadjointView<Eigen::Lower>().rankUpdate(both);
            localGradient += residual * both;
            sum.cost += residual * residual;
        }
        const Eigen::MatrixXd full = local.selfadjointView<Eigen::Lower>();
        sum.matrix.topLeftCorner(n, n) += full.topLeftCorner(n, n);
        sum.matrix.block(offset, offset, m, m) = full.bottomRightCorner(m, m);
        sum.matrix.block(offset, 0, m, n) = full.bottomLeftCorner(m, n);
        sum.matrix.block(0, offset, n, m) = full.topRightCorner(n, m);
        sum.gradient.head(n) += localGradient.head(n);
        sum.gradient.segment(offset, m) = localGradient.tail(m);
        sum.samples += record.y.size();
    }
    return sum;
}

double costOf(const Problem &problem, const Eigen::VectorXd &theta)
{
    const Index n = problem.poles();
    const Index m = problem.perRecord();
    Row row(problem);
    double cost = 0.0;
    for (std::size_t r = 0; r < problem.records.size(); ++r) {
        const RefinementRecord &record = problem.records[r];
        const double dt = 1.0 / record.rate_Hz / problem.unit_s;
        for (Index k = 0; k < record.y.size(); ++k) {
            const double model
                = row.evaluate(static_cast<double>(k) * dt, theta, n + m * static_cast<Index>(r));
            const double residual = record.weight * (record.y[k] - model);
            cost += residual * residual;
        }
    }
    return cost;
}

/// Best amplitudes for fixed poles: one Gauss-Newton step in them alone is exact.
void solveAmplitudes(const Problem &problem, Eigen::VectorXd &theta)
{
    const Index n = problem.poles();
    theta.tail(theta.size() - n).setZero();
    const NormalEquations equations = normalEquations(problem, theta);
    const Index m = theta.size() - n;
    theta.tail(m)
        = equations.matrix.bottomRightCorner(m, m).ldlt().solve(equations.gradient.tail(m));
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

Refinement unpack(const Problem &problem, const Eigen::VectorXd &theta, const NormalEquations &last)
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
    const double freedom = static_cast<double>(std::max<Index>(1, last.samples - theta.size()));
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
    Problem problem{records, {}, withConstant, 1.0};
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

    Eigen::VectorXd theta = Eigen::VectorXd::Zero(problem.parameters());
    Index at = 0;
    for (std::size_t i = 0; i < start_rad_s.size(); ++i) {
        theta[at++] = start_rad_s[i].real() * problem.unit_s;
        if (isUpperOfPair(start_rad_s, i)) {
            theta[at++] = start_rad_s[i].imag() * problem.unit_s;
            ++i;
        }
    }
    const Eigen::VectorXd start = theta;
    solveAmplitudes(problem, theta);

    NormalEquations equations = normalEquations(problem, theta);
    double damping = 1e-4;
    for (int iteration = 0; iteration < kIterations; ++iteration) {
        if (control.stopRequested())
            return std::nullopt;
        Eigen::MatrixXd damped = equations.matrix;
        damped.diagonal() *= 1.0 + damping;
        const Eigen::VectorXd next = theta + damped.ldlt().solve(equations.gradient);
        const double cost = next.allFinite() ? costOf(problem, next) : equations.cost;
        if (!(cost < equations.cost)) {
            damping *= 10.0;
            if (damping > 1e8)
                break;
            continue;
        }
        const double decrease = (equations.cost - cost) / equations.cost;
        theta = next;
        equations = normalEquations(problem, theta);
        damping = std::max(1e-12, damping / 10.0);
        if (decrease < kConverged)
            break;
    }
    if (!theta.allFinite() || !staysNearStart(problem, theta, start))
        return std::nullopt;
    return unpack(problem, theta, equations);
}

} // namespace dyncal
