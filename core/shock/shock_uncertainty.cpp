// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/shock/shock_uncertainty.h"

#include "core/shock/variable_shock.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace dyncal {
namespace {

/// One set of values of all that the step follows from.
struct StepPoint
{
    SectionState state;
    double gammaShift = 0.0;
    double molarMassShift_kg_mol = 0.0;
    double velocityShift_m_s = 0.0;
    double stepFactor = 1.0;
    Eigen::VectorXd distance_m;
    Eigen::VectorXd time_s;
    std::vector<CounterReading> counters;
    double attenuation_per_m = 0.0; ///< as observed beforehand
};

using Setter = std::function<void(StepPoint &, double)>;

double velocityAt(const StepMeasurement &m, const StepPoint &point)
{
    const auto &fit = m.velocity.fit;
    double velocity_m_s = *m.velocity.velocity_m_s;
    if (fit && !point.counters.empty())
        velocity_m_s = refittedCounterVelocity_m_s(*fit, point.counters, point.attenuation_per_m);
    else if (fit)
        velocity_m_s
            = refittedVelocity_m_s(*fit, point.distance_m, point.time_s, point.attenuation_per_m);
    return velocity_m_s + point.velocityShift_m_s;
}

Result<Eigen::VectorXd> resultsAt(const StepMeasurement &m, const StepPoint &point)
{
    auto gas = gasModel(m.gas, point.state);
    if (!gas)
        return tl::unexpected(gas.error());
    gas->constants.gamma += point.gammaShift;
    gas->constants.molarMass_kg_mol += point.molarMassShift_kg_mol;
    const auto states = shockStatesOf(
        *gas, point.state.pressure_Pa, point.state.temperature_K, velocityAt(m, point));
    if (!states)
        return tl::unexpected(states.error());
    const GasState &behind = m.atEndWall ? states->reflected : states->shocked;
    Eigen::VectorXd results(kStepResults);
    results << states->velocity_m_s, states->mach, states->shocked.pressure_Pa,
        states->reflected.pressure_Pa,
        point.stepFactor * (behind.pressure_Pa - point.state.pressure_Pa);
    return results;
}

Message notStated(const char *what, const char *quantity)
{
    return {
        DYNCAL_TEXT("core",
            "The uncertainty of %1 is not stated; add '%2' to uncertainty.budget of the recipe."),
        {what, quantity}};
}

/// The inputs, each with the function that puts its value into a StepPoint.
class InputList
{
public:
    InputList(const StepMeasurement &m, const std::vector<StatedUncertainty> &stated)
        : m_measurement(m)
        , m_stated(stated)
    {
        addVelocity();
        addState();
        addGas();
        if (const StatedUncertainty *model = find("step_relative"))
            add({"step_relative", 1.0, model->u, model->distribution, dofOf(*model), true},
                [](StepPoint &p, double x) { p.stepFactor = x; });
    }

    const std::vector<UncertainInput> &inputs() const { return m_inputs; }
    const std::optional<Message> &velocityMissing() const { return m_velocityMissing; }
    const std::optional<Message> &stepMissing() const { return m_stepMissing; }

    Measurement measurement() const
    {
        return [this](const Eigen::VectorXd &x) -> Result<Eigen::VectorXd> {
            StepPoint point = start();
            for (std::size_t i = 0; i < m_setters.size(); ++i)
                m_setters[i](point, x[static_cast<Index>(i)]);
            return resultsAt(m_measurement, point);
        };
    }

private:
    StepPoint start() const
    {
        StepPoint point;
        point.state = m_measurement.state;
        point.counters = m_measurement.counters;
        if (const auto &fit = m_measurement.velocity.fit; fit && fit->attenuation)
            point.attenuation_per_m = fit->attenuation->value_per_m();
        const auto &sightings = m_measurement.velocity.sightings;
        point.distance_m.resize(std::ssize(sightings));
        point.time_s.resize(std::ssize(sightings));
        for (Index i = 0; i < std::ssize(sightings); ++i) {
            point.distance_m[i] = sightings[static_cast<std::size_t>(i)].distance_m;
            point.time_s[i] = sightings[static_cast<std::size_t>(i)].time_s;
        }
        return point;
    }

    const StatedUncertainty *find(const std::string &quantity) const
    {
        const auto found = std::find_if(m_stated.begin(), m_stated.end(),
            [&](const StatedUncertainty &s) { return s.quantity == quantity; });
        return found != m_stated.end() ? &*found : nullptr;
    }

    static double dofOf(const StatedUncertainty &stated)
    {
        return stated.dof.value_or(std::numeric_limits<double>::infinity());
    }

