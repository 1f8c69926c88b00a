// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/model_analysis/shot_sensitivity.h"

#include "core/base/distributions.h"
#include "core/base/number_text.h"
#include "core/base/propagation.h"
#include "core/model_analysis/shot_lines.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace dyncal {
namespace {

constexpr double kCoverage = 0.95;
constexpr double kSmallestChance = 1e-3;
constexpr double kLeastSpread = 0.05; ///< of the mean step: below, no trend can be seen
constexpr double kUnstated = 0.01; ///< u of a shot in the comparison where none is stated
constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr auto kOfStep = static_cast<Index>(StepResult::Step);

/// Relative parts of the shots' uncertainties: own ones, and of every common input one row.
struct Parts
{
    std::vector<std::vector<UncertaintyLine>> own; ///< per shot
    std::map<std::string, std::vector<UncertaintyLine>> common; ///< per input, per shot
};

bool isComplete(
    const std::vector<ShotSensitivity> &shots, const std::vector<const StepUncertainty *> &steps)
{
    for (std::size_t i = 0; i < shots.size(); ++i)
        if (!shots[i].u || !steps[i])
            return false;
    return true;
}

Parts partsOf(
    const std::vector<ShotSensitivity> &shots, const std::vector<const StepUncertainty *> &steps)
{
    Parts parts;
    parts.own.resize(shots.size());
    for (std::size_t i = 0; i < shots.size(); ++i) {
        if (!shots[i].u || !steps[i]) {
            parts.own[i].push_back(directLine("unstated", kUnstated));
            continue;
        }
        for (const UncertaintyLine &line : shotLines(shots[i], *steps[i])) {
            if (line.overShots == OverShots::Own) {
                parts.own[i].push_back(line);
                continue;
            }
            auto &row = parts.common[line.quantity];
            row.resize(shots.size());
            row[i] = line;
        }
    }
    return parts;
}

Eigen::VectorXd contributionsOf(const std::vector<UncertaintyLine> &row)
{
    Eigen::VectorXd c(std::ssize(row));
    for (Index i = 0; i < c.size(); ++i)
        c[i] = row[static_cast<std::size_t>(i)].contribution;
    return c;
}

Eigen::MatrixXd covarianceOf(const Parts &parts)
{
    // What converter and model leave out of a level, which no noise shows: shots are not told apart
    // by less.
    constexpr double kLeftOut = 5e-4;
    const auto n = static_cast<Index>(parts.own.size());
    Eigen::MatrixXd V = Eigen::MatrixXd::Zero(n, n);
    for (Index i = 0; i < n; ++i) {
        const double own = combined(parts.own[static_cast<std::size_t>(i)]).u;
        V(i, i) = own * own + kLeftOut * kLeftOut;
    }
    for (const auto &[quantity, row] : parts.common) {
        const Eigen::VectorXd c = contributionsOf(row);
        V += c * c.transpose();
        for (const Correlation &other : row.front().correlated)
            if (const auto found = parts.common.find(other.quantity); found != parts.common.end())
                V += other.coefficient * c * contributionsOf(found->second).transpose();
    }
    return V;
}

/// Generalised least squares of `r` on the columns of X.
struct GeneralisedFit
{
    Eigen::VectorXd value;
    Eigen::MatrixXd covariance;
    double chiSquare = 0.0;
};

GeneralisedFit fitted(const Eigen::MatrixXd &X, const Eigen::VectorXd &r, const Eigen::MatrixXd &V)
{
    const Eigen::LDLT<Eigen::MatrixXd> solver(V);
    const Eigen::MatrixXd weighted = solver.solve(X);
    GeneralisedFit fit;
    fit.covariance = (X.transpose() * weighted).inverse();
    fit.value = fit.covariance * (weighted.transpose() * r);
    const Eigen::VectorXd rest = r - X * fit.value;
    fit.chiSquare = std::max(0.0, rest.dot(solver.solve(rest)));
    return fit;
}

/// The scatter that takes the place of the shots' own parts, of one shot.
using Scatter = std::optional<CombinedUncertainty>;

/// A line of a mean over `n` shots of which it is one.
UncertaintyLine oneOf(UncertaintyLine line, double n)
{
    line.sensitivity /= n;
    line.contribution /= n;
    return line;
}

/// The common input of every shot as one line of their mean.
UncertaintyLine meanLine(
    const std::vector<UncertaintyLine> &row, const std::vector<std::size_t> &of)
{
    const auto n = static_cast<double>(of.size());
    UncertaintyLine line = row[of.front()];
    line.contribution = 0.0;
    for (const std::size_t i : of)
        line.contribution += row[i].contribution / n;
    // The shots may know it differently well; what is stated is the first one's u.
    line.sensitivity = line.u > 0.0 ? line.contribution / line.u : 0.0;
    return line;
}

SensitivityMean meanOf(const std::vector<ShotSensitivity> &shots,
    const std::vector<std::size_t> &of, const std::optional<Parts> &parts, const Scatter &scatter)
{
    const double n = static_cast<double>(of.size());
    double sum = 0.0;
    for (const std::size_t i : of)
        sum += *shots[i].sensitivity;
    SensitivityMean mean{ShotLevel::None, sum / n, {}, kUnknown, kUnknown};
    if (!parts)
        return mean;
    for (const auto &[quantity, row] : parts->common)
        mean.lines.push_back(meanLine(row, of));
    if (scatter) {
        mean.lines.push_back(with(OverShots::Scatter,
            directLine(kScatterOfShots, scatter->u / std::sqrt(n), scatter->dof)));
    } else {
        for (const std::size_t i : of)
            for (const UncertaintyLine &part : parts->own[i])
                mean.lines.push_back(oneOf(part, n));
    }
    const CombinedUncertainty u = combined(mean.lines);
    mean.u = std::abs(mean.value) * u.u;
    mean.dof = u.dof;
    mean.k = coverageFactor(u.dof, kCoverage);
    return mean;
}

/// Standard deviation about the mean of each group, pooled; empty without a degree of freedom.
Scatter scatterWithin(const Eigen::VectorXd &r, const std::vector<std::vector<std::size_t>> &groups)
{
    double squares = 0.0;
    double dof = 0.0;
    for (const std::vector<std::size_t> &group : groups) {
        double mean = 0.0;
        for (const std::size_t i : group)
            mean += r[static_cast<Index>(i)] / static_cast<double>(group.size());
        for (const std::size_t i : group)
            squares += std::pow(r[static_cast<Index>(i)] - mean, 2);
        dof += static_cast<double>(group.size()) - 1.0;
    }
    return dof > 0.0 ? Scatter({std::sqrt(squares / dof), dof}) : std::nullopt;
}

void addTrend(const std::vector<ShotSensitivity> &shots, const Eigen::VectorXd &r,
    const Eigen::MatrixXd &V, SensitivitySummary &summary)
{
    Eigen::VectorXd step(r.size());
    for (Index i = 0; i < r.size(); ++i)
        step[i] = *shots[static_cast<std::size_t>(i)].step_Pa;
    if (step.maxCoeff() - step.minCoeff() < kLeastSpread * std::abs(step.mean()))
        return;
    Eigen::MatrixXd X = Eigen::MatrixXd::Ones(r.size(), 2);
    X.col(1) = step.array() / step.mean() - 1.0;
    const GeneralisedFit line = fitted(X, r, V);
    const double excess
        = r.size() > 2 ? std::max(1.0, line.chiSquare / static_cast<double>(r.size() - 2)) : 1.0;
    summary.linearity_per_Pa = line.value[1] / step.mean();
    summary.uLinearity_per_Pa = std::sqrt(excess * line.covariance(1, 1)) / step.mean();
}

/// The shot farthest from the median of the others: the mean follows an outlier.
Index oddOne(const Eigen::VectorXd &r)
{
    Eigen::VectorXd sorted = r;
    std::ranges::sort(sorted);
    const Index half = r.size() / 2;
    const double median = r.size() % 2 ? sorted[half] : 0.5 * (sorted[half - 1] + sorted[half]);
    Index worst = 0;
    (r.array() - median).abs().maxCoeff(&worst);
    return worst;
}

Finding disagreement(const std::vector<ShotSensitivity> &shots, const Eigen::VectorXd &r,
    double chance, bool isComplete)
{
    const Index odd = oddOne(r);
    return {.id = "RSP-002",
        .severity = Severity::Caution,
        .message = {isComplete
                ? DYNCAL_TEXT("core",
                    "The sensitivities of the shots, from %1 to %2 % about their mean, differ by more than their uncertainties explain; shot %3 is the odd one. Their scatter serves as the uncertainty of the mean; look at that shot, its step and its level, or state one value per level.")
                : DYNCAL_TEXT("core",
                    "The sensitivities of the shots, from %1 to %2 % about their mean, differ by more than 1 % each would explain (their own uncertainties are not known); shot %3 is the odd one. Look at that shot, its step and its level, or state one value per level."),
            {numberText(100.0 * r.minCoeff(), 3), numberText(100.0 * r.maxCoeff(), 3),
                std::to_string(shots[static_cast<std::size_t>(odd)].shot)}},
        .value = chance,
        .limit = kSmallestChance,
        .causes = {FindingCause::Shots}};
}

std::vector<std::vector<std::size_t>> byLevel(const std::vector<ShotSensitivity> &shots)
{
    std::map<ShotLevel, std::vector<std::size_t>> levels;
    for (std::size_t i = 0; i < shots.size(); ++i)
        if (shots[i].level != ShotLevel::None)
            levels[shots[i].level].push_back(i);
    std::vector<std::vector<std::size_t>> groups;
    groups.reserve(levels.size());
    for (const auto &[level, group] : levels)
        groups.push_back(group);
    return groups;
}

/// Weights that make shot i less the generalised mean of the others.
Eigen::VectorXd contrastOf(Index i, const Eigen::MatrixXd &V)
{
    std::vector<Index> others;
    for (Index k = 0; k < V.rows(); ++k)
        if (k != i)
            others.push_back(k);
    const Eigen::MatrixXd rest = V(others, others);
    const Eigen::VectorXd weight = rest.ldlt().solve(Eigen::VectorXd::Ones(std::ssize(others)));
    Eigen::VectorXd contrast = Eigen::VectorXd::Unit(V.rows(), i);
    for (Index a = 0; a < weight.size(); ++a)
        contrast[others[static_cast<std::size_t>(a)]] = -weight[a] / weight.sum();
    return contrast;
}

FarthestShot farthestOf(const std::vector<ShotSensitivity> &shots, double mean,
    const Eigen::VectorXd &r, const Eigen::MatrixXd &V)
{
    FarthestShot farthest;
    double largest = -1.0;
    for (Index i = 0; i < r.size(); ++i) {
        const Eigen::VectorXd contrast = contrastOf(i, V);
        const double difference = contrast.dot(r);
        const double u = std::sqrt(contrast.dot(V * contrast));
        if (std::abs(difference) / u <= largest)
            continue;
        largest = std::abs(difference) / u;
        farthest = {shots[static_cast<std::size_t>(i)].shot, mean * (1.0 + r[i]),
            mean * (1.0 + r[i] - difference), std::abs(mean) * u};
    }
    return farthest;
}

/// Compares the shots with each other; returns the relative differences from the plain mean.
Eigen::VectorXd compare(const std::vector<ShotSensitivity> &shots, double mean, const Parts &parts,
    bool isComplete, SensitivitySummary &summary)
{
    const auto n = static_cast<Index>(shots.size());
    Eigen::VectorXd r(n);
    for (Index i = 0; i < n; ++i)
        r[i] = *shots[static_cast<std::size_t>(i)].sensitivity / mean - 1.0;
    if (n < 2 || !r.allFinite())
        return r;
    const Eigen::MatrixXd V = covarianceOf(parts);
    const GeneralisedFit about = fitted(Eigen::MatrixXd::Ones(n, 1), r, V);
    summary.homogeneity_p = chiSquareSurvival(about.chiSquare, static_cast<double>(n - 1));
    summary.shotsAgree = *summary.homogeneity_p >= kSmallestChance;
    summary.farthest = farthestOf(shots, mean, r, V);
    if (!summary.shotsAgree)
        summary.findings.push_back(disagreement(shots, r, *summary.homogeneity_p, isComplete));
    if (isComplete)
        addTrend(shots, r, V, summary);
    return r;
}

} // namespace

