// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/consistency/shot_ways.h"

#include "core/consistency/mach_ways.h"
#include "core/shock/polynomial_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace dyncal {
namespace {

using Pair = std::pair<double, double>;

constexpr double kInfinite = std::numeric_limits<double>::infinity();

UncertainInput factorOf(const std::string &quantity, double u, bool common)
{
    return {quantity, 1.0, u, Distribution::Normal, kInfinite, common};
}

double uOfTypedStep(const std::vector<StatedUncertainty> &stated)
{
    const auto known
        = std::ranges::find(stated, std::string("step_relative"), &StatedUncertainty::quantity);
    return known != stated.end() ? known->u : kAssumedRelativeStep;
}

/// The time from sensor i to the sighting nearest the wall: as seen, and as the other sightings
/// with the observed attenuation place both.
Pair timesOf(const VelocityFit &fit, const StepPoint &point, Index i)
{
    const Index count = point.time_s.size();
    const Eigen::VectorXd seen = (point.time_s - point.delay_s).array() - point.time_s[0];
    Eigen::VectorXd x(count - 1), t(count - 1), weight(count - 1);
    for (Index from = 0, to = 0; from < count; ++from) {
        if (from == i)
            continue;
        x[to] = point.distance_m[from];
        t[to] = seen[from];
        weight[to++] = fit.weight[from];
    }
    std::optional<CoefficientPrior> prior;
    if (fit.attenuation) {
        const double u = fit.attenuation->scale * fit.attenuation->u_per_m();
        prior = CoefficientPrior{fit.attenuation->scale * point.attenuation_per_m, 1.0 / (u * u)};
    }
    const Eigen::VectorXd c = fitPolynomial(x, t, weight, prior ? 3 : 2, prior).coefficients;
    const auto at
        = [&](double place) { return c[0] + place * (c[1] + (c.size() > 2 ? place * c[2] : 0.0)); };
    const Index last = i == count - 1 ? count - 2 : count - 1;
    return {seen[last] - seen[i], at(point.distance_m[last]) - at(point.distance_m[i])};
}

} // namespace

/// What the ways share at one point.
struct ShotWays::Derived
{
    double velocity_m_s = kUnknown;
    double recorded_m_s = kUnknown;
    double attenuation_per_m = 0.0;
    GasBefore before;
    std::optional<ShockStates> states;
    std::optional<Error> error;

    double local(double distance_m) const { return 1.0 + attenuation_per_m * distance_m; }
};

ShotWays::ShotWays(const ShotEvidence &evidence, const std::vector<StatedUncertainty> &stated)
    : m_evidence(evidence)
{
    if (evidence.measurement)
        m_stepInputs
            = std::make_unique<StepInputs>(*evidence.measurement, stated, Unstated::IsAssumed);
    if (m_stepInputs)
        m_inputs = m_stepInputs->inputs();
    for (Index i = 0; i < std::ssize(evidence.readings); ++i)
        if (evidence.readings[static_cast<std::size_t>(i)].isDut)
            m_dut = i;
    addInputs(stated);
    addWays();
}

CheckPoint ShotWays::at(const Eigen::VectorXd &x) const
{
    CheckPoint point;
    const Index count = std::ssize(m_evidence.readings);
    if (m_stepInputs)
        point.step = m_stepInputs->at(x);
    point.back_s = Eigen::VectorXd::Constant(count, kUnknown);
    point.gain = point.stepRatio = Eigen::VectorXd::Ones(count);
    const std::size_t first = m_inputs.size() - m_setters.size();
    for (std::size_t i = 0; i < m_setters.size(); ++i)
        m_setters[i](point, x[static_cast<Index>(first + i)]);
    return point;
}

CheckPoint ShotWays::nominal() const
{
    Eigen::VectorXd x(std::ssize(m_inputs));
    for (Index i = 0; i < x.size(); ++i)
        x[i] = m_inputs[static_cast<std::size_t>(i)].value;
    return at(x);
}

