// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/refinement/pole_refinement.h"

#include "core/realization/refinement/levenberg_marquardt.h"
#include "core/realization/refinement/refinement_problem.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <limits>

namespace dyncal {
namespace {

using Problem = RefinementProblem;

/// `theta` with amplitudes.
ExponentialSum recordSum(const Problem &problem, const Eigen::VectorXd &theta,
    const std::vector<std::complex<double>> &poles, std::size_t record)
{
    const Index n = problem.poles();
    const Index offset = problem.offset(record);
    ExponentialSum sum;
    sum.poles_rad_s = Eigen::Map<const Eigen::VectorXcd>(poles.data(), n);
    sum.amplitudes.resize(n);
    Index at = 0;
    for (const bool pair : problem.isPair()) {
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
    sum.constant = problem.withConstant() ? theta[offset + n] : 0.0;
    return sum;
}

std::vector<NuisanceTerm> recordNuisance(
    const Problem &problem, const Eigen::VectorXd &theta, std::size_t record)
{
    std::vector<NuisanceTerm> terms = problem.records()[record].nuisance;
    for (std::size_t i = 0; i < terms.size(); ++i) {
        const Index own = problem.nuisanceOffset(record, i);
        terms[i].pole_rad_s = std::complex<double>(theta[own], theta[own + 1]) / problem.unit_s();
        terms[i].amplitude = {theta[own + 2], theta[own + 3]};
    }
    return terms;
}

/// 1 / unit of time for poles and slopes, 1 for everything else.
Eigen::VectorXd unitsOf(const Problem &problem)
{
    Eigen::VectorXd units = Eigen::VectorXd::Ones(problem.parameters());
    units.head(problem.poles()).setConstant(1.0 / problem.unit_s());
    for (std::size_t r = 0; r < problem.records().size(); ++r) {
        for (const Index i : problem.relaxing())
            units[problem.offset(r) + i] = 1.0 / problem.unit_s();
        for (std::size_t i = 0; i < problem.records()[r].nuisance.size(); ++i)
            units.segment(problem.nuisanceOffset(r, i), 2).setConstant(1.0 / problem.unit_s());
    }
    return units;
}

/// Whether the data determine all parameters: else a pivot is only rounding, and the variance from
/// it arbitrary.
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
    const Index freedom = problem.samples() - equations.gradient.size();
    return equations.cost / static_cast<double>(std::max<Index>(1, freedom));
}

/// Ends a descent when the next step is below a thousandth of the uncertainties, less than any
/// printed digit, or when it has left its start for good: with too high an order it would wander to
/// the last iteration.
class RefinementEnd
{
public:
    explicit RefinementEnd(const Problem &problem)
        : m_problem(problem)
    {
    }

    bool operator()(const Eigen::VectorXd &theta, const RegressionEquations &equations)
    {
        constexpr double kNothing = 1e-3; // standard uncertainties
        constexpr int kPatience = 25;
        m_outside = m_problem.isNearStart(theta) ? 0 : m_outside + 1;
        const double noise = std::sqrt(std::min(1.0, reducedChiSquare(m_problem, equations)));
        return m_outside > kPatience || distanceToGo(equations) < kNothing * noise;
    }

private:
    const Problem &m_problem;
    int m_outside = 0; ///< iterations in a row
};

/// Whether the remaining way is small against the uncertainties.
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

constexpr Index kWorthwhile = 3; ///< samples per mean

/// Number of samples to average so that no mode turns by more than 1.5 rad between two means, and
/// enough means remain.
Index samplesPerMean(const Problem &problem)
{
    constexpr double kRadians = 1.5;
    constexpr Index kMeans = 1000;
    double fewest = std::numeric_limits<double>::infinity();
    for (const RefinementRecord &record : problem.records()) {
        double fastest_rad_s = 1.0 / problem.unit_s();
        for (const NuisanceTerm &term : record.nuisance)
            fastest_rad_s = std::max(fastest_rad_s, std::abs(term.pole_rad_s));
        const Index whole = record.y.size() / kMeans;
        fewest = std::min(
            {fewest, kRadians * record.rate_Hz / fastest_rad_s, static_cast<double>(whole)});
    }
    return problem.records().empty() ? 0 : static_cast<Index>(fewest);
}

/// Descends from the poles of `theta` and returns the equations at its end, which is then in
/// `theta`; empty when stopped or when it leaves the neighbourhood of the start.
std::optional<RegressionEquations> descended(
    const Problem &problem, Eigen::VectorXd &theta, const JobControl &control)
{
    problem.leaveZero(theta);
    problem.solveAmplitudes(theta);
    auto equations = descend(
        theta, {60, 1e-4}, [&](const Eigen::VectorXd &at) { return problem.equations(at); },
        [](const Eigen::VectorXd &at) { return at.allFinite(); }, control, RefinementEnd(problem),
        [&](Eigen::VectorXd &next) { problem.leaveZero(next); });
    if (!theta.allFinite() || !problem.isNearStart(theta))
        return std::nullopt;
    return equations;
}

Refinement unpack(
    const Problem &problem, const Eigen::VectorXd &theta, const RegressionEquations &last)
{
    Refinement result;
    result.poleParameters = problem.poles();
    result.withConstant = problem.withConstant();
    result.relaxing = problem.relaxing();
    const Eigen::VectorXd amplitudes = problem.amplitudes(theta);
    Index at = 0;
    for (const bool pair : problem.isPair()) {
        const std::complex<double> s(
            theta[at] / problem.unit_s(), pair ? theta[at + 1] / problem.unit_s() : 0.0);
        result.poles_rad_s.push_back(s);
        if (pair)
            result.poles_rad_s.push_back(std::conj(s));
        at += pair ? 2 : 1;
    }
    for (std::size_t r = 0; r < problem.records().size(); ++r) {
        result.records.push_back(recordSum(problem, amplitudes, result.poles_rad_s, r));
        result.nuisance.push_back(recordNuisance(problem, theta, r));
        result.offsets.push_back(problem.offset(r));
    }
    const double chiSquare = reducedChiSquare(problem, last);
    result.residualToNoise = std::sqrt(chiSquare);
    result.covariance = covarianceOf(problem, last, chiSquare);
    return result;
}

} // namespace

std::optional<Refinement> refinePoles(const std::vector<RefinementRecord> &records,
    const std::vector<std::complex<double>> &startPoles_rad_s, bool withConstant,
    const JobControl &control, RealPoles realPoles)
{
    const bool anywhere = realPoles == RealPoles::Anywhere;
    const Problem problem(records, startPoles_rad_s, withConstant, anywhere);
    if (!(problem.unit_s() > 0.0))
        return std::nullopt;
    Eigen::VectorXd theta = problem.start();
    const Index factor = samplesPerMean(problem);
    if (factor >= kWorthwhile) {
        const std::vector<RefinementRecord> means = averaged(records, factor);
        if (!descended(Problem(means, startPoles_rad_s, withConstant, anywhere), theta, control))
            return std::nullopt;
    }
    const auto equations = descended(problem, theta, control);
    if (!equations || !isDetermined(equations->matrix) || !hasArrived(problem, *equations))
        return std::nullopt;
    return unpack(problem, theta, *equations);
}

} // namespace dyncal
