// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/input_draws.h"

#include "core/base/distributions.h"
#include "core/base/number_text.h"
#include "core/base/portable_math.h"

#include <Eigen/Eigenvalues>

#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <set>

namespace dyncal {
namespace {

constexpr Index kLeastTrials = 100;

/// Semidefinite where two inputs are one: a root by eigenvalues takes that, Cholesky's does not.
Eigen::MatrixXd rootOf(const Eigen::MatrixXd &matrix)
{
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(matrix);
    const Eigen::VectorXd roots = solver.eigenvalues().cwiseMax(0.0).cwiseSqrt();
    return solver.eigenvectors() * roots.asDiagonal() * solver.eigenvectors().transpose();
}

Eigen::MatrixXd matrixOf(const std::vector<UncertainInput> &inputs, const std::vector<Index> &at)
{
    const auto n = std::ssize(at);
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(n, n);
    for (Index i = 0; i < n; ++i)
        for (Index j = 0; j < n; ++j)
            for (const Correlation &one :
                inputs[static_cast<std::size_t>(at[static_cast<std::size_t>(i)])].correlated)
                if (one.quantity
                    == inputs[static_cast<std::size_t>(at[static_cast<std::size_t>(j)])].quantity)
                    matrix(i, j) = matrix(j, i) = one.coefficient;
    return matrix;
}

double normalProbability(double z)
{
    return studentSurvival(-z, std::numeric_limits<double>::infinity());
}

} // namespace

CorrelatedDraws::CorrelatedDraws(const std::vector<UncertainInput> &inputs)
{
    for (Index i = 0; i < std::ssize(inputs); ++i)
        if (!inputs[static_cast<std::size_t>(i)].correlated.empty())
            m_at.push_back(i);
    if (!m_at.empty())
        m_root = rootOf(matrixOf(inputs, m_at));
}

void CorrelatedDraws::apply(Eigen::VectorXd &p) const
{
    if (m_at.empty())
        return;
    const Eigen::VectorXd z = m_root * p(m_at).unaryExpr(&normalQuantile);
    p(m_at) = z.unaryExpr(&normalProbability);
}

Index streamOf(const std::string &name)
{
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (const char letter : name)
        hash = (hash ^ static_cast<unsigned char>(letter)) * 0x100000001b3u;
    return static_cast<Index>(hash >> 1);
}

double unitDraw(const UncertainInput &input, double p)
{
    switch (input.distribution) {
    case Distribution::Rectangular:
        return std::sqrt(3.0) * (2.0 * p - 1.0);
    case Distribution::Triangular:
        return std::sqrt(6.0)
            * (p < 0.5 ? std::sqrt(2.0 * p) - 1.0 : 1.0 - std::sqrt(2.0 * (1.0 - p)));
    case Distribution::UShaped: // arcsine
        return -std::sqrt(2.0) * portableSineCosine(std::numbers::pi * p).cosine;
    case Distribution::Normal:
        break;
    }
    return studentQuantile(p, input.dof);
}

double drawnValue(const UncertainInput &input, double p)
{
    return input.u > 0.0 ? input.value + input.u * unitDraw(input, p) : input.value;
}

Result<void> checkInputs(const std::vector<UncertainInput> &inputs)
{
    std::set<std::string> names;
    for (const UncertainInput &input : inputs) {
        const bool isUncertain = input.u >= 0.0 && std::isfinite(input.u) && input.dof > 0.0;
        if (!std::isfinite(input.value) || !isUncertain)
            return fail(ErrorKind::Usage,
                Message{
                    DYNCAL_TEXT("core",
                        "The quantity %1 = %2 has a standard uncertainty of %3 with %4 degrees of freedom; the first two must be finite, the uncertainty 0 or above, the degrees above 0."),
                    {input.quantity, numberText(input.value), numberText(input.u),
                        numberText(input.dof)}});
        if (!names.insert(input.quantity).second)
            return fail(ErrorKind::Usage,
                Message{
                    DYNCAL_TEXT("core",
                        "The quantity %1 is there twice in an uncertainty budget; join the two contributions to one."),
                    {input.quantity}});
    }
    return {};
}

Result<void> checkMonteCarlo(const MonteCarloSettings &settings)
{
    if (settings.trials != 0 && (settings.trials < kLeastTrials || settings.trials > kMostTrials))
        return fail(ErrorKind::Usage,
            Message{
                DYNCAL_TEXT("core",
                    "Monte Carlo with %1 trials; it must be 0 (adaptive) or between %2 and %3."),
                {std::to_string(settings.trials), std::to_string(kLeastTrials),
                    std::to_string(kMostTrials)}});
    if (!(settings.coverage > 0.0 && settings.coverage < 1.0))
        return fail(ErrorKind::Usage,
            Message{
                DYNCAL_TEXT("core", "The coverage probability is %1; it must lie between 0 and 1."),
                {numberText(settings.coverage)}});
    return {};
}

double numericalTolerance(double u, int digits)
{
    return 0.5 * std::pow(10.0, std::floor(std::log10(u)) - (digits - 1));
}

} // namespace dyncal
