// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/shock/step_inputs.h"

#include "core/shock/variable_shock.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace dyncal {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

Message notStated(const char *what, const char *quantity)
{
    return {
        DYNCAL_TEXT("core",
            "The uncertainty of %1 is not stated; add '%2' to uncertainty.budget of the recipe."),
        {what, quantity}};
}

double dofOf(const StatedUncertainty &stated)
{
    return stated.dof.value_or(kInfinite);
}

/// The channel's name, with a number where an earlier sighting has the same channel.
std::string nameOf(const std::vector<Sighting> &sightings, Index i)
{
    const Sighting &s = sightings[static_cast<std::size_t>(i)];
    const auto earlier = std::count_if(sightings.begin(), sightings.begin() + i,
        [&](const Sighting &other) { return other.channel == s.channel; });
    return earlier > 0 ? s.channel + " (" + std::to_string(earlier + 1) + ")" : s.channel;
}

} // namespace

const VelocityEstimate *StepMeasurement::arrivals() const
{
    if (recorded)
        return &*recorded;
    return velocity.fit && !velocity.sightings.empty() ? &velocity : nullptr;
}

StepInputs::StepInputs(
    const StepMeasurement &m, const std::vector<StatedUncertainty> &stated, Unstated unstated)
    : m_measurement(m)
    , m_stated(stated)
    , m_unstated(unstated)
{
    addVelocity();
    addState();
    addGas();
    addStep();
}

StepPoint StepInputs::at(const Eigen::VectorXd &x) const
{
    StepPoint point = start();
    for (std::size_t i = 0; i < m_setters.size(); ++i)
        m_setters[i](point, x[static_cast<Index>(i)]);
    return point;
}

StepPoint StepInputs::start() const
{
    StepPoint point;
    point.state = m_measurement.state;
    point.counters = m_measurement.counters;
    const auto observe = [&](const std::optional<VelocityFit> &fit) {
        if (fit && fit->attenuation)
            point.attenuation_per_m = fit->attenuation->value_per_m();
    };
    observe(m_measurement.velocity.fit);
    const VelocityEstimate *arrivals = m_measurement.arrivals();
    if (arrivals == nullptr)
        return point;
    observe(arrivals->fit);
    const Index count = std::ssize(arrivals->sightings);
    point.distance_m.resize(count);
    point.time_s.resize(count);
    point.delay_s = Eigen::VectorXd::Zero(count);
    for (Index i = 0; i < count; ++i) {
        point.distance_m[i] = arrivals->sightings[static_cast<std::size_t>(i)].distance_m;
        point.time_s[i] = arrivals->sightings[static_cast<std::size_t>(i)].time_s;
    }
    return point;
}

const StatedUncertainty *StepInputs::find(const std::string &quantity) const
{
    const auto found = std::find_if(m_stated.begin(), m_stated.end(),
        [&](const StatedUncertainty &s) { return s.quantity == quantity; });
    return found != m_stated.end() ? &*found : nullptr;
}

double StepInputs::otherwise(double assumed) const
{
    return m_unstated == Unstated::IsAssumed ? assumed : 0.0;
}

void StepInputs::add(UncertainInput input, Setter setter)
{
    m_inputs.push_back(std::move(input));
    m_setters.push_back(std::move(setter));
}

/// The stated uncertainty of `quantity`, else `known`; false if neither is above 0.
bool StepInputs::addKnown(const std::string &name, const std::string &quantity, double value,
    double known, Distribution distribution, bool common, Setter setter)
{
    UncertainInput input{name, value, known, distribution, kInfinite, common};
    if (const StatedUncertainty *stated = find(quantity);
        stated && !(known > 0.0 && name != quantity)) {
        input.u = stated->u;
        input.distribution = stated->distribution;
        input.dof = dofOf(*stated);
        input.correlated = stated->correlated;
    }
    if (!(input.u > 0.0))
        return find(quantity) != nullptr; // stated as exact
    add(std::move(input), std::move(setter));
    return true;
}

void StepInputs::addTypedVelocity(double velocity_m_s)
{
    if (!addKnown("velocity_m_s", "velocity_m_s", velocity_m_s,
            otherwise(m_measurement.uAssumedVelocity_relative * velocity_m_s), Distribution::Normal,
            false,
            [velocity_m_s](StepPoint &p, double x) { p.velocityShift_m_s += x - velocity_m_s; }))
        m_velocityMissing = notStated("the velocity", "velocity_m_s");
}

