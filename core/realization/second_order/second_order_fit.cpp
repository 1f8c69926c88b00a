// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/second_order/second_order_fit.h"

#include "core/base/number_text.h"
#include "core/realization/input/left_out.h"
#include "core/realization/refinement/coloured_covariance.h"
#include "core/realization/refinement/draft_fit.h"
#include "core/realization/refinement/levenberg_marquardt.h"
#include "core/realization/refinement/pole_uncertainty.h"
#include "core/realization/refinement/series_simulation.h"
#include "core/realization/second_order/second_order_problem.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace dyncal {
namespace {

constexpr double kSlowest = 1e-4; ///< limits of zeta for a second-order sensor
constexpr double kFastest = 1e3;

/// A drift is at most a tenth as fast as the sensor, and does not grow beyond a third while it is
/// recorded.
bool isSlow(const SecondOrderProblem &problem, const Eigen::VectorXd &theta)
{
    constexpr double kSlowerThanSensor = 0.1;
    constexpr double kMostGrowth = 0.3;
    double longest = 0.0;
    for (const RefinementRecord &record : problem.records())
        longest = std::max(
            longest, static_cast<double>(record.y.size()) / record.rate_Hz / problem.unit_s());
    const double zeta = std::exp(theta[1]);
    const double sensor
        = std::exp(theta[0]) / (zeta > 1.0 ? zeta + std::sqrt(zeta * zeta - 1.0) : 1.0);
    return theta[2] >= -kSlowerThanSensor * sensor && theta[2] * longest <= kMostGrowth;
}

bool isSensible(const SecondOrderProblem &problem, const Eigen::VectorXd &theta)
{
    const double zeta = std::exp(theta[1]);
    if (!theta.allFinite() || !(zeta > kSlowest) || !(zeta < kFastest))
        return false;
    if (problem.withDrift() && !isSlow(problem, theta))
        return false;
    for (std::size_t r = 0; r < problem.records().size(); ++r) {
        Index at = problem.plateauAt(r) + (problem.withDrift() ? 3 : 2);
        for (const NuisanceTerm &term : problem.records()[r].nuisance) {
            const double before = term.pole_rad_s.imag() * problem.unit_s();
            if (!isSameOscillation(before, theta[at + 1]))
                return false;
            at += 4;
        }
    }
    return true;
}

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

/// The equations at the optimum, or nothing.
std::optional<RegressionEquations> minimise(
    const SecondOrderProblem &problem, Eigen::VectorXd &theta, const JobControl &control)
{
    const auto equations = descend(
        theta, {100, 1e-3}, [&](const Eigen::VectorXd &at) { return problem.normalEquations(at); },
        [&](const Eigen::VectorXd &at) { return isSensible(problem, at); }, control);
    return isSensible(problem, theta) ? equations : std::nullopt;
}

struct Minimum
{
    Eigen::VectorXd theta;
    RegressionEquations equations;
};

/// The lowest one that a start leads to.
std::optional<Minimum> lowestMinimum(const SecondOrderProblem &problem,
    const std::vector<SecondOrderStart> &starts, const JobControl &control)
{
    std::optional<Minimum> lowest;
    for (const SecondOrderStart &start : starts) {
        if (!(start.f0_Hz > 0.0) || !(start.zeta > 0.0))
            continue;
        Eigen::VectorXd theta = startOf(problem, start);
        auto equations = minimise(problem, theta, control);
        if (equations && (!lowest || equations->cost < lowest->equations.cost))
            lowest = Minimum{std::move(theta), std::move(*equations)};
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
    const Eigen::MatrixXd covariance
        = covarianceOf(problem, fit.refinement, derivatives, lowest->equations, models)
        + ofFront * ofFront.transpose();
    fit.refinement.covariance = derivatives * covariance * derivatives.transpose();
    fit.shape = covariance.topLeftCorner<2, 2>();

    SecondOrderModel &sensor = fit.sensor;
    sensor.f0_Hz = std::exp(theta[0]) * unit_Hz;
    sensor.u_f0_Hz = sensor.f0_Hz * std::sqrt(covariance(0, 0));
    sensor.zeta = problem.step(theta, 0).zeta();
    sensor.u_zeta = sensor.zeta * std::sqrt(covariance(1, 1));
    sensor.coverageFactor = coverageFactor95(fit.noise.dof);
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