    void add(UncertainInput input, Setter setter)
    {
        m_inputs.push_back(std::move(input));
        m_setters.push_back(std::move(setter));
    }

    /// The stated uncertainty of `quantity`, else `known`; false if neither is above 0.
    bool addKnown(const std::string &name, const std::string &quantity, double value, double known,
        Distribution distribution, bool common, Setter setter)
    {
        UncertainInput input{
            name, value, known, distribution, std::numeric_limits<double>::infinity(), common};
        if (const StatedUncertainty *stated = find(quantity);
            stated && !(known > 0.0 && name != quantity)) {
            input.u = stated->u;
            input.distribution = stated->distribution;
            input.dof = dofOf(*stated);
        }
        if (!(input.u > 0.0))
            return find(quantity) != nullptr; // stated as exact
        add(std::move(input), std::move(setter));
        return true;
    }

    void addVelocity()
    {
        const VelocityEstimate &velocity = m_measurement.velocity;
        if (!velocity.fit) {
            if (!addKnown("velocity_m_s", "velocity_m_s", *velocity.velocity_m_s, 0.0,
                    Distribution::Normal, false,
                    [v = *velocity.velocity_m_s](
                        StepPoint &p, double x) { p.velocityShift_m_s += x - v; }))
                m_velocityMissing = notStated("the velocity", "velocity_m_s");
            return;
        }
        if (const auto &observed = velocity.fit->attenuation)
            add({kAttenuation, observed->value_per_m(), observed->u_per_m(),
                    Distribution::Rectangular, std::numeric_limits<double>::infinity(), true},
                [](StepPoint &p, double x) { p.attenuation_per_m = x; });
        if (velocity.fit->scatterEstimated)
            add({"velocity_scatter", 0.0, velocity.fit->scatter_m_s, Distribution::Normal,
                    static_cast<double>(velocity.fit->dof), false},
                [](StepPoint &p, double x) { p.velocityShift_m_s += x; });
        else if (m_measurement.counters.empty())
            addSightings();
        else
            addCounters();
    }

    /// The channel's name, with a number where an earlier sighting has the same channel.
    static std::string nameOf(const std::vector<Sighting> &sightings, Index i)
    {
        const Sighting &s = sightings[static_cast<std::size_t>(i)];
        const auto earlier = std::count_if(sightings.begin(), sightings.begin() + i,
            [&](const Sighting &other) { return other.channel == s.channel; });
        return earlier > 0 ? s.channel + " (" + std::to_string(earlier + 1) + ")" : s.channel;
    }

    void addSightings()
    {
        const auto &sightings = m_measurement.velocity.sightings;
        for (Index i = 0; i < std::ssize(sightings); ++i) {
            const Sighting &s = sightings[static_cast<std::size_t>(i)];
            const std::string place = std::string("[").append(nameOf(sightings, i)) + "]";
            const bool known = addKnown("distance_m" + place, "distance_m", s.distance_m,
                s.u_distance_m, Distribution::Normal, true,
                [i](StepPoint &p, double x) { p.distance_m[i] = x; });
            if (!known && !s.isDut)
                m_velocityMissing = notStated("the distance of an arrival sensor", "distance_m");
            addKnown("arrival_s" + place, "arrival_s", s.time_s, s.u_time_s, Distribution::Normal,
                false, [i](StepPoint &p, double x) { p.time_s[i] = x; });
            addKnown("delay_s" + place, "delay_s", 0.0, s.u_delay_s, Distribution::Rectangular,
                true, [i](StepPoint &p, double x) { p.time_s[i] -= x; });
        }
    }

    void addCounters()
    {
        for (std::size_t i = 0; i < m_measurement.counters.size(); ++i) {
            const CounterReading &c = m_measurement.counters[i];
            const std::string place = "[counter " + std::to_string(i + 1) + "]";
            if (!addKnown("distance_m" + place, "distance_m", c.far_m - c.near_m, c.u_distance_m,
                    Distribution::Normal, true, [i](StepPoint &p, double x) {
                        // Both ends move apart, so that the middle stays.
                        CounterReading &r = p.counters[i];
                        const double more_m = 0.5 * (x - (r.far_m - r.near_m));
                        r.far_m += more_m;
                        r.near_m -= more_m;
                    }))
                m_velocityMissing = notStated("the distance between two counters", "distance_m");
            addKnown("time_s" + place, "arrival_s", c.time_s, c.u_time_s, Distribution::Normal,
                false, [i](StepPoint &p, double x) { p.counters[i].time_s = x; });
        }
    }

