// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/second_order/second_order_fit.h"

#include "core/base/number_text.h"
#include "core/realization/exponentials/exponential_regression.h"
#include "core/realization/input/left_out.h"
#include "core/realization/refinement/coloured_covariance.h"
#include "core/realization/refinement/levenberg_marquardt.h"
#include "core/realization/refinement/noise_basis.h"
#include "core/realization/refinement/pole_uncertainty.h"
#include "core/realization/refinement/series_simulation.h"
#include "core/realization/second_order/second_order_step.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace dyncal {
namespace {

using Complex = std::complex<double>;

constexpr double kSlowest = 1e-4; ///< limits of zeta for a second-order sensor
constexpr double kFastest = 1e3;
constexpr double kFitMargin_points = 2.0;

/// The records with the unit of time; parameters: logOmega, logZeta, then plateau, onset and modes
/// of each, as in SecondOrderStep.
struct Problem
{
    const std::vector<RefinementRecord> &records;
    std::vector<ExponentialRegression> regressions;
    double unit_s = 1.0;
    double front_s = 0.0;

    static Index own(const RefinementRecord &record) { return 2 + 4 * std::ssize(record.nuisance); }
    Index offset(std::size_t r) const
    {
        Index at = 2;
        for (std::size_t i = 0; i < r; ++i)
            at += own(records[i]);
        return at;
    }
    Index parameters() const { return offset(records.size()); }
    double step(std::size_t r) const { return 1.0 / records[r].rate_Hz / unit_s; }
    std::vector<Index> places(std::size_t r) const
    {
        std::vector<Index> list(static_cast<std::size_t>(2 + own(records[r])));
        std::iota(list.begin(), list.begin() + 2, Index(0));
        std::iota(list.begin() + 2, list.end(), offset(r));
        return list;
    }
    SecondOrderStep local(const Eigen::VectorXd &theta, std::size_t r) const
    {
        SecondOrderStep step;
        step.front = front_s / unit_s;
        for (const NuisanceTerm &term : records[r].nuisance)
            step.modes.push_back({{}, {}, term.startsWithStep});
        step.setParameters(theta(places(r)));
        return step;
    }
};

/// `x` of SecondOrderStep::exponentials(), as the regression wants it.
std::vector<RegressionMode> modesOf(
    const SecondOrderStep &local, const Eigen::VectorXd &x, double dt)
{
    const Index gains = 2 + 2 * std::ssize(local.modes);
    std::vector<RegressionMode> modes;
    const auto addPair = [&](Index at) {
        modes.push_back(
            {Complex(x[at], x[at + 1]) * dt, {x[gains + at], x[gains + at + 1]}, true, false});
    };
    if (local.rings()) {
        addPair(0);
    } else {
        modes.push_back({x[0] * dt, x[gains], false, false});
        modes.push_back({x[1] * dt, x[gains + 1], false, false});
    }
    for (Index i = 0; i < std::ssize(local.modes); ++i)
        addPair(2 + 2 * i);
    modes.push_back({0.0, local.plateau, false, true});
    return modes;
}

RegressionEquations normalEquations(const Problem &problem, const Eigen::VectorXd &theta)
{
    const Index count = problem.parameters();
    RegressionEquations sum{Eigen::MatrixXd::Zero(count, count), Eigen::VectorXd::Zero(count), 0.0};
    for (std::size_t r = 0; r < problem.records.size(); ++r) {
        const SecondOrderStep local = problem.local(theta, r);
        const double dt = problem.step(r);
        const RegressionEquations own
            = problem.regressions[r].equations(modesOf(local, local.exponentials(), dt), dt);
        const Eigen::MatrixXd J = local.derivatives();
        const std::vector<Index> at = problem.places(r);
        const double weight = problem.records[r].weight * problem.records[r].weight;
        sum.matrix(at, at) += weight * (J.transpose() * own.matrix * J);
        sum.gradient(at) += weight * (J.transpose() * own.gradient);
        sum.cost += weight * own.cost;
    }
    return sum;
}

bool isSensible(const Problem &problem, const Eigen::VectorXd &theta)
{
    const double zeta = std::exp(theta[1]);
    if (!theta.allFinite() || !(zeta > kSlowest) || !(zeta < kFastest))
        return false;
    for (std::size_t r = 0; r < problem.records.size(); ++r) {
        Index at = problem.offset(r) + 2;
        for (const NuisanceTerm &term : problem.records[r].nuisance) {
            const double before = term.pole_rad_s.imag() * problem.unit_s;
            if (!isSameOscillation(before, theta[at + 1]))
                return false;
            at += 4;
        }
    }
    return true;
}

/// All parameters at the values of the free model.
Eigen::VectorXd startOf(const Problem &problem, const SecondOrderStart &start)
{
    Eigen::VectorXd theta(problem.parameters());
    for (std::size_t r = 0; r < problem.records.size(); ++r) {
        SecondOrderStep step;
        step.logZeta = std::log(start.zeta);
        step.plateau = start.plateau[r];
        step.onset = start.onset_s[r] / problem.unit_s;
        for (const NuisanceTerm &term : problem.records[r].nuisance)
            step.modes.push_back({term.pole_rad_s * problem.unit_s, term.amplitude});
        theta(problem.places(r)) = step.parameterValues();
    }
    return theta;
}

/// The equations at the optimum, or nothing.
std::optional<RegressionEquations> minimise(
    const Problem &problem, Eigen::VectorXd &theta, const JobControl &control)
{
    const auto equations = descend(
        theta, {100, 1e-3}, [&](const Eigen::VectorXd &at) { return normalEquations(problem, at); },
        [&](const Eigen::VectorXd &at) { return isSensible(problem, at); }, control);
    return isSensible(problem, theta) ? equations : std::nullopt;
}

/// How the parameters move when the front lasts longer by its u.
Eigen::VectorXd changeByFront(
    Problem problem, const Eigen::VectorXd &theta, double u_s, const JobControl &control)
{
    Eigen::VectorXd moved = theta;
    problem.front_s += u_s;
    if (u_s > 0.0 && minimise(problem, moved, control))
        return moved - theta;
    return Eigen::VectorXd::Zero(theta.size());
}

/// The fit as sums of exponentials, in seconds.
Refinement asExponentials(const Problem &problem, const Eigen::VectorXd &theta)
{
    Refinement fit;
    fit.poleParameters = 2;
    fit.withConstant = true;
    Index offset = 2;
    for (std::size_t r = 0; r < problem.records.size(); ++r) {
        const SecondOrderStep local = problem.local(theta, r);
        const Eigen::VectorXd x = local.exponentials();
        const Eigen::Vector2d gain = x.segment(2 + 2 * std::ssize(local.modes), 2);
        ExponentialSum sum;
        sum.constant = local.plateau;
        sum.poles_rad_s.resize(2);
        sum.amplitudes.resize(2);
        if (local.rings()) {
            sum.poles_rad_s << Complex(x[0], x[1]), Complex(x[0], -x[1]);
            sum.amplitudes << 0.5 * Complex(gain[0], gain[1]), 0.5 * Complex(gain[0], -gain[1]);
        } else {
            sum.poles_rad_s << x[0], x[1];
            sum.amplitudes << gain[0], gain[1];
        }
        sum.poles_rad_s /= problem.unit_s;
        fit.poles_rad_s.assign(sum.poles_rad_s.begin(), sum.poles_rad_s.end());
        fit.records.push_back(std::move(sum));
        std::vector<NuisanceTerm> terms = problem.records[r].nuisance;
        for (std::size_t i = 0; i < terms.size(); ++i) {
            terms[i].pole_rad_s = local.modes[i].pole / problem.unit_s;
            terms[i].amplitude = local.modes[i].amplitude;
        }
        fit.nuisance.push_back(std::move(terms));
        fit.offsets.push_back(offset);
        offset += 3 + 4 * std::ssize(local.modes);
    }
    return fit;
}

/// d (parameters of asExponentials) / d theta, poles in units of problem.unit_s.
Eigen::MatrixXd chain(const Problem &problem, const Eigen::VectorXd &theta, const Refinement &fit)
{
    const Index rows = fit.offsets.back() + 3 + 4 * std::ssize(fit.nuisance.back());
    Eigen::MatrixXd J = Eigen::MatrixXd::Zero(rows, problem.parameters());
    for (std::size_t r = 0; r < problem.records.size(); ++r) {
        const Eigen::MatrixXd own = problem.local(theta, r).derivatives();
        const std::vector<Index> at = problem.places(r);
        const Index modes = std::ssize(fit.nuisance[r]);
        const Index gains = 2 + 2 * modes;
        const auto put = [&](Index row, Index from, Index count, double unit) {
            J.middleRows(row, count)(Eigen::all, at) = own.middleRows(from, count) / unit;
        };
        put(0, 0, 2, problem.unit_s);
        put(fit.offsets[r], gains, 2, 1.0);
        put(fit.offsets[r] + 2, own.rows() - 1, 1, 1.0);
        for (Index i = 0; i < modes; ++i) {
            put(fit.offsets[r] + 3 + 4 * i, 2 + 2 * i, 2, problem.unit_s);
            put(fit.offsets[r] + 5 + 4 * i, gains + 2 + 2 * i, 2, 1.0);
        }
    }
    return J;
}

/// Covariance of theta, for coloured noise.
Eigen::MatrixXd covarianceOf(const Problem &problem, const Eigen::VectorXd &theta,
    const RegressionEquations &last, double chiSquare, const NoiseModels &noise)
{
    const Index count = problem.parameters();
    const Eigen::MatrixXd bread = last.matrix.ldlt().solve(Eigen::MatrixXd::Identity(count, count));
    if (noise.basis.order == 0)
        return std::max(1.0, chiSquare) * bread;
    const Refinement fit = asExponentials(problem, theta);
    const Eigen::MatrixXd J = chain(problem, theta, fit);
    const Eigen::MatrixXd filling
        = noiseFilling(problem.records, noise.ofRecord, fit, Eigen::VectorXd::Ones(J.rows()));
    return bread * (J.transpose() * filling * J) * bread;
}

void describeShots(const ModelInput &input, const Problem &problem, const Eigen::VectorXd &theta,
    const Eigen::MatrixXd &covariance, SecondOrderModel &model)
{
    const Refinement fit = asExponentials(problem, theta);
    double error = 0.0;
    double spread = 0.0;
    for (std::size_t r = 0; r < problem.records.size(); ++r) {
        const ModelSeries &series = input.series[r];
        const Index plateau = problem.offset(r);
        const Index onset = plateau + 1;
        const Eigen::VectorXd simulated
            = simulate(series, fit.records[r], fit.nuisance[r], sampleInterval_s(input));
        const double squares = countedValues(series, series.y - simulated).squaredNorm();
        const double about = spreadSquares(countedValues(series, series.y));
        SecondOrderShot shot;
        shot.shot = series.shot;
        shot.plateauGain = theta[plateau];
        // The uncertainty of the subtracted baseline adds to that of the plateau.
        shot.u_plateauGain = std::hypot(std::sqrt(covariance(plateau, plateau)), series.u_baseline);
        shot.onset_s = theta[onset] * problem.unit_s;
        shot.u_onset_s = std::sqrt(covariance(onset, onset)) * problem.unit_s;
        shot.fit_percent = fitPercent(squares, about);
        model.shots.push_back(shot);
        error += squares;
        spread += about;
    }
    model.fit_percent = fitPercent(error, spread);
}

} // namespace

