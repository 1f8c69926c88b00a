// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/synthesis/laboratory.h"

#include "core/base/number_text.h"
#include "core/synthesis/defects.h"
#include "core/synthesis/recorded_conditions.h"

#include <array>
#include <cmath>

namespace dyncal {
namespace {

using Recorded = RecordedConditions;

constexpr double kCardUncertainty = 0.005; ///< relative, of every sensor's static sensitivity

struct ChannelLabel
{
    const char *name;
    ChannelRole role;
    const char *sensorId;
};

constexpr std::array<ChannelLabel, 3> kLabels{{{"DUT", ChannelRole::Dut, "dut"},
    {"Driven side", ChannelRole::DrivenSide, "side"}, {"Driver", ChannelRole::Driver, "driver"}}};

Attributes sensorCard(const SensorSpec &sensor, ChannelRole role)
{
    return {{"manufacturer", "simulated"}, {"model", sensor.name}, {"serial", "simulated"},
        {"quantity", "pressure"}, {"unit", "V"},
        {"sensitivity", numberText(sensor.sensitivity_V_Pa)},
        {"u_sensitivity", numberText(std::abs(kCardUncertainty * sensor.sensitivity_V_Pa))},
        {"sensitivity_unit", "V/Pa"}, {"role", channelRoleName(role)}};
}

/// To the micrometre, so that the sum of both is what somebody would have written.
double notedDistance_m(const SimulationSettings &settings)
{
    constexpr double kPerMetre = 1e6;
    const double error_m = defectSize(settings, DefectKind::Distance, 1, 0.0);
    return std::round((Recorded::distance_m + error_m) * kPerMetre) / kPerMetre;
}

Attributes tubeDescription(const SimulationSettings &settings)
{
    return {{"driver_length_m", numberText(Recorded::driverLength_m)},
        {"driven_length_m", numberText(Recorded::drivenLength_m)},
        {"inner_diameter_m", numberText(Recorded::innerDiameter_m)},
        {"endflange_to_sensor2_m", numberText(notedDistance_m(settings))},
        {"u_endflange_to_sensor2_m", numberText(Recorded::u_distance_m)}, {"driver_gas", "air"},
        {"driven_gas", "air"}, {"diaphragm", "cellophane"},
        {"gamma1", numberText(Recorded::gas.gamma)}, {"gamma4", numberText(Recorded::gas.gamma)},
        {"M1", numberText(Recorded::gas.molarMass_kg_mol)},
        {"M4", numberText(Recorded::gas.molarMass_kg_mol)}};
}

} // namespace

const SensorSpec &sideSensor()
{
    static const SensorSpec sensor{"side wall", 7.0e-6, {{500e3, 0.7, 1.0}}, {}, {}};
    return sensor;
}

const SensorSpec &driverSensor()
{
    static const SensorSpec sensor{"driver wall", 7.0e-6, {{100e3, 0.7, 1.0}}, 1e3, {}};
    return sensor;
}

CaptureSet laboratorySet(const SimulationSettings &settings)
{
    CaptureSet set;
    set.inputs.push_back({"simulated", "simulated", "", "dyncal-simulation"});
    set.tube = tubeDescription(settings);
    set.sensors["dut"] = sensorCard(settings.sensor, ChannelRole::Dut);
    set.sensors["side"] = sensorCard(sideSensor(), ChannelRole::DrivenSide);
    set.sensors["driver"] = sensorCard(driverSensor(), ChannelRole::Driver);
    set.instruments["digitizer"] = {{"vendor", "simulated"}, {"model", "simulated"},
        {"serial", "simulated"}, {"adc_bits", std::to_string(settings.bits)}};
    return set;
}

Environment recordedEnvironment(const SimulationSettings &settings, Index shot, double p4_Pa)
{
    Environment environment;
    environment.p1_Pa
        = Recorded::p1_Pa * (1.0 + defectSize(settings, DefectKind::Pressure, shot, 0.0));
    environment.u_p1_Pa = Recorded::u_p1_Pa;
    environment.T1_K = Recorded::T1_K + defectSize(settings, DefectKind::Temperature, shot, 0.0);
    environment.u_T1_K = Recorded::u_T1_K;
    environment.p4_Pa = p4_Pa;
    environment.T4_K = Recorded::T4_K;
    environment.ambientPressure_Pa = environment.p1_Pa; // read once: the tube is open to the room
    environment.ambientT_K = environment.T1_K;
    environment.relativeHumidity = 0.0; // the gas is dry, or taken for dry
    return environment;
}

std::string levelLabel(ShotLevel level)
{
    switch (level) {
    case ShotLevel::Low:
        return "Low";
    case ShotLevel::Medium:
        return "Medium";
    case ShotLevel::High:
        return "High";
    case ShotLevel::None:
        break;
    }
    return {};
}

void labelChannel(Channel &channel, std::size_t position, const SensorSpec &sensor)
{
    const ChannelLabel &label = kLabels[position];
    channel.name = label.name;
    channel.role = label.role;
    channel.sensorId = label.sensorId;
    if (label.role == ChannelRole::Dut)
        return;
    for (double &coefficient : channel.polynomial)
        coefficient /= sensor.sensitivity_V_Pa;
    channel.unit = "Pa";
    channel.quantity = "pressure";
    channel.reference = PressureReference::Gauge;
}

} // namespace dyncal