ShotWays::Derived ShotWays::derivedAt(CheckPoint &point) const
{
    Derived derived;
    if (!m_stepInputs)
        return derived;
    const StepMeasurement &m = *m_evidence.measurement;
    point.step.time_s *= point.timeFactor;
    point.step.delay_s *= point.timeFactor;
    point.back_s *= point.timeFactor;
    auto gas = gasAt(m, point.step);
    if (!gas) {
        derived.error = std::move(gas.error());
        return derived;
    }
    derived.before
        = {std::move(*gas), point.step.state.pressure_Pa, point.step.state.temperature_K};
    derived.velocity_m_s = velocityAt(m, point.step);
    if (m.arrivals() != nullptr) {
        const RefittedWay way = recordedWayAt(m, point.step);
        derived.recorded_m_s = way.velocity_m_s;
        derived.attenuation_per_m = way.attenuation_per_m;
    }
    auto states = statesAt(m, point.step, derived.velocity_m_s);
    if (states)
        derived.states = *states;
    else
        derived.error = std::move(states.error());
    return derived;
}

Result<Eigen::VectorXd> ShotWays::values(const CheckPoint &point) const
{
    CheckPoint here = point;
    const Derived derived = derivedAt(here);
    if (derived.error)
        return tl::unexpected(*derived.error);
    Eigen::VectorXd values(2 * std::ssize(m_values));
    for (std::size_t i = 0; i < m_values.size(); ++i) {
        const Pair pair = m_values[i](here, derived);
        values[static_cast<Index>(2 * i)] = pair.first;
        values[static_cast<Index>(2 * i + 1)] = pair.second;
    }
    return values;
}

void ShotWays::addInput(UncertainInput input, Setter setter)
{
    m_inputs.push_back(std::move(input));
    m_setters.push_back(std::move(setter));
}

void ShotWays::compare(WayComparison head, Values values)
{
    head.shot = m_evidence.shot;
    m_made.push_back(std::move(head));
    m_values.push_back(std::move(values));
}

void ShotWays::cannot(WayComparison head, Message reason)
{
    head.shot = m_evidence.shot;
    head.missing = std::move(reason);
    m_missing.push_back(std::move(head));
}

/// A factor that the relations do not know exactly: in all shots alike, and in each anew.
void ShotWays::addModel(const std::string &name, double uCommon, double uOwn, const Setter &times)
{
    addInput(factorOf(name, uCommon, true), times);
    addInput(factorOf(name + " of the shot", uOwn, false), times);
}

void ShotWays::addReadingInputs()
{
    for (Index i = 0; i < std::ssize(m_evidence.readings); ++i) {
        const SideReading &reading = m_evidence.readings[static_cast<std::size_t>(i)];
        if (reading.isDut || !reading.found)
            continue;
        const std::string place = "[" + reading.channel + ", " + std::to_string(i + 1) + "]";
        if (reading.pascals)
            addModel("gain" + place, reading.uGain_relative, kGainOfShot,
                [i](CheckPoint &p, double x) { p.gain[i] *= x; });
        if (!reading.found->back)
            continue;
        addModel("ratio of steps" + place, kStepRatioModel, kStepRatioOfShot,
            [i](CheckPoint &p, double x) { p.stepRatio[i] *= x; });
        addInput({"return" + place, reading.found->back->time_s, reading.found->back->u_time_s,
                     Distribution::Normal, kInfinite, false},
            [i](CheckPoint &p, double x) { p.back_s[i] = x; });
    }
}

void ShotWays::addInputs(const std::vector<StatedUncertainty> &stated)
{
    if (m_stepInputs) {
        addReadingInputs();
        addModel("ratio of velocities", kVelocityRatioModel, kVelocityRatioOfShot,
            [](CheckPoint &p, double x) { p.velocityRatio *= x; });
    }
    if (m_evidence.driver)
        addModel("driver pressure", kDriverModel, kDriverOfShot,
            [](CheckPoint &p, double x) { p.p4 *= x; });
    if (m_evidence.typedStep_Pa && !m_stepInputs)
        addInput(factorOf("typed step", uOfTypedStep(stated), true),
            [](CheckPoint &p, double x) { p.step.stepFactor = x; });
    if (m_evidence.sensitivity && std::isfinite(m_evidence.uLevel_relative))
        addInput(factorOf("level", m_evidence.uLevel_relative, false),
            [](CheckPoint &p, double x) { p.level = x; });
    if (m_evidence.card)
        addInput(factorOf("card", m_evidence.card->u_relative, true),
            [](CheckPoint &p, double x) { p.card = x; });
}

void ShotWays::addWays()
{
    if (m_stepInputs) {
        addVelocity();
        addArrivals();
        for (Index i = 0; i < std::ssize(m_evidence.readings); ++i)
            if (!m_evidence.readings[static_cast<std::size_t>(i)].isDut)
                addReading(i);
        addDriver();
    }
    addStep();
    addSensitivity();
}

