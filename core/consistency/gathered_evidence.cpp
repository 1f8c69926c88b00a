// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/consistency/gathered_evidence.h"

#include "core/base/number_text.h"
#include "core/capture/channel_units.h"
#include "core/shock/pressure_units.h"

#include <cmath>
#include <string_view>

namespace dyncal {
namespace {

std::string attribute(const CaptureSet &set, const std::string &sensor, const char *name)
{
    const auto card = set.sensors.find(sensor);
    if (card == set.sensors.end())
        return {};
    const auto value = card->second.find(name);
    return value != card->second.end() ? value->second : std::string();
}

std::optional<double> positive(const std::string &text)
{
    const auto value = parseNumber(text);
    return value && std::isfinite(*value) && *value != 0.0 ? value : std::nullopt;
}

/// "mV/kPa" -> 1e-6 in "V/Pa"; empty where it is no such ratio or ends in another unit.
std::optional<double> factorTo(const std::string &unit, const std::string &wanted)
{
    const auto stroke = unit.find('/');
    if (stroke == std::string::npos)
        return std::nullopt;
    const std::string above = unit.substr(0, stroke);
    const auto below = pascalsPer(unit.substr(stroke + 1));
    if (!below)
        return std::nullopt;
    const auto si = siUnitOf(above);
    const std::string base = si ? si->unit : above;
    return base + "/Pa" == wanted ? std::optional((si ? si->factor : 1.0) / *below) : std::nullopt;
}

std::optional<SensorCard> cardOf(
    const CaptureSet &set, const Channel &dut, const std::string &wanted)
{
    const auto stated = positive(attribute(set, dut.sensorId, "sensitivity"));
    const auto factor = factorTo(attribute(set, dut.sensorId, "sensitivity_unit"), wanted);
    if (!stated || !factor)
        return std::nullopt;
    const auto u = positive(attribute(set, dut.sensorId, "u_sensitivity"));
    return SensorCard{std::abs(*stated * *factor), u ? std::abs(*u / *stated) : kAssumedCard};
}

SideReading readingOf(const CaptureSet &set, const Shot &shot, const Sighting &sighting,
    const std::vector<SeenArrival> &seen)
{
    SideReading reading;
    reading.channel = sighting.channel;
    reading.isDut = sighting.isDut;
    for (const SeenArrival &arrival : seen)
        if (arrival.channel == sighting.channel)
            reading.found = arrival.found;
    const Channel *channel = shot.channelCalled(sighting.channel);
    if (channel == nullptr)
        return reading;
    reading.pascals = pascalsPer(channel->unit);
    const auto stated = positive(attribute(set, channel->sensorId, "sensitivity"));
    const auto u = positive(attribute(set, channel->sensorId, "u_sensitivity"));
    reading.uGain_relative = stated && u ? std::abs(*u / *stated) : kAssumedGain;
    return reading;
}

std::optional<DriverEvidence> driverOf(
    const ShockSettings &settings, const Shot &shot, const ShockConditions &conditions)
{
    const double recorded_Pa = settings.p4_Pa.value_or(shot.environment.p4_Pa);
    if (!conditions.driver || !conditions.driverGas || !(recorded_Pa > 0.0))
        return std::nullopt;
    return DriverEvidence{recorded_Pa, *conditions.driverGas, conditions.driver->temperature_K};
}

} // namespace

ShotEvidence gatherEvidence(const CaptureSet &set, const ShockSettings &settings,
    const ShockConditions &conditions, const ShotSensitivity *sensitivity)
{
    const Shot &shot = set.shots.at(static_cast<std::size_t>(conditions.shot - 1));
    ShotEvidence evidence;
    evidence.shot = conditions.shot;
    evidence.measurement = conditions.measurement;
    if (conditions.drivenGas)
        evidence.gas = conditions.drivenGas->constants;
    if (evidence.measurement && evidence.measurement->arrivals() != nullptr)
        for (const Sighting &sighting : evidence.measurement->arrivals()->sightings)
            evidence.readings.push_back(readingOf(set, shot, sighting, conditions.seen));
    evidence.stateFromDriver = settings.stateFrom == "p4";
    if (!evidence.stateFromDriver)
        evidence.driver = driverOf(settings, shot, conditions);
    evidence.step_Pa = conditions.step_Pa;
    if (conditions.stepTyped)
        evidence.typedStep_Pa = conditions.step_Pa;
    const Channel *dut = shot.channelWithRole(ChannelRole::Dut);
    if (sensitivity == nullptr || !sensitivity->sensitivity || dut == nullptr)
        return evidence;
    evidence.sensitivity = std::abs(*sensitivity->sensitivity);
    evidence.uLevel_relative = sensitivity->uLevel_relative;
    evidence.sensitivityUnit = sensitivity->unit;
    evidence.card = cardOf(set, *dut, sensitivity->unit);
    return evidence;
}

} // namespace dyncal