void StepInputs::addFit(const VelocityEstimate &estimate, bool ofCounters)
{
    if (const auto &observed = estimate.fit->attenuation)
        add({kAttenuation, observed->value_per_m(), observed->u_per_m(), Distribution::Rectangular,
                kInfinite, true},
            [](StepPoint &p, double x) { p.attenuation_per_m = x; });
    if (estimate.fit->scatterEstimated && m_unstated == Unstated::IsMissing)
        add({"velocity_scatter", 0.0, estimate.fit->scatter_m_s, Distribution::Normal,
                static_cast<double>(estimate.fit->dof), false},
            [](StepPoint &p, double x) { p.velocityShift_m_s += x; });
    else if (ofCounters)
        addCounters();
    else
        addSightings(estimate.sightings);
}

void StepInputs::addVelocity()
{
    const StepMeasurement &m = m_measurement;
    if (!m.velocity.fit)
        addTypedVelocity(*m.velocity.velocity_m_s);
    else
        addFit(m.velocity, !m.counters.empty());
    // A result depends on the velocity used alone; a comparison on both.
    if (m_unstated != Unstated::IsAssumed || !m.recorded)
        return;
    if (m.velocity.fit && m.velocity.fit->attenuation)
        addSightings(m.recorded->sightings); // the attenuation is an input already
    else
        addFit(*m.recorded, false);
}

void StepInputs::addSightings(const std::vector<Sighting> &sightings)
{
    for (Index i = 0; i < std::ssize(sightings); ++i) {
        const Sighting &s = sightings[static_cast<std::size_t>(i)];
        const std::string place = std::string("[").append(nameOf(sightings, i)) + "]";
        const double u_distance_m
            = s.u_distance_m > 0.0 || s.isDut ? s.u_distance_m : otherwise(kAssumed_u_distance_m);
        const bool known = addKnown("distance_m" + place, "distance_m", s.distance_m, u_distance_m,
            Distribution::Normal, true, [i](StepPoint &p, double x) { p.distance_m[i] = x; });
        if (!known && !s.isDut)
            m_velocityMissing = notStated("the distance of an arrival sensor", "distance_m");
        addKnown("arrival_s" + place, "arrival_s", s.time_s, s.u_time_s, Distribution::Normal,
            false, [i](StepPoint &p, double x) { p.time_s[i] = x; });
        addKnown("delay_s" + place, "delay_s", 0.0, s.u_delay_s, Distribution::Rectangular, true,
            [i](StepPoint &p, double x) { p.delay_s[i] = x; });
    }
}

void StepInputs::addCounters()
{
    for (std::size_t i = 0; i < m_measurement.counters.size(); ++i) {
        const CounterReading &c = m_measurement.counters[i];
        const std::string place = "[counter " + std::to_string(i + 1) + "]";
        const double u_distance_m
            = c.u_distance_m > 0.0 ? c.u_distance_m : otherwise(kAssumed_u_distance_m);
        if (!addKnown("distance_m" + place, "distance_m", c.far_m - c.near_m, u_distance_m,
                Distribution::Normal, true, [i](StepPoint &p, double x) {
                    // Both ends move apart, so that the middle stays.
                    CounterReading &r = p.counters[i];
                    const double more_m = 0.5 * (x - (r.far_m - r.near_m));
                    r.far_m += more_m;
                    r.near_m -= more_m;
                }))
            m_velocityMissing = notStated("the distance between two counters", "distance_m");
        addKnown("time_s" + place, "arrival_s", c.time_s, c.u_time_s, Distribution::Normal, false,
            [i](StepPoint &p, double x) { p.counters[i].time_s = x; });
    }
}

void StepInputs::need(bool known, const char *what, const char *quantity)
{
    if (!known)
        m_stateMissing = notStated(what, quantity);
}

void StepInputs::addStep()
{
    const bool isTyped = m_measurement.typedStep_Pa.has_value();
    const bool isKnown = addKnown("step_relative", "step_relative", 1.0,
        isTyped ? otherwise(kAssumedRelativeStep) : 0.0, Distribution::Normal, true,
        [](StepPoint &p, double x) { p.stepFactor = x; });
    if (isTyped && !isKnown)
        m_stepMissing = notStated("the typed pressure step", "step_relative");
    else if (!isTyped)
        m_stepMissing = m_velocityMissing ? m_velocityMissing : m_stateMissing;
}

