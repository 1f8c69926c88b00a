// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/model/second_order_shots.h"

#include "core/base/distributions.h"
#include "core/realization/model/shot_parts.h"
#include "core/realization/refinement/draft_fit.h"
#include "core/realization/refinement/pole_uncertainty.h"
#include "core/realization/second_order/second_order_choice.h"
#include "core/realization/second_order/second_order_fit.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

struct SensorOfShots
{
    std::vector<std::size_t> series; ///< positions in the input
    std::optional<SecondOrderFit> fit;
};

SensorOfShots fitSensor(const ModelInput &input, const std::vector<RefinementRecord> &all,
    const SensorModel &model, const std::vector<std::size_t> &series, const JobControl &control)
{
    ModelInput part;
    part.treatment = input.treatment;
    part.sampleRate_Hz = input.sampleRate_Hz;
    part.samples = input.samples;
    part.front = input.front;
    std::vector<RefinementRecord> records;
    SecondOrderStart start{model.secondOrder->f0_Hz, model.secondOrder->zeta, {}, {}};
    const auto drift = model.draft.poles_rad_s.size() == 3 ? driftOf(model.draft) : std::nullopt;
    if (drift)
        start.drift = {drift->rate_rad_s, {}};
    for (const std::size_t r : series) {
        part.series.push_back(input.series[r]);
        records.push_back(all[r]);
        start.plateau.push_back(model.secondOrder->shots[r].plateauGain);
        start.onset_s.push_back(model.secondOrder->shots[r].onset_s);
        if (drift)
            start.drift->amplitude.push_back(drift->amplitude[r]);
    }
    return {series, fitSecondOrder(part, records, {start}, control)};
}

LevelPole describeSensor(const ModelInput &input, const SensorOfShots &part)
{
    LevelPole result = partOfShots(input, part.series);
    if (!part.fit)
        return result;
    const SecondOrderModel &sensor = part.fit->sensor;
    result.frequency_Hz = sensor.f0_Hz;
    result.u_frequency_Hz = sensor.u_f0_Hz;
    result.dampingRatio = sensor.zeta;
    result.u_dampingRatio = sensor.u_zeta;
    result.coverageFactor = sensor.coverageFactor;
    addPlateau(input, part.series, part.fit->refinement, result);
    return result;
}

std::optional<Homogeneity> testShape(const std::vector<SensorOfShots> &shots, double f0_Hz)
{
    Eigen::Matrix2d information = Eigen::Matrix2d::Zero();
    Eigen::Vector2d weighted = Eigen::Vector2d::Zero();
    double squares = 0.0;
    double fitted = 0.0;
    for (const SensorOfShots &shot : shots) {
        if (!shot.fit)
            continue;
        // Differences from the joint frequency: with ln w0 itself digits would cancel.
        const Eigen::Vector2d theta(
            std::log(shot.fit->sensor.f0_Hz / f0_Hz), std::log(shot.fit->sensor.zeta));
        const Eigen::LDLT<Eigen::Matrix2d> solver(shot.fit->shape);
        const Eigen::Vector2d share = solver.solve(theta);
        information += solver.solve(Eigen::Matrix2d::Identity());
        weighted += share;
        squares += theta.dot(share);
        fitted += 1.0;
    }
    if (fitted < 2.0)
        return std::nullopt;
    const double statistic
        = std::max(0.0, squares - weighted.dot(information.ldlt().solve(weighted)));
    if (!std::isfinite(statistic))
        return std::nullopt;
    const double dof = 2.0 * (fitted - 1.0);
    const double probability = chiSquareSurvival(statistic, dof);
    return Homogeneity{f0_Hz, statistic, dof, probability, probability >= kSharedAtLeast};
}

/// u of the weighted mean by the scatter, weighted too: near critical damping a shot of few digits
/// lies anywhere.
double weightedScatter(const std::vector<double> &values, const std::vector<double> &u)
{
    const auto count = static_cast<Index>(values.size());
    const Eigen::ArrayXd w = Eigen::Map<const Eigen::ArrayXd>(u.data(), count).square().inverse();
    const auto x = Eigen::Map<const Eigen::ArrayXd>(values.data(), count);
    const double mean = (w * x).sum() / w.sum();
    return std::sqrt((w * (x - mean).square()).sum() / (static_cast<double>(count - 1) * w.sum()));
}

/// The scatter between the shots in place of the noise, never narrower than the noise alone.
void useScatter(const std::vector<SensorOfShots> &shots, SecondOrderModel &sensor)
{
    std::vector<double> f0, u_f0, zeta, u_zeta;
    for (const SensorOfShots &shot : shots) {
        if (!shot.fit)
            continue;
        f0.push_back(shot.fit->sensor.f0_Hz);
        u_f0.push_back(shot.fit->sensor.u_f0_Hz);
        zeta.push_back(shot.fit->sensor.zeta);
        u_zeta.push_back(shot.fit->sensor.u_zeta);
    }
    const double k = coverageFactor95(static_cast<double>(f0.size() - 1));
    const double noise = sensor.coverageFactor / k;
    sensor.u_f0_Hz = std::max(noise * sensor.u_f0_Hz, weightedScatter(f0, u_f0));
    sensor.u_zeta = std::max(noise * sensor.u_zeta, weightedScatter(zeta, u_zeta));
    sensor.coverageFactor = k;
}

void markPoles(const SecondOrderModel &sensor, std::vector<Pole> &poles)
{
    for (Pole &pole : poles) {
        const bool isPair = pole.s_rad_s.imag() != 0.0;
        pole.flags.push_back(kShotsDisagreeFlag);
        pole.u_frequency_Hz = isPair ? sensor.u_f0_Hz : kUnknown;
        pole.u_dampingRatio = isPair ? sensor.u_zeta : kUnknown;
        pole.coverageFactor = isPair ? sensor.coverageFactor : kUnknown;
    }
}

} // namespace

void compareSecondOrderShots(const ModelInput &input, const SensorModel &model,
    ModelAssessment &assessment, const JobControl &control)
{
    const std::vector<RefinementRecord> records = refinementRecords(input, model.draft);
    std::vector<SensorOfShots> shots;
    for (std::size_t r = 0; r < input.series.size(); ++r) {
        shots.push_back(fitSensor(input, records, model, {r}, control));
        assessment.perShot.push_back(describeSensor(input, shots.back()));
    }
    for (const std::vector<std::size_t> &series : seriesByLevel(input))
        assessment.perLevel.push_back(describeSensor(input,
            series.size() == 1 ? shots[series.front()]
                               : fitSensor(input, records, model, series, control)));
    assessment.homogeneity = testShape(shots, model.secondOrder->f0_Hz);
    if (assessment.homogeneity && !assessment.homogeneity->passed) {
        useScatter(shots, *assessment.secondOrder);
        markPoles(*assessment.secondOrder, assessment.poles);
    }
}

} // namespace dyncal