void ShotWays::addVelocity()
{
    const StepMeasurement &m = *m_evidence.measurement;
    const bool typed = !m.velocity.fit;
    const WayComparison head{.of = Compared::Velocity,
        .a = typed ? Way::Typed : Way::Counters,
        .b = Way::Arrivals,
        .unit = "m/s"};
    if (m.recorded)
        compare(head, [](const CheckPoint &, const Derived &d) {
            return Pair{d.velocity_m_s, d.recorded_m_s};
        });
    else if (typed || !m.counters.empty())
        cannot(
            head, {DYNCAL_TEXT("core", "No arrival sensor with a distance marks the shock."), {}});
}

void ShotWays::addArrivals()
{
    const VelocityEstimate *arrivals = m_evidence.measurement->arrivals();
    if (arrivals == nullptr || !arrivals->fit)
        return;
    const VelocityFit &fit = *arrivals->fit;
    for (Index i = 0; i < std::ssize(arrivals->sightings); ++i) {
        const Sighting &seen = arrivals->sightings[static_cast<std::size_t>(i)];
        if (seen.isDut)
            continue;
        const WayComparison head{.of = Compared::Arrival,
            .a = Way::ThisArrival,
            .b = Way::OtherArrivals,
            .channel = seen.channel,
            .unit = "s"};
        if (arrivals->sightings.size() < 3) {
            cannot(head, {DYNCAL_TEXT("core", "It needs three places; there are two."), {}});
            continue;
        }
        compare(head,
            [&fit, i](const CheckPoint &p, const Derived &) { return timesOf(fit, p.step, i); });
    }
}

void ShotWays::addReading(Index i)
{
    const SideReading &reading = m_evidence.readings[static_cast<std::size_t>(i)];
    WayComparison head{.of = Compared::Mach,
        .a = Way::StepRatio,
        .b = Way::SoundSpeed,
        .channel = reading.channel,
        .unit = "1"};
    if (!reading.found || !reading.found->back) {
        cannot(head,
            {DYNCAL_TEXT("core", "The reflected shock is not seen to pass the sensor again."), {}});
        head.a = Way::VelocityRatio;
        cannot(head,
            {DYNCAL_TEXT("core", "The reflected shock is not seen to pass the sensor again."), {}});
    } else {
        addStepRatio(i, head);
        head.a = Way::VelocityRatio;
        addVelocityRatio(i, head);
    }
    addPressures(i);
}

void ShotWays::addStepRatio(Index i, const WayComparison &head)
{
    const SideArrival &found = *m_evidence.readings[static_cast<std::size_t>(i)].found;
    const double ratio = (found.back->level - found.behind) / (found.behind - found.before);
    if (!std::isfinite(ratio)) {
        cannot(head,
            {DYNCAL_TEXT("core",
                 "The plateau behind the reflected shock is too short at the sensor to be read."),
                {}});
        return;
    }
    compare(head, [i, ratio](const CheckPoint &p, const Derived &d) {
        const auto mach
            = machOfStepRatio(d.before, ratio * p.stepRatio[i], d.local(p.step.distance_m[i]));
        return Pair{mach.value_or(kUnknown), d.states->mach};
    });
}

void ShotWays::addVelocityRatio(Index i, const WayComparison &head)
{
    if (m_dut < 0) {
        cannot(head, {DYNCAL_TEXT("core", "No sensor in the end wall marks the reflection."), {}});
        return;
    }
    compare(head, [i, dut = m_dut](const CheckPoint &p, const Derived &d) {
        const StepPoint &s = p.step;
        const double wall_s = s.time_s[dut] - s.delay_s[dut];
        const double there_s = wall_s - (s.time_s[i] - s.delay_s[i]);
        const double back_s = p.back_s[i] - s.delay_s[i] - wall_s;
        // there_s = x/W (1 - a x/2), to first order in the attenuation a.
        const double bend = 1.0 - 0.5 * d.attenuation_per_m * s.distance_m[i];
        const auto mach = machOfVelocityRatio(d.before, p.velocityRatio * back_s * bend / there_s);
        return Pair{mach.value_or(kUnknown), d.states->mach};
    });
}

