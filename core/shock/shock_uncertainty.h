// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/base/index.h"
#include "core/base/progress.h"
#include "core/base/propagation.h"
#include "core/base/result.h"
#include "core/shock/step_inputs.h"
#include "core/shock/uncertainty_settings.h"

#include <optional>
#include <string>
#include <vector>

namespace dyncal {

/// The results whose uncertainty is computed, in this order.
enum class StepResult : Index { Velocity, Mach, P2, P5, Step };
inline constexpr Index kStepResults = 5;

/// Uncertainty of one shot's velocity, Mach number, p2, p5 and step.
struct StepUncertainty
{
    GumBudget budget;
    std::optional<Message> velocityMissing; ///< input without stated u: no u(W)
    std::optional<Message> stateMissing; ///< the same for Mach number, p2 and p5
    std::optional<Message> stepMissing;

    std::optional<double> u(StepResult result) const;
    double contributionOf(const std::string &input, StepResult result) const; ///< 0 without it
};

/// What is asked for besides the step itself.
struct UncertaintyRequest
{
    bool evaluate = false;
    std::vector<StatedUncertainty> stated;
};

/// The request of a recipe's section: everything is evaluated, with the uncertainties it states.
UncertaintyRequest uncertaintyRequest(const UncertaintySettings &settings);

/// The quantities whose uncertainty can be stated; any other name changes nothing.
const std::vector<std::string> &statedQuantities();

/// GUM over the whole way from arrivals to step; the velocity is refitted for every change of an
/// input. p1, T1, gas constants, distances and delays are common to all shots, arrival times and an
/// estimated scatter are each shot's own. Stated uncertainties win over recorded ones, recorded
/// ones over the gases' usual ones. Quantities: p1_pa, t1_k, gamma, molar_mass_kg_mol,
/// relative_humidity, carbon_dioxide_fraction, velocity_m_s (typed), distance_m, arrival_s, delay_s
/// (each sensor), and step_relative (what the relations leave out, of the step).
Result<StepUncertainty> evaluateStep(
    const StepMeasurement &measurement, const UncertaintyRequest &request);

/// Of a step that is typed where no velocity is known: its stated step_relative alone; empty where
/// none is stated.
std::optional<StepUncertainty> uncertaintyOfTypedStep(
    double step_Pa, const UncertaintyRequest &request);

/// The same by Monte Carlo.
struct StepMonteCarlo
{
    MonteCarloResult result; ///< in the order of StepResult
    bool validated = false; ///< the step: GUM and Monte Carlo agree (JCGM 101, clause 8)
};

/// Draws from the distributions behind evaluateStep(), whose result is `budget`. `settings.shot`
/// must be the shot's number, so that inputs of one shot alone are drawn independently of other
/// shots.
Result<StepMonteCarlo> simulateStep(const StepMeasurement &measurement,
    const UncertaintyRequest &request, const GumBudget &budget, const MonteCarloSettings &settings,
    const JobControl &control = {});

} // namespace dyncal