    void need(bool known, const char *what, const char *quantity)
    {
        if (!known)
            m_stepMissing = notStated(what, quantity);
    }

    void addState()
    {
        const SectionState &state = m_measurement.state;
        need(addKnown("p1_pa", "p1_pa", state.pressure_Pa, m_measurement.u_p1_Pa,
                 Distribution::Normal, true,
                 [](StepPoint &p, double x) { p.state.pressure_Pa = x; }),
            "the pressure p1", "p1_pa");
        need(addKnown("t1_k", "t1_k", state.temperature_K, m_measurement.u_T1_K,
                 Distribution::Normal, true,
                 [](StepPoint &p, double x) { p.state.temperature_K = x; }),
            "the temperature T1", "t1_k");
        if (m_measurement.gas.substance != "humid-air" && m_measurement.gas.substance != kMoistAir)
            return;
        need(
            addKnown("relative_humidity", "relative_humidity", state.relativeHumidity,
                m_measurement.u_relativeHumidity, m_measurement.humidityDistribution, true,
                [](StepPoint &p, double x) { p.state.relativeHumidity = std::clamp(x, 0.0, 1.0); }),
            "the relative humidity", "relative_humidity");
        addKnown("carbon_dioxide_fraction", "carbon_dioxide_fraction", state.carbonDioxide, 0.0,
            Distribution::Normal, true,
            [](StepPoint &p, double x) { p.state.carbonDioxide = std::max(x, 0.0); });
    }

    void addGas()
    {
        const auto gas = gasModel(m_measurement.gas, m_measurement.state);
        if (!gas)
            return; // whoever needs the states reports it
        if (!gas->heatCapacity)
            addKnown("gamma", "gamma", gas->constants.gamma, gas->u_gamma, Distribution::Normal,
                true, [value = gas->constants.gamma](StepPoint &p, double x) {
                    p.gammaShift = x - value;
                });
        addKnown("molar_mass_kg_mol", "molar_mass_kg_mol", gas->constants.molarMass_kg_mol,
            gas->u_molarMass_kg_mol, Distribution::Normal, true,
            [value = gas->constants.molarMass_kg_mol](
                StepPoint &p, double x) { p.molarMassShift_kg_mol = x - value; });
    }

    const StepMeasurement &m_measurement;
    const std::vector<StatedUncertainty> &m_stated;
    std::vector<UncertainInput> m_inputs;
    std::vector<Setter> m_setters;
    std::optional<Message> m_velocityMissing;
    std::optional<Message> m_stepMissing;
};

Distribution distributionCalled(const std::string &name)
{
    for (const Distribution distribution :
        {Distribution::Rectangular, Distribution::Triangular, Distribution::UShaped}) {
        if (name == distributionName(distribution))
            return distribution;
    }
    return Distribution::Normal;
}

} // namespace

UncertaintyRequest uncertaintyRequest(const UncertaintySettings &settings)
{
    UncertaintyRequest request;
    request.evaluate = true;
    for (const BudgetEntry &entry : settings.budget)
        request.stated.push_back(
            {entry.quantity, entry.u, distributionCalled(entry.distribution), entry.dof});
    return request;
}

const std::vector<std::string> &statedQuantities()
{
    static const std::vector<std::string> names{"p1_pa", "t1_k", "gamma", "molar_mass_kg_mol",
        "relative_humidity", "carbon_dioxide_fraction", "velocity_m_s", "distance_m", "arrival_s",
        "delay_s", "step_relative"};
    return names;
}

std::optional<double> StepUncertainty::u(StepResult result) const
{
    const bool missing = velocityMissing || (result != StepResult::Velocity && stepMissing);
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
    const InputList list(measurement, request.stated);
    auto budget = propagateGum(list.inputs(), list.measurement());
    if (!budget)
        return tl::unexpected(budget.error());
    StepUncertainty result;
    result.budget = std::move(*budget);
    result.velocityMissing = list.velocityMissing();
    result.stepMissing = list.velocityMissing() ? list.velocityMissing() : list.stepMissing();
    return result;
}

Result<StepMonteCarlo> simulateStep(const StepMeasurement &measurement,
    const UncertaintyRequest &request, const GumBudget &budget, const MonteCarloSettings &settings,
    const JobControl &control)
{
    const InputList list(measurement, request.stated);
    auto result = propagateMonteCarlo(list.inputs(), list.measurement(), settings, control);
    if (!result)
        return tl::unexpected(result.error());
    const bool validated
        = isValidated(budget, *result, static_cast<Index>(StepResult::Step), settings.coverage);
    return StepMonteCarlo{std::move(*result), validated};
}

} // namespace dyncal
