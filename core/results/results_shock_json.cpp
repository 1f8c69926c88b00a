// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/results/results_shock_json.h"

#include "core/shock/step_monte_carlo.h"

namespace dyncal {
namespace {

using Json = JsonRecord::Json;

void addGas(
    JsonRecord &record, const std::string &region, const GasState *state, const std::string &reason)
{
    const auto value = [state](double GasState::*member) {
        return state ? std::optional(state->*member) : std::nullopt;
    };
    record.number("p" + region + "_pa", value(&GasState::pressure_Pa), reason);
    record.number("t" + region + "_k", value(&GasState::temperature_K), reason);
    record.number("rho" + region + "_kg_m3", value(&GasState::density_kg_m3), reason);
    record.number("a" + region + "_m_s", value(&GasState::soundSpeed_m_s), reason);
}

void addStates(JsonRecord &record, const ShockConditions &shock, const std::string &noVelocity)
{
    const ShockStates *states = shock.states ? &*shock.states : nullptr;
    const auto value = [states](double ShockStates::*member) {
        return states ? std::optional(states->*member) : std::nullopt;
    };
    record.number("velocity_m_s", value(&ShockStates::velocity_m_s), noVelocity);
    record.number("mach", value(&ShockStates::mach), noVelocity);
    const std::string noDriver
        = states ? "The driver's temperature or pressure is not known." : noVelocity;
    addGas(record, "1", states ? &states->driven : nullptr, noVelocity);
    addGas(record, "2", states ? &states->shocked : nullptr, noVelocity);
    addGas(record, "3", shock.expandedDriver ? &*shock.expandedDriver : nullptr, noDriver);
    addGas(record, "4", shock.driver ? &*shock.driver : nullptr, noDriver);
    addGas(record, "5", states ? &states->reflected : nullptr, noVelocity);
    record.number(
        "u2_m_s", states ? std::optional(states->shocked.velocity_m_s) : std::nullopt, noVelocity);
    record.number("reflected_velocity_m_s", value(&ShockStates::reflectedVelocity_m_s), noVelocity);
    record.number("reflected_mach", value(&ShockStates::reflectedMach), noVelocity);
}

void addModelOf(
    JsonRecord &record, const char *key, const std::optional<GasModel> &gas, const std::string &why)
{
    if (!gas) {
        record.missing(key, why);
        return;
    }
    record.set(key,
        {{"name", gas->name}, {"gamma", gas->constants.gamma},
            {"molar_mass_kg_mol", gas->constants.molarMass_kg_mol},
            {"heat_capacity", gas->heatCapacity ? kVariableHeatCapacity : kConstantHeatCapacity},
            {"source", gas->source}});
}

Json sightingJson(const Sighting &s, const ShockConditions &shock, std::size_t position)
{
    JsonRecord record;
    record.set("channel", s.channel);
    record.set("distance_to_end_wall_m", s.distance_m);
    record.set("u_distance_m", s.u_distance_m);
    record.number("arrival_s", s.time_s, "Not found.");
    record.set("u_arrival_s", s.u_time_s);
    record.set("u_delay_s", s.u_delay_s);
    record.set("dut", s.isDut);
    const bool fitted
        = shock.velocityFit && shock.velocityFit->residual.size() == std::ssize(shock.sightings);
    record.number("residual_s",
        fitted ? std::optional(shock.velocityFit->residual[static_cast<Index>(position)])
               : std::nullopt,
        "The velocity was not fitted to it.");
    return record.take();
}

void addVelocity(JsonRecord &record, const ShockConditions &shock)
{
    Json arrivals = Json::array();
    for (std::size_t i = 0; i < shock.sightings.size(); ++i)
        arrivals.push_back(sightingJson(shock.sightings[i], shock, i));
    record.set("arrivals", std::move(arrivals));
    const std::string reason = shock.velocityFit ? "Three places at least are needed."
                                                 : "The velocity was not measured.";
    const auto gradient = shock.velocityFit ? shock.velocityFit->gradient_per_s : std::nullopt;
    record.number("velocity_gradient_per_s", gradient, reason);
    record.number("u_velocity_gradient_per_s",
        shock.velocityFit ? shock.velocityFit->u_gradient_per_s : std::nullopt,
        gradient ? "Nothing is left over to estimate it from." : reason);
    if (shock.velocityFit)
        record.set("attenuation_applied", shock.velocityFit->attenuated);
    else
        record.missing("attenuation_applied", reason);
}

constexpr double kCoverageOfLines = 0.95;

Json budgetJson(const GumBudget &budget, StepResult of)
{
    const auto result = static_cast<Index>(of);
    Json lines = Json::array();
    for (std::size_t i = 0; i < budget.lines.size(); ++i) {
        const BudgetLine &line = budget.lines[i];
        JsonRecord record;
        record.set("quantity", line.input.quantity);
        record.number("value", line.input.value, "Not known.");
        record.set("u", line.input.u);
        record.set("distribution", distributionName(line.input.distribution));
        record.number("dof", line.input.dof, "Infinite.");
        record.set("common_to_all_shots", line.input.common);
        record.number("sensitivity", line.sensitivity[result], "Not determined.");
        record.number("contribution", line.contribution[result], "Not determined.");
        record.number("share_percent", budget.sharePercent(i, result), "Not determined.");
        lines.push_back(record.take());
    }
    return lines;
}

/// For `of` "step": "step_dof", "step_k", "step_budget"; null where u is not known.
void addBudgetOf(JsonRecord &record, const char *of, const ShockConditions &shock,
    StepResult result, const std::string &reason)
{
    const std::string name = of;
    if (!shock.uncertainty || !shock.uncertainty->u(result)) {
        for (const char *part : {"_dof", "_k", "_budget"})
            record.missing(name + part, reason);
        return;
    }
    const GumBudget &budget = shock.uncertainty->budget;
    const double dof = budget.dof[static_cast<Index>(result)];
    record.number(name + "_dof", dof, "Infinite.");
    record.number(name + "_k", coverageFactor(dof, kCoverageOfLines), "Not determined.");
    record.set(name + "_budget", budgetJson(budget, result));
}

void addMonteCarlo(JsonRecord &record, const ShotMonteCarlo *shot)
{
    if (shot == nullptr || !shot->outcome) {
        record.missing("monte_carlo", shot ? shot->missing : "Not run.");
        return;
    }
    constexpr auto kStep = static_cast<Index>(StepResult::Step);
    const MonteCarloResult &mc = shot->outcome->result;
    JsonRecord part;
    part.set("trials", mc.trials);
    part.number("step_pa", mc.mean[kStep], "Not finite.");
    part.number("u_step_pa", mc.u[kStep], "Not finite.");
    part.number("low_pa", mc.low[kStep], "Not finite.");
    part.number("high_pa", mc.high[kStep], "Not finite.");
    part.set("gum_validated", shot->outcome->validated);
    record.set("monte_carlo", part.take());
}

void addUncertainty(
    JsonRecord &record, const ShockConditions &shock, const ShotMonteCarlo *monteCarlo)
{
    const std::string reason = shock.uncertaintyMissing ? english(*shock.uncertaintyMissing)
        : shock.states                                  ? std::string(kNoUncertainty)
                                                        : std::string("There is no velocity.");
    const auto u = [&](StepResult result) {
        return shock.uncertainty ? shock.uncertainty->u(result) : std::nullopt;
    };
    record.number("u_velocity_m_s", u(StepResult::Velocity), reason);
    record.number("u_mach", u(StepResult::Mach), reason);
    record.number("u_p2_pa", u(StepResult::P2), reason);
    record.number("u_p5_pa", u(StepResult::P5), reason);
    const auto u_step_Pa = u(StepResult::Step);
    const std::string noStep = shock.stepTyped
        ? "The step is typed, without an uncertainty (step_relative in uncertainty.budget)."
        : reason;
    record.number("u_step_pa", u_step_Pa, noStep);
    addBudgetOf(record, "velocity", shock, StepResult::Velocity, reason);
    addBudgetOf(record, "step", shock, StepResult::Step, reason);
    if (u_step_Pa)
        addMonteCarlo(record, monteCarlo);
    else
        record.missing("monte_carlo", reason);
}

void addPlateau(JsonRecord &record, const ShockConditions &shock, const std::string &noVelocity)
{
    const std::string reason = shock.states
        ? "The driven section's length (of a DUT in the side wall: its distance) is not known."
        : noVelocity;
    const bool known = shock.plateau_s && *shock.plateau_s > 0.0;
    record.number("plateau_s", shock.plateau_s, reason);
    record.number("f_low_hz", known ? std::optional(1.0 / *shock.plateau_s) : std::nullopt, reason);
    record.text("plateau_end", shock.plateauEnd ? plateauEndName(*shock.plateauEnd) : std::string(),
        reason);
    const TubeWaves *waves = shock.diagram ? &shock.diagram->waves : nullptr;
    const std::string noDiagram
        = "The tube's lengths or the arrival at the end wall are not known.";
    record.number("contact_return_s", waves ? std::optional(waves->contactReturn_s) : std::nullopt,
        noDiagram);
    record.number("rarefaction_return_s", waves ? waves->rarefactionReturn_s : std::nullopt,
        "The driver's length, temperature or pressure is not known.");
    record.number("driver_gas_front_s",
        waves ? std::optional(waves->driverGasFront_s) : std::nullopt, noDiagram);
    record.number("side_wall_limit_hz", shock.sideWallLimit_Hz,
        "Only for a DUT in the side wall whose diameter is given.");
}

Json measuredJson(const ShockConditions &shock)
{
    Json list = Json::array();
    for (const MeasuredPressure &m : shock.measured)
        list.push_back({{"region", m.region}, {"channel", m.channel},
            {"measured_pa", finiteOrNull(m.measured_Pa)},
            {"predicted_pa", finiteOrNull(m.predicted_Pa)},
            {"deviation_percent", finiteOrNull(100.0 * m.deviation())}, {"gauge", m.wasGauge}});
    return list;
}

Json shockJson(const ShockConditions &shock, const ShotMonteCarlo *monteCarlo)
{
    const std::string noVelocity = "The shock's velocity is neither given nor measured.";
    JsonRecord record;
    record.set("shot", shock.shot);
    addStates(record, shock, noVelocity);
    addModelOf(record, "driven_gas", shock.drivenGas, noVelocity);
    addModelOf(record, "driver_gas", shock.driverGas, "The driver's temperature is not known.");
    addVelocity(record, shock);
    record.number("step_pa", shock.step_Pa, "Not determined; see the findings.");
    addUncertainty(record, shock, monteCarlo);
    addPlateau(record, shock, noVelocity);
    record.set("measured", measuredJson(shock));
    return record.take();
}

} // namespace

void addShock(JsonRecord &root, const ResultsContext &context)
{
    if (!context.results().shock) {
        root.missing("shock", context.whyMissing());
        return;
    }
    if (!context.recipe.shock.enabled) {
        root.missing("shock", "Not computed: the recipe switches it off (shock.enabled).");
        return;
    }
    Json list = Json::array();
    const auto &drawn = context.results().monteCarlo;
    for (const ShockConditions &shock : context.results().shock->shots)
        list.push_back(shockJson(shock, drawn ? drawn->ofShot(shock.shot) : nullptr));
    root.set("shock", std::move(list));
}

void addCandidates(JsonRecord &section, const ResultsContext &context)
{
    const auto shock = context.results().shock;
    if (!shock) {
        section.missing("candidates", context.whyMissing());
        return;
    }
    Json list = Json::array();
    for (const ShockConditions &shot : shock->shots) {
        for (const TubeResonance &r : shot.resonances)
            list.push_back({{"kind", resonanceKindName(r.kind)}, {"label", r.label()},
                {"frequency_hz", finiteOrNull(r.frequency_Hz)}, {"shot", shot.shot},
                {"follows_gas", r.followsGas}});
    }
    section.set("candidates", std::move(list));
    Json followed = Json::array();
    for (const FollowedPeak &peak : shock->followedPeaks) {
        Json frequencies = Json::array();
        for (const PeakOfShot &p : peak.peaks)
            frequencies.push_back(finiteOrNull(p.frequency_Hz));
        followed.push_back({{"shots", peak.shots}, {"frequency_hz", std::move(frequencies)},
            {"slope", finiteOrNull(peak.test.slope)}, {"u_slope", finiteOrNull(peak.test.u_slope)},
            {"follows_gas", peak.test.followsGas}, {"candidate", peak.candidate}});
    }
    section.set("followed_peaks", std::move(followed));
}

} // namespace dyncal
