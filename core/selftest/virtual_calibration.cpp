// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/selftest/virtual_calibration.h"

#include "core/base/constants.h"
#include "core/base/portable_random.h"
#include "core/pipeline/pipeline.h"
#include "core/selftest/known_records.h"
#include "core/selftest/second_order_truth.h"
#include "core/uncertainty/budgets.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace dyncal {
namespace {

constexpr double kVirtualRate_Hz = 2e6;
constexpr Index kVirtualSamples = 8000;
constexpr double kVirtualNoise = 0.01; ///< of the step
constexpr double kRiseOfSide_s = 4.0 / kVirtualRate_Hz;
constexpr double kArrivalAtWall_s = 2.2e-3;
constexpr double kFarDistance_m = 0.8, kNearDistance_m = 0.4;
constexpr double kGamma = 1.4, kMolarMass_kg_mol = 0.02896;
constexpr double kT1_K = 294.15, kP1_Pa = 101100.0;
constexpr double kMagnitudeAt_Hz = 20e3;

// Standard uncertainties that the laboratory states.
constexpr double kU_T1_K = 0.3, kU_p1_Pa = 30.0, kU_distance_m = 2e-4;
constexpr double kU_gamma = 5e-4, kU_molarMass_kg_mol = 1e-5, kU_delay_s = 5e-8;

constexpr std::uint64_t kVirtualSeed = 20170251;

/// What is true of one calibration.
struct VirtualTruth
{
    SecondOrderTruth sensor;
    double sensitivity_V_Pa = 0.0;
    std::array<double, 2> velocity_m_s{}; ///< of each shot
};

VirtualTruth drawnTruth(Index run)
{
    RandomStream random(kVirtualSeed, run, 1);
    VirtualTruth truth;
    truth.sensor.f0_Hz = 80e3 + 40e3 * random.nextUniform();
    truth.sensor.zeta = 0.03 + 0.05 * random.nextUniform();
    truth.sensitivity_V_Pa = 2e-6 * (1.0 + random.nextUniform());
    for (double &velocity_m_s : truth.velocity_m_s)
        velocity_m_s = 450.0 + 150.0 * random.nextUniform();
    return truth;
}

/// p5 - p1 behind the reflected shock: p2/p1 and p5/p2 by Rankine and Hugoniot.
double trueStep_Pa(double velocity_m_s)
{
    const double M2
        = velocity_m_s * velocity_m_s * kMolarMass_kg_mol / (kGamma * 8.314462618 * kT1_K);
    const double ratio = 1.0 + 2.0 * kGamma / (kGamma + 1.0) * (M2 - 1.0);
    const double reflected = ((3.0 * kGamma - 1.0) * ratio - (kGamma - 1.0))
        / ((kGamma - 1.0) * ratio + (kGamma + 1.0));
    return kP1_Pa * (ratio * reflected - 1.0);
}

/// Values at every sample of one record, with noise.
template <typename Function>
Eigen::VectorXd noisyRecord(RandomStream &random, double sd, const Function &valueAt)
{
    Eigen::VectorXd values(kVirtualSamples);
    for (Index k = 0; k < kVirtualSamples; ++k)
        values[k] = valueAt(static_cast<double>(k) / kVirtualRate_Hz);
    random.addNormal({values.data(), static_cast<std::size_t>(values.size())}, sd);
    return values;
}

/// A side sensor: an even rise from the arrival on.
Eigen::VectorXd sideRecord(RandomStream &random, double arrival_s)
{
    return noisyRecord(random, 2e-3,
        [&](double t_s) { return std::clamp((t_s - arrival_s) / kRiseOfSide_s, 0.0, 1.0); });
}

Shot virtualShot(const VirtualTruth &truth, Index run, Index shot, double delayError_s)
{
    const double velocity_m_s = truth.velocity_m_s[static_cast<std::size_t>(shot)];
    const double level_V = truth.sensitivity_V_Pa * trueStep_Pa(velocity_m_s);
    RandomStream noise(kVirtualSeed, run, 10 + shot);
    const auto dut = noisyRecord(noise, kVirtualNoise * level_V,
        [&](double t_s) { return 0.05 + level_V * truth.sensor.step(t_s - kArrivalAtWall_s); });
    Shot made;
    made.label = "virtual";
    made.channels.push_back(knownChannel("DUT", ChannelRole::Dut, dut, kVirtualRate_Hz));
    for (const auto &[name, distance_m] :
        {std::pair("far", kFarDistance_m), std::pair("near", kNearDistance_m)}) {
        const double arrival_s = kArrivalAtWall_s - distance_m / velocity_m_s
            + (distance_m == kFarDistance_m ? delayError_s : 0.0);
        made.channels.push_back(knownChannel(
            name, ChannelRole::DrivenSide, sideRecord(noise, arrival_s), kVirtualRate_Hz));
    }
    return made;
}

/// Within +-sqrt(3) u, all equally likely.
double rectangular(RandomStream &random, double u)
{
    return std::sqrt(3.0) * u * (2.0 * random.nextUniform() - 1.0);
}

ArrivalSensor statedSensor(const char *name, double distance_m, RandomStream &errors)
{
    ArrivalSensor sensor{name, distance_m + kU_distance_m * errors.nextNormal(), kU_distance_m};
    sensor.delay_s = 0.5 * kRiseOfSide_s;
    sensor.u_delay_s = kU_delay_s;
    return sensor;
}

/// What the laboratory knows: the truth with errors of the size that it states.
Recipe statedRecipe(RandomStream &errors)
{
    Recipe recipe;
    ShockSettings &shock = recipe.shock;
    shock.p1_Pa = kP1_Pa + kU_p1_Pa * errors.nextNormal();
    shock.T1_K = kT1_K + kU_T1_K * errors.nextNormal();
    shock.drivenGas = {kGamma + kU_gamma * errors.nextNormal(),
        kMolarMass_kg_mol + kU_molarMass_kg_mol * errors.nextNormal(), "custom",
        kConstantHeatCapacity};
    shock.attenuation = "none";
    shock.arrivalSensors = {
        statedSensor("far", kFarDistance_m, errors), statedSensor("near", kNearDistance_m, errors)};
    recipe.uncertainty.budget = {{"t1_k", kU_T1_K}, {"p1_pa", kU_p1_Pa}, {"gamma", kU_gamma},
        {"molar_mass_kg_mol", kU_molarMass_kg_mol}, {"step_relative", 0.0}, {"gain_relative", 0.0}};
    recipe.realization.order = Auto<Index>(2);
    recipe.response.grid = "list";
    recipe.response.frequencies_Hz = {kMagnitudeAt_Hz};
    return recipe;
}

VirtualError errorOf(const ReportedValue *stated, double truth)
{
    if (!stated || !stated->u)
        return {kUnknown, false};
    const double error = stated->value - truth;
    return {error / *stated->u, std::abs(error) <= stated->expanded().value_or(0.0)};
}

/// The magnitude at the one frequency of the recipe.
const ReportedValue *magnitudeIn(const std::vector<Budget> &budgets)
{
    for (const Budget &budget : budgets)
        if (budget.kind == BudgetOf::Magnitude && budget.frequency_Hz == kMagnitudeAt_Hz)
            return &budget.reported;
    return nullptr;
}

} // namespace

