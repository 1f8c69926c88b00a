// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/second_order_fit.h"

#include "core/base/number_text.h"
#include "core/realization/exponential_regression.h"
#include "core/realization/levenberg_marquardt.h"
#include "core/realization/pole_uncertainty.h"
#include "core/realization/series_fit.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dyncal {
namespace {

using Complex = std::complex<double>;
using Exponentials = Eigen::Matrix<double, 5, 1>; ///< rates, gains (two each), constant

constexpr double kCriticalDistance = 1e-4; ///< of zeta from 1, where the two poles meet
constexpr double kSlowest = 1e-4; ///< zeta beyond which nothing is a second-order sensor
constexpr double kFastest = 1e3;
constexpr double kFitMargin_points = 2.0;

/// One shot's share of the parameters; times in units of 1/|start w0|.
struct Local
{
    double logOmega = 0.0;
    double logZeta = 0.0;
    double plateau = 0.0;
    double onset = 0.0;
};

double dampingOf(double logZeta)
{
    const double zeta = std::exp(logZeta);
    if (std::abs(zeta - 1.0) >= kCriticalDistance)
        return zeta;
    return zeta < 1.0 ? 1.0 - kCriticalDistance : 1.0 + kCriticalDistance;
}

/// The step response as a sum of exponentials: Re s, Im s, Re g, Im g of y = K + Re(g e^(s t)), or
/// for zeta > 1 the two real rates and their gains.
Exponentials exponentialsOf(const Local &local)
{
    const double omega = std::exp(local.logOmega);
    const double zeta = dampingOf(local.logZeta);
    Exponentials x;
    if (zeta < 1.0) {
        const double root = std::sqrt((1.0 - zeta) * (1.0 + zeta));
        const Complex s(-zeta * omega, root * omega);
        const Complex g = -local.plateau * Complex(1.0, -zeta / root) * std::exp(-s * local.onset);
        x << s.real(), s.imag(), g.real(), g.imag(), local.plateau;
        return x;
    }
    const double root = std::sqrt((zeta - 1.0) * (zeta + 1.0));
    const double slow = -omega / (zeta + root);
    const double fast = -omega * (zeta + root);
    const double unit = local.plateau / (fast - slow);
    x << slow, fast, -unit * fast * std::exp(-slow * local.onset),
        unit * slow * std::exp(-fast * local.onset), local.plateau;
    return x;
}

/// d exponentials / d (logOmega, logZeta, plateau, onset), by central differences: smooth, small
/// and the same for both branches.
Eigen::Matrix<double, 5, 4> derivativesOf(const Local &local)
{
    constexpr double kStep = 1e-6;
    Eigen::Matrix<double, 5, 4> J;
    const auto column = [&](double Local::*member, double step) {
        Local above = local;
        Local below = local;
        above.*member += step;
        below.*member -= step;
        return Exponentials((exponentialsOf(above) - exponentialsOf(below)) / (2.0 * step));
    };
    J.col(0) = column(&Local::logOmega, kStep);
    J.col(1) = column(&Local::logZeta, kStep);
    J.col(2) = column(&Local::plateau, kStep * std::max(1e-30, std::abs(local.plateau)));
    J.col(3) = column(&Local::onset, kStep);
    return J;
}

/// The records with the unit of time; parameters: logOmega, logZeta, then plateau, onset of each.
struct Problem
{
    const std::vector<RefinementRecord> &records;
    std::vector<ExponentialRegression> regressions;
    double unit_s = 1.0;