void StepInputs::addState()
{
    const SectionState &state = m_measurement.state;
    const auto known
        = [this](double u, double assumed) { return u > 0.0 ? u : otherwise(assumed); };
    need(addKnown("p1_pa", "p1_pa", state.pressure_Pa,
             known(m_measurement.u_p1_Pa, kAssumedRelative_p1 * state.pressure_Pa),
             Distribution::Normal, true, [](StepPoint &p, double x) { p.state.pressure_Pa = x; }),
        "the pressure p1", "p1_pa");
    need(addKnown("t1_k", "t1_k", state.temperature_K, known(m_measurement.u_T1_K, kAssumed_u_T1_K),
             Distribution::Normal, true, [](StepPoint &p, double x) { p.state.temperature_K = x; }),
        "the temperature T1", "t1_k");
    if (m_measurement.gas.substance == "humid-air" || m_measurement.gas.substance == kMoistAir)
        addHumidity();
}

void StepInputs::addHumidity()
{
    const SectionState &state = m_measurement.state;
    need(addKnown("relative_humidity", "relative_humidity", state.relativeHumidity,
             m_measurement.u_relativeHumidity, m_measurement.humidityDistribution, true,
             [](StepPoint &p, double x) { p.state.relativeHumidity = std::clamp(x, 0.0, 1.0); }),
        "the relative humidity", "relative_humidity");
    addKnown("carbon_dioxide_fraction", "carbon_dioxide_fraction", state.carbonDioxide, 0.0,
        Distribution::Normal, true,
        [](StepPoint &p, double x) { p.state.carbonDioxide = std::max(x, 0.0); });
}

void StepInputs::addGas()
{
    const auto gas = gasModel(m_measurement.gas, m_measurement.state);
    if (!gas)
        return; // whoever needs the states reports it
    if (!gas->heatCapacity)
        addKnown("gamma", "gamma", gas->constants.gamma, gas->u_gamma, Distribution::Normal, true,
            [value = gas->constants.gamma](StepPoint &p, double x) { p.gammaShift = x - value; });
    addKnown("molar_mass_kg_mol", "molar_mass_kg_mol", gas->constants.molarMass_kg_mol,
        gas->u_molarMass_kg_mol, Distribution::Normal, true,
        [value = gas->constants.molarMass_kg_mol](
            StepPoint &p, double x) { p.molarMassShift_kg_mol = x - value; });
}

RefittedWay recordedWayAt(const StepMeasurement &m, const StepPoint &point)
{
    return refittedWay(*m.arrivals()->fit, point.distance_m, point.time_s - point.delay_s,
        point.attenuation_per_m);
}

double velocityAt(const StepMeasurement &m, const StepPoint &point)
{
    const auto &fit = m.velocity.fit;
    double velocity_m_s = *m.velocity.velocity_m_s;
    if (fit && !point.counters.empty())
        velocity_m_s = refittedCounterVelocity_m_s(*fit, point.counters, point.attenuation_per_m);
    else if (fit)
        velocity_m_s = recordedWayAt(m, point).velocity_m_s;
    return velocity_m_s + point.velocityShift_m_s;
}

Result<GasModel> gasAt(const StepMeasurement &m, const StepPoint &point)
{
    auto gas = gasModel(m.gas, point.state);
    if (!gas)
        return gas;
    gas->constants.gamma += point.gammaShift;
    gas->constants.molarMass_kg_mol += point.molarMassShift_kg_mol;
    return gas;
}

Result<ShockStates> statesAt(const StepMeasurement &m, const StepPoint &point, double velocity_m_s)
{
    const auto gas = gasAt(m, point);
    if (!gas)
        return tl::unexpected(gas.error());
    return shockStatesOf(*gas, point.state.pressure_Pa, point.state.temperature_K, velocity_m_s);
}

double computedStep_Pa(const StepMeasurement &m, const ShockStates &states)
{
    const GasState &behind = m.atEndWall ? states.reflected : states.shocked;
    return behind.pressure_Pa - states.driven.pressure_Pa;
}

double stepAt(const StepMeasurement &m, const StepPoint &point, const ShockStates &states)
{
    return point.stepFactor * m.typedStep_Pa.value_or(computedStep_Pa(m, states));
}

std::optional<GumBudget> budgetOfTypedStep(
    double step_Pa, const std::vector<StatedUncertainty> &stated, Index results, Index ofStep)
{
    const auto known
        = std::ranges::find(stated, std::string("step_relative"), &StatedUncertainty::quantity);
    if (known == stated.end())
        return std::nullopt;
    const auto budget = propagateGum({{"step_relative", 1.0, known->u, known->distribution,
                                         dofOf(*known), true, known->correlated}},
        [=](const Eigen::VectorXd &x) -> Result<Eigen::VectorXd> {
            Eigen::VectorXd all = Eigen::VectorXd::Zero(results);
            all[ofStep] = x[0] * step_Pa;
            return all;
        });
    return budget ? std::optional(*budget) : std::nullopt;
}

} // namespace dyncal
