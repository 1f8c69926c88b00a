// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/project/recipe_fields_shock.h"

#include "core/project/gas_names.h"

namespace dyncal {
namespace {

std::vector<std::string> substanceNames()
{
    std::vector<std::string> names{"custom", kAutoGas};
    for (const auto &[name, settings] : namedGases())
        names.push_back(name);
    return names;
}

/// What the window calls the keys of one of the two gases.
struct GasLabels
{
    const char *gamma;
    const char *molarMass;
    const char *substance;
    const char *heatCapacity;
};

constexpr GasLabels kDrivenGas{
    DYNCAL_TEXT("RecipeLabel", "γ of the driven gas"),
    DYNCAL_TEXT("RecipeLabel", "molar mass of the driven gas"),
    DYNCAL_TEXT("RecipeLabel", "substance of the driven gas"),
    DYNCAL_TEXT("RecipeLabel", "heat capacity of the driven gas"),
};
constexpr GasLabels kDriverGas{
    DYNCAL_TEXT("RecipeLabel", "γ of the driver gas"),
    DYNCAL_TEXT("RecipeLabel", "molar mass of the driver gas"),
    DYNCAL_TEXT("RecipeLabel", "substance of the driver gas"),
    DYNCAL_TEXT("RecipeLabel", "heat capacity of the driver gas"),
};

Codec<GasSettings> gas(const GasLabels &labels)
{
    std::string names = std::string("\"") + kAutoGas + "\", ";
    for (const auto &[name, settings] : namedGases())
        names += "\"" + name + "\", ";
    const std::string needs = "one of " + names + "or an object with gamma and molar_mass_kg_mol";
    const Codec<GasSettings> plain = object<GasSettings>({
        field("gamma", labels.gamma, &GasSettings::gamma, number(1.0, 2.0, Bound::Exclusive), true),
        field("molar_mass_kg_mol", labels.molarMass, &GasSettings::molarMass_kg_mol,
            number(0.0, 1.0, Bound::Exclusive), true),
        field("substance", labels.substance, &GasSettings::substance, oneOf(substanceNames())),
        field("heat_capacity", labels.heatCapacity, &GasSettings::heatCapacity,
            oneOf({kConstantHeatCapacity, kVariableHeatCapacity})),
    });
    const auto read = [plain, needs](const JsonAt &at) -> Result<GasSettings> {
        if (at.value == kAutoGas)
            return recordedGas();
        for (const auto &[name, settings] : namedGases()) {
            if (at.value == name)
                return settings;
        }
        if (!at.value.is_object())
            return mismatch(at, needs);
        Result<GasSettings> typed = plain.read(at);
        if (typed && !at.value.contains("substance"))
            typed->substance = "custom";
        return typed;
    };
    return {needs, read, plain.write, plain.keys};
}

/// null, one number for all shots, or a list with a number or null per shot.
Codec<PerShot> perShot(const Codec<double> &number)
{
    const auto one = orNull(number);
    const auto list = dyncal::list(one, 1);
    const std::string needs = one.needs + ", or a list of one of these per shot";
    const auto read = [=](const JsonAt &at) -> Result<PerShot> {
        if (at.value.is_array())
            return list.read(at).map(
                [](const std::vector<std::optional<double>> &each) { return PerShot(each); });
        if (!at.value.is_number() && !at.value.is_null())
            return mismatch(at, needs);
        return one.read(at).map([](const std::optional<double> &value) {
            PerShot typed;
            typed.common = value;
            return typed;
        });
    };
    const auto write = [=](const PerShot &typed) {
        return typed.each.empty() ? one.write(typed.common) : list.write(typed.each);
    };
    return {needs, read, write};
}

/// null = found in the record, one time, or a list with a time or null per shot; two members share
/// the key.
Field<ArrivalSensor> arrival()
{
    const auto one = orNull(anyNumber());
    const auto perShot = list(one, 1);
    const std::string needs = "null, a time in seconds or a list of one time or null per shot";
    return {"arrival_s", DYNCAL_TEXT("RecipeLabel", "arrival"),
        [=](const JsonAt &at, ArrivalSensor &sensor) -> Result<void> {
            if (!at.value.is_array() && !at.value.is_number() && !at.value.is_null())
                return mismatch(at, needs);
            if (!at.value.is_array()) {
                const auto value = one.read(at);
                if (!value)
                    return tl::unexpected<Error>(value.error());
                sensor.arrival_s = *value;
                return {};
            }
            auto values = perShot.read(at);
            if (!values)
                return tl::unexpected<Error>(values.error());
            sensor.shotArrival_s = std::move(*values);
            return {};
        },
        [=](const ArrivalSensor &sensor) {
            return sensor.shotArrival_s.empty() ? one.write(sensor.arrival_s)
                                                : perShot.write(sensor.shotArrival_s);
        }};
}

Codec<ArrivalSensor> arrivalSensor()
{
    return object<ArrivalSensor>({
        field("channel", DYNCAL_TEXT("RecipeLabel", "channel of the arrival sensor"),
            &ArrivalSensor::channel, nonEmptyText(), true),
        field("distance_to_end_wall_m", DYNCAL_TEXT("RecipeLabel", "distance to end wall"),
            &ArrivalSensor::distanceToEndWall_m, positiveNumber(), true),
        field("u_distance_m", DYNCAL_TEXT("RecipeLabel", "u (distance)"),
            &ArrivalSensor::u_distance_m, nonNegativeNumber()),
        arrival(),
        field("u_arrival_s", DYNCAL_TEXT("RecipeLabel", "u (arrival)"), &ArrivalSensor::u_arrival_s,
            nonNegativeNumber()),
        field("delay_s", DYNCAL_TEXT("RecipeLabel", "delay of the sensor"), &ArrivalSensor::delay_s,
            orNull(anyNumber())),
        field("u_delay_s", DYNCAL_TEXT("RecipeLabel", "u (delay)"), &ArrivalSensor::u_delay_s,
            nonNegativeNumber()),
    });
}

Codec<CounterReading> counterReading()
{
    using C = CounterReading;
    return object<C>({
        field("far_m", DYNCAL_TEXT("RecipeLabel", "far place of the counter"), &C::far_m,
            positiveNumber(), true),
        field("near_m", DYNCAL_TEXT("RecipeLabel", "near place of the counter"), &C::near_m,
            nonNegativeNumber(), true),
        field("time_s", DYNCAL_TEXT("RecipeLabel", "time of the counter"), &C::time_s,
            positiveNumber(), true),
        field("u_distance_m", DYNCAL_TEXT("RecipeLabel", "u (length of the counter)"),
            &C::u_distance_m, nonNegativeNumber()),
        field("u_time_s", DYNCAL_TEXT("RecipeLabel", "u (time of the counter)"), &C::u_time_s,
            nonNegativeNumber()),
    });
}

/// The gases, and what is known of the shock without looking at records.
std::vector<Field<ShockSettings>> conditionFields()
{
    using S = ShockSettings;
    return {
        field("enabled", DYNCAL_TEXT("RecipeLabel", "compute the step from the shock"), &S::enabled,
            boolean()),
        field("p1_pa", DYNCAL_TEXT("RecipeLabel", "p1, absolute"), &S::p1_Pa,
            orNull(positiveNumber())),
        field("t1_k", DYNCAL_TEXT("RecipeLabel", "T1"), &S::T1_K, orNull(positiveNumber())),
        field(
            "t4_k", DYNCAL_TEXT("RecipeLabel", "T4 (driver)"), &S::T4_K, orNull(positiveNumber())),
        field(
            "driven_gas", DYNCAL_TEXT("RecipeLabel", "driven gas"), &S::drivenGas, gas(kDrivenGas)),
        field(
            "driver_gas", DYNCAL_TEXT("RecipeLabel", "driver gas"), &S::driverGas, gas(kDriverGas)),
        field("relative_humidity", DYNCAL_TEXT("RecipeLabel", "relative humidity"),
            &S::relativeHumidity, orNull(number(0.0, 1.0))),
        field("velocity_m_s", DYNCAL_TEXT("RecipeLabel", "velocity of the shock"), &S::velocity_m_s,
            perShot(positiveNumber())),
        field("step_pa", DYNCAL_TEXT("RecipeLabel", "pressure step"), &S::step_Pa,
            perShot(positiveNumber())),
    };
}

/// Sensors and tube.
std::vector<Field<ShockSettings>> tubeFields()
{
    using S = ShockSettings;
    return {
        field("arrival_sensors", DYNCAL_TEXT("RecipeLabel", "arrival sensors"), &S::arrivalSensors,
            list(arrivalSensor())),
        field("driver_length_m", DYNCAL_TEXT("RecipeLabel", "driver section"), &S::driverLength_m,
            orNull(positiveNumber())),
        field("driven_length_m", DYNCAL_TEXT("RecipeLabel", "driven section"), &S::drivenLength_m,
            orNull(positiveNumber())),
        field("inner_diameter_m", DYNCAL_TEXT("RecipeLabel", "inner diameter"), &S::innerDiameter_m,
            orNull(positiveNumber())),
        field("dut_position", DYNCAL_TEXT("RecipeLabel", "place of the DUT"), &S::dutPosition,
            oneOf({"end-wall", "side-wall"})),
        field("front_duration_s", DYNCAL_TEXT("RecipeLabel", "duration of the front"),
            &S::frontDuration_s, nonNegativeNumber()),
        field("u_front_duration_s", DYNCAL_TEXT("RecipeLabel", "u (duration of the front)"),
            &S::u_frontDuration_s, nonNegativeNumber()),
        field("state_from", DYNCAL_TEXT("RecipeLabel", "what the state follows from"),
            &S::stateFrom, oneOf({"velocity", "p2", "p4"})),
        field("p2_pa", DYNCAL_TEXT("RecipeLabel", "p2, absolute"), &S::p2_Pa,
            orNull(positiveNumber())),
        field("p4_pa", DYNCAL_TEXT("RecipeLabel", "driver pressure, absolute"), &S::p4_Pa,
            orNull(positiveNumber())),
        field("carbon_dioxide_fraction", DYNCAL_TEXT("RecipeLabel", "CO₂"), &S::carbonDioxide,
            number(0.0, 0.01)),
        field("counters", DYNCAL_TEXT("RecipeLabel", "counters"), &S::counters,
            list(counterReading())),
        field("attenuation", DYNCAL_TEXT("RecipeLabel", "change of the velocity along the tube"),
            &S::attenuation, oneOf({"auto", "none", "linear"})),
        field("attenuation_per_m",
            DYNCAL_TEXT("RecipeLabel", "range of the attenuation along the tube"),
            &S::attenuation_per_m, interval()),
        field("use_dut_arrival", DYNCAL_TEXT("RecipeLabel", "use the arrival at the DUT"),
            &S::useDutArrival, boolean()),
        field("dut_distance_to_end_wall_m",
            DYNCAL_TEXT("RecipeLabel", "distance of the DUT to the end wall"), &S::dutDistance_m,
            orNull(positiveNumber())),
        field("dut_diameter_m", DYNCAL_TEXT("RecipeLabel", "diameter of the DUT"),
            &S::dutDiameter_m, orNull(positiveNumber())),
        field("tube_length_m", DYNCAL_TEXT("RecipeLabel", "length of the tube"), &S::tubeLength_m,
            orNull(positiveNumber())),
        field("wall_sound_speed_m_s", DYNCAL_TEXT("RecipeLabel", "sound speed of the wall"),
            &S::wallSoundSpeed_m_s, positiveNumber()),
        field("plateau_guard_s", DYNCAL_TEXT("RecipeLabel", "guard before the plateau's end"),
            &S::plateauGuard_s, nonNegativeNumber()),
        field("largest_mach", DYNCAL_TEXT("RecipeLabel", "largest Mach number of the tube"),
            &S::largestMach, number(1.0, 100.0, Bound::Exclusive)),
        field("largest_driver_pressure_pa",
            DYNCAL_TEXT("RecipeLabel", "largest driver pressure of the tube"),
            &S::largestDriverPressure_Pa, positiveNumber()),
    };
}

Codec<ShockSettings> shockCodec()
{
    std::vector<Field<ShockSettings>> fields = conditionFields();
    for (const Field<ShockSettings> &tube : tubeFields())
        fields.push_back(tube);
    return object<ShockSettings>(std::move(fields));
}

} // namespace

std::vector<Field<Recipe>> shockSections()
{
    return {
        field("shock", DYNCAL_TEXT("RecipeLabel", "reference step"), &Recipe::shock, shockCodec()),
    };
}

} // namespace dyncal