std::optional<SecondOrderModel> fitSecondOrder(const ModelInput &input,
    const std::vector<RefinementRecord> &records, const SecondOrderStart &start,
    double fitToReach_percent, const JobControl &control)
{
    if (!(start.f0_Hz > 0.0) || !(start.zeta > 0.0))
        return std::nullopt;
    Problem problem{
        records, {}, 1.0 / (2.0 * std::numbers::pi * start.f0_Hz), input.front.duration_s};
    Index samples = 0;
    std::vector<NoiseCovariance> noise;
    for (std::size_t r = 0; r < records.size(); ++r) {
        problem.regressions.emplace_back(records[r].y, records[r].used);
        samples += problem.regressions.back().count();
        noise.push_back(input.series[r].fullRateNoise);
    }
    Eigen::VectorXd theta = startOf(problem, start);
    const auto last = minimise(problem, theta, control);
    const Index freedom = samples - problem.parameters();
    if (!last || freedom < 1)
        return std::nullopt;

    const double chiSquare = last->cost / static_cast<double>(freedom);
    const NoiseModels models
        = chooseNoiseModels(records, noise, asExponentials(problem, theta), problem.parameters());
    const Eigen::MatrixXd covariance = covarianceOf(problem, theta, *last, chiSquare, models);
    SecondOrderModel model;
    model.f0_Hz = std::exp(theta[0]) * start.f0_Hz;
    const Eigen::VectorXd ofFront = changeByFront(problem, theta, input.front.u_s, control);
    model.u_f0_Hz = model.f0_Hz * std::hypot(std::sqrt(covariance(0, 0)), ofFront[0]);
    model.zeta = problem.local(theta, 0).zeta();
    model.u_zeta = model.zeta * std::hypot(std::sqrt(covariance(1, 1)), ofFront[1]);
    model.coverageFactor = coverageFactor95(models.basis.dof);
    model.uncertaintyMethod = noiseName(models.basis);
    model.residualToNoise = std::sqrt(chiSquare);
    describeShots(input, problem, theta, covariance, model);
    model.describes = model.fit_percent >= fitToReach_percent - kFitMargin_points;
    return model;
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