VirtualErrors virtualCalibration(Index run, const std::stop_token &stop)
{
    const VirtualTruth truth = drawnTruth(run);
    RandomStream errors(kVirtualSeed, run, 2);
    const Recipe recipe = statedRecipe(errors);
    const double delayError_s = rectangular(errors, kU_delay_s);
    auto set = std::make_shared<CaptureSet>();
    for (Index shot = 0; shot < 2; ++shot)
        set->shots.push_back(virtualShot(truth, run, shot, delayError_s));
    ResultCache cache;
    const PipelineOutcome outcome
        = runPipeline(set, recipe, cache, StageId::Uncertainty, {stop, {}});
    VirtualErrors found;
    found.fill({kUnknown, false});
    if (!outcome.results.uncertainty)
        return found;
    const UncertaintyReport &report = *outcome.results.uncertainty;
    const std::vector<Budget> budgets = allBudgets(report, *outcome.results.response);
    const double S = truth.sensitivity_V_Pa;
    return {errorOf(report.sensitivity ? &*report.sensitivity : nullptr, S),
        errorOf(report.find("f0_hz"), truth.sensor.f0_Hz),
        errorOf(report.find("damping_ratio"), truth.sensor.zeta),
        errorOf(magnitudeIn(budgets), S * std::abs(truth.sensor.response(kMagnitudeAt_Hz)))};
}

} // namespace dyncal