void addUncertainty(const StepUncertainty *step, double levelDof, ShotSensitivity &shot)
{
    const auto u_step_Pa = step ? step->u(StepResult::Step) : std::nullopt;
    if (!u_step_Pa || !shot.sensitivity || !shot.step_Pa || !std::isfinite(shot.uLevel_relative))
        return;
    const CombinedUncertainty u = combined({directLine("step", *u_step_Pa / *shot.step_Pa,
                                                step->budget.dof[kOfStep]),
        directLine(kLevelRelative, shot.uLevel_relative, levelDof > 0.0 ? levelDof : kInfinite)});
    shot.u = std::abs(*shot.sensitivity) * u.u;
    shot.dof = u.dof;
    shot.k = coverageFactor(u.dof, kCoverage);
}

SensitivitySummary summarise(
    const std::vector<ShotSensitivity> &shots, const std::vector<const StepUncertainty *> &steps)
{
    SensitivitySummary summary;
    if (shots.empty() || !std::ranges::all_of(shots, [](const ShotSensitivity &shot) {
            return shot.sensitivity.has_value() && shot.step_Pa.has_value();
        }))
        return summary;
    const Parts parts = partsOf(shots, steps);
    const bool complete = isComplete(shots, steps);
    const std::optional<Parts> known = complete ? std::optional(parts) : std::nullopt;
    std::vector<std::size_t> all(shots.size());
    for (std::size_t i = 0; i < all.size(); ++i)
        all[i] = i;
    const double plain = meanOf(shots, all, std::nullopt, {}).value;
    const Eigen::VectorXd r = compare(shots, plain, parts, complete, summary);
    const Scatter total = summary.shotsAgree ? std::nullopt : scatterWithin(r, {all});
    summary.mean = meanOf(shots, all, known, total);
    const auto groups = byLevel(shots);
    Scatter within = summary.shotsAgree ? std::nullopt : scatterWithin(r, groups);
    for (const std::vector<std::size_t> &group : groups) {
        summary.perLevel.push_back(meanOf(shots, group, known, within ? within : total));
        summary.perLevel.back().level = shots[group.front()].level;
    }
    return summary;
}

} // namespace dyncal
