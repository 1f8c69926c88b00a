// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/second_order/second_order_fit.h"

#include "core/base/number_text.h"
#include "core/realization/input/left_out.h"
#include "core/realization/refinement/coloured_covariance.h"
#include "core/realization/refinement/draft_fit.h"
#include "core/realization/refinement/pole_uncertainty.h"
#include "core/realization/refinement/series_simulation.h"
#include "core/realization/second_order/second_order_minimum.h"
#include "core/realization/second_order/second_order_problem.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace dyncal {
namespace {

/// All parameters at the values given.
Eigen::VectorXd startOf(const SecondOrderProblem &problem, const SecondOrderStart &start)
{
    Eigen::VectorXd theta(problem.parameters());
    for (std::size_t r = 0; r < problem.records().size(); ++r) {
        SecondOrderStep step;
        step.logOmega = std::log(2.0 * std::numbers::pi * start.f0_Hz * problem.unit_s());
        step.logZeta = std::log(start.zeta);
        step.plateau = start.plateau[r];
        step.onset = start.onset_s[r] / problem.unit_s();
        if (start.drift)
            step.drift = {start.drift->rate_rad_s * problem.unit_s(), start.drift->amplitude[r]};
        for (const NuisanceTerm &term : problem.records()[r].nuisance)
            step.modes.push_back({term.pole_rad_s * problem.unit_s(), term.amplitude});
        problem.setStep(step, r, theta);
    }
    return theta;
}

/// The lowest one that a start leads to.
std::optional<SecondOrderMinimum> lowestMinimum(const SecondOrderProblem &problem,
    const std::vector<SecondOrderStart> &starts, const JobControl &control)
{
    std::optional<SecondOrderMinimum> lowest;
    for (const SecondOrderStart &start : starts) {
        if (!(start.f0_Hz > 0.0) || !(start.zeta > 0.0))
            continue;
        Eigen::VectorXd theta = startOf(problem, start);
        auto equations = minimise(problem, theta, control);
        if (equations && (!lowest || equations->cost < lowest->equations.cost))
            lowest = SecondOrderMinimum{std::move(theta), std::move(*equations)};
    }
    return lowest;
}

/// How the parameters move when the front lasts longer by its u.
Eigen::VectorXd changeByFront(
    SecondOrderProblem problem, const Eigen::VectorXd &theta, double u_s, const JobControl &control)
{
    Eigen::VectorXd moved = theta;
    problem.lengthenFront(u_s);
    const bool isMoved = u_s > 0.0 && minimise(problem, moved, control);
    return isMoved ? Eigen::VectorXd(moved - theta) : Eigen::VectorXd::Zero(theta.size());
}

/// Covariance of theta, for coloured noise.
Eigen::MatrixXd covarianceOf(const SecondOrderProblem &problem, const Refinement &fit,
    const Eigen::MatrixXd &derivatives, const RegressionEquations &last, const NoiseModels &noise)
{
    const Index count = problem.parameters();
    const Eigen::MatrixXd bread = last.matrix.ldlt().solve(Eigen::MatrixXd::Identity(count, count));
    if (noise.basis.order == 0)
        return std::max(1.0, last.cost / static_cast<double>(problem.samples() - count)) * bread;
    const Eigen::MatrixXd filling = noiseFilling(
        problem.records(), noise.ofRecord, fit, Eigen::VectorXd::Ones(derivatives.rows()));
    return bread * (derivatives.transpose() * filling * derivatives) * bread;
}

/// Where the response does not ring the second pole is a delay of a few samples: the data are
/// nearly linear in it, and the damping ratio bends upwards where it gets shorter. The covariance
/// with that of w0 and zeta stretched along the damping ratio, so that `k` u reaches the upper end
/// of the interval by the likelihood.
Eigen::MatrixXd reachingUp(const SecondOrderProblem &problem, const SecondOrderMinimum &minimum,
    const Eigen::MatrixXd &covariance, double k, const JobControl &control)
{
    if (std::exp(minimum.theta[kLogZeta]) < kLeastDamping)
        return covariance;
    const Index count = covariance.rows();
    const double variance = covariance(kLogZeta, kLogZeta);
    const double ofUnitNoise
        = minimum.equations.matrix.ldlt().solve(Eigen::VectorXd::Unit(count, kLogZeta))[kLogZeta];
    const double linear = k * std::sqrt(variance);
    const double rise
        = riseOfLogZeta(problem, minimum, k * k * variance / ofUnitNoise, linear, control);
    const double stretch = std::max(1.0, std::expm1(rise) / linear);
    Eigen::VectorXd along = Eigen::VectorXd::Zero(count);
    along.head(2) = covariance.col(kLogZeta).head(2);
    return covariance + (stretch * stretch - 1.0) / variance * along * along.transpose();
}

void describeShots(const ModelInput &input, const SecondOrderProblem &problem,
    const Eigen::VectorXd &theta, const Eigen::MatrixXd &covariance, SecondOrderFit &fit)
{
    double error = 0.0;
    double spread = 0.0;
    for (std::size_t r = 0; r < problem.records().size(); ++r) {
        const ModelSeries &series = input.series[r];
        const Index plateau = problem.plateauAt(r);
        const Index onset = plateau + 1;
        const Eigen::VectorXd simulated = simulate(
            series, fit.refinement.records[r], fit.refinement.nuisance[r], sampleInterval_s(input));
        const double squares = countedValues(series, series.y - simulated).squaredNorm();
        const double about = spreadSquares(countedValues(series, series.y));
        SecondOrderShot shot;
        shot.shot = series.shot;
        shot.plateauGain = theta[plateau];
        // The uncertainty of the subtracted baseline adds to that of the plateau.
        shot.u_plateauGain = std::hypot(std::sqrt(covariance(plateau, plateau)), series.u_baseline);
        shot.onset_s = theta[onset] * problem.unit_s();
        shot.u_onset_s = std::sqrt(covariance(onset, onset)) * problem.unit_s();
        shot.fit_percent = fitPercent(squares, about);
        fit.sensor.shots.push_back(shot);
        error += squares;
        spread += about;
    }
    fit.sensor.fit_percent = fitPercent(error, spread);
}

} // namespace

