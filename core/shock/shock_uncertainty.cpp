// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/shock/shock_uncertainty.h"

namespace dyncal {
namespace {

Result<Eigen::VectorXd> resultsAt(const StepMeasurement &m, const StepPoint &point)
{
    const auto states = statesAt(m, point, velocityAt(m, point));
    if (!states)
        return tl::unexpected(states.error());
    Eigen::VectorXd results(kStepResults);
    results << states->velocity_m_s, states->mach, states->shocked.pressure_Pa,
        states->reflected.pressure_Pa, stepAt(m, point, *states);
    return results;
}

Measurement measurementOf(const StepMeasurement &m, const StepInputs &inputs)
{
    return [&m, &inputs](const Eigen::VectorXd &x) { return resultsAt(m, inputs.at(x)); };
}

Distribution distributionCalled(const std::string &name)
{
    for (const Distribution distribution :
        {Distribution::Rectangular, Distribution::Triangular, Distribution::UShaped}) {
        if (name == distributionName(distribution))
            return distribution;
    }
    return Distribution::Normal;
}

Correlations correlationsOf(
    const std::string &quantity, const std::vector<CorrelationEntry> &entries)
{
    Correlations list;
    for (const CorrelationEntry &entry : entries) {
        if (entry.quantity == entry.with)
            continue;
        if (entry.quantity == quantity)
            list.push_back({entry.with, entry.coefficient});
        if (entry.with == quantity)
            list.push_back({entry.quantity, entry.coefficient});
    }
    return list;
}

} // namespace

UncertaintyRequest uncertaintyRequest(const UncertaintySettings &settings)
{
    UncertaintyRequest request;
    request.evaluate = true;
    for (const BudgetEntry &entry : settings.budget)
        request.stated.push_back({entry.quantity, entry.u, distributionCalled(entry.distribution),
            entry.dof, correlationsOf(entry.quantity, settings.correlations)});
    return request;
}

const std::vector<std::string> &statedQuantities()
{
    static const std::vector<std::string> names{"p1_pa", "t1_k", "gamma", "molar_mass_kg_mol",
        "relative_humidity", "carbon_dioxide_fraction", "velocity_m_s", "distance_m", "arrival_s",
        "delay_s", "step_relative", "gain_relative", "linearity_relative", "mounting_relative",
        "clock_relative", "reference_gain_relative"};
    return names;
}

std::optional<double> StepUncertainty::u(StepResult result) const
{
    const bool ofState = result != StepResult::Velocity && result != StepResult::Step;
    const bool missing = result == StepResult::Step ? stepMissing.has_value()
                                                    : velocityMissing || (ofState && stateMissing);
    return missing ? std::nullopt : std::optional(budget.u[static_cast<Index>(result)]);
}

double StepUncertainty::contributionOf(const std::string &input, StepResult result) const
{
    for (const BudgetLine &line : budget.lines)
        if (line.input.quantity == input)
            return line.contribution[static_cast<Index>(result)];
    return 0.0;
}

Result<StepUncertainty> evaluateStep(
    const StepMeasurement &measurement, const UncertaintyRequest &request)
{
    const StepInputs list(measurement, request.stated);
    auto budget = propagateGum(list.inputs(), measurementOf(measurement, list));
    if (!budget)
        return tl::unexpected(budget.error());
    StepUncertainty result;
    result.budget = std::move(*budget);
    result.velocityMissing = list.velocityMissing();
    result.stateMissing = list.stateMissing();
    result.stepMissing = list.stepMissing();
    return result;
}

std::optional<StepUncertainty> uncertaintyOfTypedStep(
    double step_Pa, const UncertaintyRequest &request)
{
    auto budget = budgetOfTypedStep(
        step_Pa, request.stated, kStepResults, static_cast<Index>(StepResult::Step));
    if (!budget)
        return std::nullopt;
    const Message none{DYNCAL_TEXT("core", "The velocity of the shock is not known."), {}};
    return StepUncertainty{std::move(*budget), none, none, {}};
}

Result<StepMonteCarlo> simulateStep(const StepMeasurement &measurement,
    const UncertaintyRequest &request, const GumBudget &budget, const MonteCarloSettings &settings,
    const JobControl &control)
{
    const StepInputs list(measurement, request.stated);
    auto result
        = propagateMonteCarlo(list.inputs(), measurementOf(measurement, list), settings, control);
    if (!result)
        return tl::unexpected(result.error());
    const bool validated
        = isValidated(budget, *result, static_cast<Index>(StepResult::Step), settings.coverage);
    return StepMonteCarlo{std::move(*result), validated};
}

} // namespace dyncal