    Index parameters() const { return 2 + 2 * std::ssize(records); }
    double step(std::size_t r) const { return 1.0 / records[r].rate_Hz / unit_s; }
    static std::array<Index, 4> places(std::size_t r)
    {
        const Index own = 2 + 2 * static_cast<Index>(r);
        return {0, 1, own, own + 1};
    }
    static Local local(const Eigen::VectorXd &theta, std::size_t r)
    {
        const auto at = places(r);
        return {theta[at[0]], theta[at[1]], theta[at[2]], theta[at[3]]};
    }
};

RegressionEquations normalEquations(const Problem &problem, const Eigen::VectorXd &theta)
{
    const Index count = problem.parameters();
    RegressionEquations sum{Eigen::MatrixXd::Zero(count, count), Eigen::VectorXd::Zero(count), 0.0};
    for (std::size_t r = 0; r < problem.records.size(); ++r) {
        const Local local = Problem::local(theta, r);
        const Exponentials x = exponentialsOf(local);
        const double dt = problem.step(r);
        std::vector<RegressionMode> modes;
        if (dampingOf(local.logZeta) < 1.0)
            modes.push_back({Complex(x[0], x[1]) * dt, {x[2], x[3]}, true, false});
        else
            modes = {{x[0] * dt, x[2], false, false}, {x[1] * dt, x[3], false, false}};
        modes.push_back({0.0, x[4], false, true});
        const RegressionEquations own = problem.regressions[r].equations(modes, dt);
        const auto J = derivativesOf(local);
        const auto at = Problem::places(r);
        const double weight = problem.records[r].weight * problem.records[r].weight;
        sum.matrix(at, at) += weight * (J.transpose() * own.matrix * J);
        sum.gradient(at) += weight * (J.transpose() * own.gradient);
        sum.cost += weight * own.cost;
    }
    return sum;
}

bool isSensible(const Eigen::VectorXd &theta)
{
    const double zeta = std::exp(theta[1]);
    return theta.allFinite() && zeta > kSlowest && zeta < kFastest;
}

/// The equations at the optimum, or nothing.
std::optional<RegressionEquations> minimise(
    const Problem &problem, Eigen::VectorXd &theta, const JobControl &control)
{
    return descend(
        theta, {100, 1e-3}, [&](const Eigen::VectorXd &at) { return normalEquations(problem, at); },
        isSensible, control);
}

/// The fit as the sums of exponentials it is, in seconds.
Refinement asExponentials(const Problem &problem, const Eigen::VectorXd &theta)
{
    Refinement fit;
    fit.poleParameters = 2;
    fit.withConstant = true;
    for (std::size_t r = 0; r < problem.records.size(); ++r) {
        const Local local = Problem::local(theta, r);
        const Exponentials x = exponentialsOf(local);
        ExponentialSum sum;
        sum.constant = x[4];
        sum.rates_rad_s.resize(2);
        sum.amplitudes.resize(2);
        if (dampingOf(local.logZeta) < 1.0) {
            sum.rates_rad_s << Complex(x[0], x[1]), Complex(x[0], -x[1]);
            sum.amplitudes << 0.5 * Complex(x[2], x[3]), 0.5 * Complex(x[2], -x[3]);
        } else {
            sum.rates_rad_s << x[0], x[1];
            sum.amplitudes << x[2], x[3];
        }
        sum.rates_rad_s /= problem.unit_s;
        fit.rates_rad_s.assign(sum.rates_rad_s.begin(), sum.rates_rad_s.end());
        fit.records.push_back(std::move(sum));
        fit.nuisance.emplace_back();
        fit.offsets.push_back(2 + 3 * static_cast<Index>(r));
    }
    return fit;
}

/// d (parameters of asExponentials) / d theta, rates in seconds.
Eigen::MatrixXd chain(const Problem &problem, const Eigen::VectorXd &theta)
{
    const Index shots = std::ssize(problem.records);
    Eigen::MatrixXd J = Eigen::MatrixXd::Zero(2 + 3 * shots, problem.parameters());
    for (std::size_t r = 0; r < problem.records.size(); ++r) {
        const auto own = derivativesOf(Problem::local(theta, r));
        const auto at = Problem::places(r);
        J.topRows(2)(Eigen::all, at) = own.topRows(2) / problem.unit_s;
        J.middleRows(2 + 3 * static_cast<Index>(r), 3)(Eigen::all, at) = own.bottomRows(3);
    }
    return J;
}

/// Of theta, with the noise's colour.
Eigen::MatrixXd covarianceOf(const Problem &problem, const Eigen::VectorXd &theta,
    const RegressionEquations &last, double chiSquare, const NoiseModels &noise)
{
    const Index count = problem.parameters();
    const Eigen::MatrixXd bread = last.matrix.ldlt().solve(Eigen::MatrixXd::Identity(count, count));
    if (noise.basis.order == 0)
        return std::max(1.0, chiSquare) * bread;
    const Eigen::MatrixXd J = chain(problem, theta);
    const Eigen::MatrixXd filling = noiseFilling(problem.records, noise.ofRecord,
        asExponentials(problem, theta), Eigen::VectorXd::Ones(J.rows()));
    return bread * (J.transpose() * filling * J) * bread;
}

/// At the samples of the model input, through the filter as measured.
Eigen::VectorXd atModelRate(const ModelSeries &series, ExponentialSum sum, double rate_Hz)
{
    for (Index i = 0; i < sum.rates_rad_s.size(); ++i) {
        const Complex s = sum.rates_rad_s[i];
        sum.amplitudes[i] *= series.filter.gain(s) * std::exp(s * series.first_s);
    }
    const ExponentialSampler sampler(sum, 1.0 / rate_Hz);
    Eigen::VectorXd y(series.y.size());
    for (Index begin = 0; begin < y.size(); begin += ExponentialSampler::kBlock) {
        const Index size = std::min(ExponentialSampler::kBlock, y.size() - begin);
        y.segment(begin, size) = sampler.block(begin / ExponentialSampler::kBlock).head(size);
    }
    return y;
}

void describeShots(const ModelInput &input, const Problem &problem, const Eigen::VectorXd &theta,
    const Eigen::MatrixXd &covariance, SecondOrderModel &model)
{
    const Refinement fit = asExponentials(problem, theta);
    double error = 0.0;
    double spread = 0.0;
    for (std::size_t r = 0; r < problem.records.size(); ++r) {
        const ModelSeries &series = input.series[r];
        const Index plateau = Problem::places(r)[2];
        const Index onset = Problem::places(r)[3];
        const double squares
            = (series.y - atModelRate(series, fit.records[r], input.sampleRate_Hz)).squaredNorm();
        SecondOrderShot shot;
        shot.shot = series.shot;
        shot.plateauGain = theta[plateau];
        shot.u_plateauGain = std::sqrt(covariance(plateau, plateau));
        shot.onset_s = theta[onset] * problem.unit_s;
        shot.u_onset_s = std::sqrt(covariance(onset, onset)) * problem.unit_s;
        shot.fit_percent = fitPercent(squares, spreadSquares(series.y));
        model.shots.push_back(shot);
        error += squares;
        spread += spreadSquares(series.y);
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
    Problem problem{records, {}, 1.0 / (2.0 * std::numbers::pi * start.f0_Hz)};
    Index samples = 0;
    std::vector<NoiseCovariance> noise;
    Eigen::VectorXd theta(problem.parameters());
    theta.head(2) << 0.0, std::log(start.zeta);
    for (std::size_t r = 0; r < records.size(); ++r) {
        problem.regressions.emplace_back(records[r].y, records[r].used);
        samples += problem.regressions.back().count();
        noise.push_back(input.series[r].fullRateNoise);
        theta.segment(2 + 2 * static_cast<Index>(r), 2) << start.plateau[r],
            start.onset_s[r] / problem.unit_s;
    }
    const auto last = minimise(problem, theta, control);
    const Index freedom = samples - problem.parameters();
    if (!last || !isSensible(theta) || freedom < 1)
        return std::nullopt;

    const double chiSquare = last->cost / static_cast<double>(freedom);
    const NoiseModels models
        = chooseNoiseModels(records, noise, asExponentials(problem, theta), problem.parameters());
    const Eigen::MatrixXd covariance = covarianceOf(problem, theta, *last, chiSquare, models);
    SecondOrderModel model;
    model.f0_Hz = std::exp(theta[0]) * start.f0_Hz;
    model.u_f0_Hz = model.f0_Hz * std::sqrt(covariance(0, 0));
    model.zeta = dampingOf(theta[1]);
    model.u_zeta = model.zeta * std::sqrt(covariance(1, 1));
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
    return {{"MOD-011", Severity::Info, 0, {}, {},
        {DYNCAL_TEXT("core",
             "A second-order sensor (%1, damping %2) does not describe the response: FIT %3 % "
             "against %4 % of the model."),
            {numberWithUnit(fit.f0_Hz, "Hz", 5), numberText(fit.zeta, 3),
                numberText(std::round(10.0 * fit.fit_percent) / 10.0, 4),
                numberText(std::round(10.0 * modelFit_percent) / 10.0, 4)}},
        fit.fit_percent, modelFit_percent}};
}

} // namespace dyncal
