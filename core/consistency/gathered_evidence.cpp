// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/consistency/gathered_evidence.h"

#include "core/capture/sensor_card.h"
#include "core/shock/pressure_units.h"

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

constexpr const char *kReadsPressure = "Pa/Pa"; ///< the unit of a sensitivity

/// The card's sensitivity in the unit of the calibration; a sensor that is recorded as a pressure
/// should read what is there.
std::optional<SensorCard> comparedCard(
    const std::optional<CardSensitivity> &stated, const std::string &wanted)
{
    const double u = stated && stated->u_relative ? *stated->u_relative : kAssumedCard;
    if (wanted == kReadsPressure)
        return SensorCard{1.0, u};
    if (!stated || stated->unit != wanted)
        return std::nullopt;
    return SensorCard{std::abs(stated->value), u};
}

/// A charge becomes a voltage in its amplifier, whose gain no card of the sensor knows.
bool isCharge(const std::string &unit)
{
    return unit.ends_with("C/Pa");
}

bool isDelayTyped(const ShockSettings &settings, const std::string &channel)
{
    return std::ranges::any_of(settings.arrivalSensors,
        [&](const ArrivalSensor &sensor) { return sensor.channel == channel && sensor.delay_s; });
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
    reading.uGain_relative
        = relativeUncertaintyOfCard(cardOf(set, *channel)).value_or(kAssumedGain);
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
    for (SideReading &reading : evidence.readings)
        reading.isDelayTyped = isDelayTyped(settings, reading.channel);
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
    const auto stated = sensitivityOfCard(cardOf(set, *dut));
    evidence.card = comparedCard(stated, sensitivity->unit);
    if (stated && !evidence.card && !isCharge(stated->unit))
        evidence.otherUnitOfCard = stated->unit;
    return evidence;
}

} // namespace dyncal