std::optional<SecondOrderFit> fitSecondOrder(const ModelInput &input,
    const std::vector<RefinementRecord> &records, const std::vector<SecondOrderStart> &starts,
    const JobControl &control)
{
    if (starts.empty())
        return std::nullopt;
    const double unit_Hz = starts.front().f0_Hz;
    const SecondOrderProblem problem(records, 1.0 / (2.0 * std::numbers::pi * unit_Hz),
        input.front.duration_s, starts.front().drift.has_value());
    const auto lowest = lowestMinimum(problem, starts, control);
    const Index freedom = problem.samples() - problem.parameters();
    if (!lowest || freedom < 1)
        return std::nullopt;
    const Eigen::VectorXd &theta = lowest->theta;
    SecondOrderFit fit;
    fit.parameters = problem.parameters();
    fit.refinement = problem.asExponentials(theta);
    fit.refinement.residualToNoise
        = std::sqrt(lowest->equations.cost / static_cast<double>(freedom));
    const NoiseModels models
        = chooseNoiseModels(records, noiseBeforeStart(input), fit.refinement, fit.parameters);
    fit.noise = models.basis;
    const Eigen::MatrixXd derivatives = problem.derivatives(theta, fit.refinement);
    const Eigen::VectorXd ofFront = changeByFront(problem, theta, input.front.u_s, control);
    const double k = coverageFactor95(fit.noise.dof);
    const Eigen::MatrixXd covariance
        = reachingUp(problem, *lowest,
              covarianceOf(problem, fit.refinement, derivatives, lowest->equations, models), k,
              control)
        + ofFront * ofFront.transpose();
    fit.refinement.covariance = derivatives * covariance * derivatives.transpose();
    fit.shape = covariance.topLeftCorner<2, 2>();

    SecondOrderModel &sensor = fit.sensor;
    sensor.f0_Hz = std::exp(theta[0]) * unit_Hz;
    sensor.u_f0_Hz = sensor.f0_Hz * std::sqrt(covariance(0, 0));
    sensor.zeta = problem.step(theta, 0).zeta();
    sensor.u_zeta = sensor.zeta * std::sqrt(covariance(1, 1));
    sensor.coverageFactor = k;
    sensor.uncertaintyMethod = noiseName(fit.noise);
    sensor.residualToNoise = fit.refinement.residualToNoise;
    describeShots(input, problem, theta, covariance, fit);
    return fit;
}

Findings judgeSecondOrder(const SecondOrderModel &fit, double modelFit_percent)
{
    if (fit.describes)
        return {};
    return {{.id = "MOD-011",
        .severity = Severity::Info,
        .message
        = {DYNCAL_TEXT("core",
               "A second-order sensor (%1, damping %2) does not describe the response: FIT %3 % against %4 % of the model."),
            {numberWithUnit(fit.f0_Hz, "Hz", 5), numberText(fit.zeta, 3),
                fitPercentText(fit.fit_percent), fitPercentText(modelFit_percent)}},
        .value = fit.fit_percent,
        .limit = modelFit_percent}};
}

} // namespace dyncal
