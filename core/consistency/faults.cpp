// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/consistency/faults.h"

#include "core/shock/gas_model.h"

#include <cmath>

namespace dyncal {
namespace {

bool changeMolarMass(const ShotEvidence &evidence, double size, CheckPoint &point)
{
    point.step.molarMassShift_kg_mol
        += evidence.gas.molarMass_kg_mol * (std::exp(-2.0 * size) - 1.0);
    return true;
}

/// A mole fraction of another gas among the one that was used: molar masses and heat capacities
/// add.
Fault mixtureWith(const NamedGas &other)
{
    return {FindingCause::Gas, 1.0, 1.0, false,
        [&other](const ShotEvidence &evidence, double share, CheckPoint &point) {
            if (share < 0.0 || share > 1.0)
                return false;
            const auto cp_R = [](double gamma) { return gamma / (gamma - 1.0); };
            const Gas &used = evidence.gas;
            const double cp = (1.0 - share) * cp_R(used.gamma) + share * cp_R(other.gamma);
            point.step.gammaShift += cp / (cp - 1.0) - used.gamma;
            point.step.molarMassShift_kg_mol
                += share * (other.molarMass_kg_mol - used.molarMass_kg_mol);
            return true;
        }};
}

bool changeHumidity(const ShotEvidence &evidence, double size, CheckPoint &point)
{
    if (!evidence.measurement)
        return true;
    const std::string &gas = evidence.measurement->gas.substance;
    if (gas != "humid-air" && gas != kMoistAir)
        return true;
    const double humidity = point.step.state.relativeHumidity + size;
    if (humidity < 0.0 || humidity > 1.0)
        return false;
    point.step.state.relativeHumidity = humidity;
    return true;
}

/// A typed step is used as it is; a typed velocity, or that of typed counters, makes the states.
bool changeTyped(const ShotEvidence &evidence, double size, CheckPoint &point)
{
    const bool velocity = evidence.measurement
        && (!evidence.measurement->velocity.fit || !evidence.measurement->counters.empty());
    if (evidence.typedStep_Pa)
        point.step.stepFactor *= std::exp(size);
    else if (velocity)
        point.step.velocityShift_m_s
            += *evidence.measurement->velocity.velocity_m_s * (std::exp(size) - 1.0);
    return true;
}

/// Of all side sensors, or of those whose delay somebody typed.
Fault delays(double usual_s, bool typedAlone)
{
    return {FindingCause::Delay, usual_s, 2e-4, false,
        [typedAlone](const ShotEvidence &evidence, double size_s, CheckPoint &point) {
            for (Index i = 0; i < point.step.delay_s.size(); ++i) {
                const SideReading &reading = evidence.readings[static_cast<std::size_t>(i)];
                if (!reading.isDut && (!typedAlone || reading.isDelayTyped))
                    point.step.delay_s[i] += size_s;
            }
            return true;
        }};
}

/// By the sensor's name: its place in the list is another one where a shot missed a sensor.
Fault distanceOf(const std::string &sensor)
{
    return {FindingCause::Distance, 0.02, 0.5, false,
        [sensor](const ShotEvidence &evidence, double size_m, CheckPoint &point) {
            for (Index i = 0; i < point.step.distance_m.size(); ++i) {
                const SideReading &reading = evidence.readings[static_cast<std::size_t>(i)];
                if (reading.isDut || reading.channel != sensor)
                    continue;
                point.step.distance_m[i] += size_m;
                return point.step.distance_m[i] > 0.0;
            }
            return true;
        }};
}

} // namespace

std::vector<Fault> possibleFaults(const std::vector<std::string> &sensors)
{
    using C = FindingCause;
    const auto plain = [](const std::function<void(double, CheckPoint &)> &change) {
        return [change](const ShotEvidence &, double size, CheckPoint &point) {
            change(size, point);
            return true;
        };
    };
    std::vector<Fault> list{
        {C::Typed, 1.0, 12.0, true, changeTyped},
        {C::Rate, 1.0, 7.0, false,
            plain([](double s, CheckPoint &p) { p.timeFactor *= std::exp(s); })},
        {C::Gas, 0.3, 2.0, false, changeMolarMass},
        {C::Temperature, 10.0, 60.0, false,
            plain([](double s, CheckPoint &p) { p.step.state.temperature_K += s; })},
        {C::Humidity, 0.5, 1.0, false, changeHumidity},
        {C::Pressure, 0.1, 4.0, false,
            plain([](double s, CheckPoint &p) { p.step.state.pressure_Pa *= std::exp(s); })},
        {C::Scale, 1.0, 12.0, false,
            plain([](double s, CheckPoint &p) { p.level *= std::exp(s); })},
        {C::Scale, 0.1, 12.0, false, plain([](double s, CheckPoint &p) { p.gain *= std::exp(s); })},
        {C::Attenuation, 0.005, 0.2, false,
            plain([](double s, CheckPoint &p) { p.step.attenuation_per_m += s; })},
        delays(2e-6, false),
        delays(2e-5, true),
    };
    for (const NamedGas &gas : knownGases())
        list.push_back(mixtureWith(gas));
    for (const std::string &sensor : sensors)
        list.push_back(distanceOf(sensor));
    return list;
}

} // namespace dyncal