void ShotWays::addPressures(Index i)
{
    const SideReading &reading = m_evidence.readings[static_cast<std::size_t>(i)];
    WayComparison head{.of = Compared::P2Rise,
        .a = Way::SideSensor,
        .b = Way::Computed,
        .channel = reading.channel,
        .unit = "Pa"};
    if (!reading.found || !reading.pascals) {
        cannot(head,
            {DYNCAL_TEXT("core",
                 "The channel is no pressure: its unit or the sensor's sensitivity is not stated."),
                {}});
        return;
    }
    const SideArrival &found = *reading.found;
    const double p2_Pa = (found.behind - found.before) * *reading.pascals;
    compare(head, [i, p2_Pa, this](const CheckPoint &p, const Derived &d) {
        const auto local = statesAt(
            *m_evidence.measurement, p.step, d.velocity_m_s * d.local(p.step.distance_m[i]));
        return Pair{
            p.gain[i] * p2_Pa, local ? local->shocked.pressure_Pa - d.before.p1_Pa : kUnknown};
    });
    if (!found.back || !std::isfinite(found.back->level))
        return;
    head.of = Compared::P5Rise;
    const double p5_Pa = (found.back->level - found.before) * *reading.pascals;
    compare(head, [i, p5_Pa](const CheckPoint &p, const Derived &d) {
        // The gain's part is that of p2; the sensor's linearity is its own.
        return Pair{
            p.gain[i] * p.stepRatio[i] * p5_Pa, d.states->reflected.pressure_Pa - d.before.p1_Pa};
    });
}

void ShotWays::addDriver()
{
    const WayComparison head{
        .of = Compared::P4, .a = Way::Recorded, .b = Way::Computed, .unit = "Pa"};
    if (m_evidence.stateFromDriver) {
        cannot(head,
            {DYNCAL_TEXT("core", "The state of the shock follows from the driver pressure."), {}});
        return;
    }
    if (!m_evidence.driver) {
        cannot(head,
            {DYNCAL_TEXT("core", "The driver pressure or its temperature is not recorded."), {}});
        return;
    }
    compare(head, [&driver = *m_evidence.driver](const CheckPoint &p, const Derived &d) {
        const auto implied_Pa = driverPressure_Pa(
            *d.states, d.before.gas.constants, driver.gas.constants, driver.T4_K);
        return Pair{p.p4 * driver.recorded_Pa, implied_Pa ? *implied_Pa : kUnknown};
    });
}

void ShotWays::addStep()
{
    if (!m_evidence.typedStep_Pa)
        return;
    const WayComparison head{
        .of = Compared::Step, .a = Way::Typed, .b = Way::Computed, .unit = "Pa"};
    if (!m_stepInputs) {
        cannot(head, {DYNCAL_TEXT("core", "The velocity of the shock is not known."), {}});
        return;
    }
    compare(
        head, [typed_Pa = *m_evidence.typedStep_Pa, this](const CheckPoint &p, const Derived &d) {
            const double factor = p.step.stepFactor;
            return Pair{typed_Pa * factor, computedStep_Pa(*m_evidence.measurement, *d.states)};
        });
}

void ShotWays::addSensitivity()
{
    const WayComparison head{.of = Compared::Sensitivity,
        .a = Way::Calibration,
        .b = Way::Card,
        .unit = m_evidence.sensitivityUnit};
    if (!m_evidence.sensitivity || !m_evidence.step_Pa) {
        cannot(head, {DYNCAL_TEXT("core", "The sensitivity is not determined."), {}});
        return;
    }
    if (!m_stepInputs && !m_evidence.typedStep_Pa) {
        cannot(
            head, {DYNCAL_TEXT("core", "The uncertainty of the pressure step is not known."), {}});
        return;
    }
    if (!m_evidence.card) {
        cannot(head,
            {DYNCAL_TEXT("core",
                 "The card of the sensor states no sensitivity in the unit of the calibration."),
                {}});
        return;
    }
    const double level = *m_evidence.sensitivity * *m_evidence.step_Pa;
    compare(head,
        [level, card = m_evidence.card->sensitivity, this](const CheckPoint &p, const Derived &d) {
            const double step_Pa = m_stepInputs ? stepAt(*m_evidence.measurement, p.step, *d.states)
                                                : *m_evidence.typedStep_Pa * p.step.stepFactor;
            return Pair{p.level * level / step_Pa, p.card * card};
        });
}

} // namespace dyncal
