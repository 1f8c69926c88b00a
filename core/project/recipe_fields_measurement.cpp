// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/project/recipe_fields_measurement.h"

#include "core/project/gas_names.h"
#include "core/project/recipe_limits.h"

namespace dyncal {
namespace {

constexpr Index kMostSamples = 1000000000;

std::vector<std::string> substanceNames()
{
    std::vector<std::string> names{"custom"};
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
    std::string names;
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

Codec<ExcludedStretch> excludedStretch()
{
    using S = ExcludedStretch;
    return object<S>({
        field("shot", DYNCAL_TEXT("RecipeLabel", "shot of the stretch"), &S::shot,
            whole(1, kMostShots), true),
        field("from_s", DYNCAL_TEXT("RecipeLabel", "begin of the stretch"), &S::from_s, anyNumber(),
            true),
        field("to_s", DYNCAL_TEXT("RecipeLabel", "end of the stretch"), &S::to_s, positiveNumber(),
            true),
        field("reason", DYNCAL_TEXT("RecipeLabel", "reason for leaving the stretch out"),
            &S::reason, nonEmptyText(), true),
    });
}

/// "auto" (nothing in the list), one time, or one time per shot.
Codec<std::vector<double>> start()
{
    const std::string needs = "\"auto\", a time in seconds or a list of one time per shot";
    const Codec<std::vector<double>> times = list(anyNumber(), 1);
    const auto read = [=](const JsonAt &at) -> Result<std::vector<double>> {
        if (at.value == "auto")
            return std::vector<double>();
        if (at.value.is_number())
            return std::vector<double>{at.value.get<double>()};
        if (!at.value.is_array())
            return mismatch(at, needs);
        return times.read(at);
    };
    const auto write = [times](const std::vector<double> &values) {
        if (values.empty())
            return Json("auto");
        return values.size() == 1 ? Json(values.front()) : times.write(values);
    };
    return {needs, read, write};
}

/// null = nothing is subtracted; two members share the key.
Field<WindowSettings> baseline()
{
    const auto codec = valueOr(Json(nullptr), orAuto(interval()));
    return {"baseline_s", DYNCAL_TEXT("RecipeLabel", "baseline"),
        [codec](const JsonAt &at, WindowSettings &window) -> Result<void> {
            const Result<std::optional<Auto<Interval>>> value = codec.read(at);
            if (!value)
                return tl::unexpected<Error>(value.error());
            window.subtractBaseline = value->has_value();
            window.baseline_s = value->value_or(Auto<Interval>());
            return {};
        },
        [codec](const WindowSettings &window) {
            return codec.write(
                window.subtractBaseline ? std::optional(window.baseline_s) : std::nullopt);
        }};
}

/// "plateau" or a time after the start; two members share the key.
Field<WindowSettings> windowEnd()
{
    const auto codec = valueOr(Json("plateau"), orAuto(positiveNumber()));
    return {"end_s", DYNCAL_TEXT("RecipeLabel", "end of the window"),
        [codec](const JsonAt &at, WindowSettings &window) -> Result<void> {
            const Result<std::optional<Auto<double>>> value = codec.read(at);
            if (!value)
                return tl::unexpected<Error>(value.error());
            window.endAtPlateau = !value->has_value();
            window.end_s = value->value_or(Auto<double>());
            return {};
        },
        [codec](const WindowSettings &window) {
            return codec.write(window.endAtPlateau ? std::nullopt : std::optional(window.end_s));
        }};
}

/// "auto" = search, "none", or the operator's own list; two members share the key.
Field<SpectrumSettings> resonance()
{
    const auto frequencies = list(positiveNumber());
    const std::string needs = "\"auto\", \"none\" or a list of frequencies in hertz";
    return {"resonance", DYNCAL_TEXT("RecipeLabel", "resonance"),
        [=](const JsonAt &at, SpectrumSettings &spectrum) -> Result<void> {
            const bool isWord = at.value == "auto" || at.value == "none";
            if (!isWord && !at.value.is_array())
                return mismatch(at, needs);
            spectrum.searchResonance = at.value == "auto";
            spectrum.resonances_Hz.clear();
            if (isWord)
                return {};
            Result<std::vector<double>> values = frequencies.read(at);
            if (!values)
                return tl::unexpected<Error>(values.error());
            spectrum.resonances_Hz = std::move(*values);
            return {};
        },
        [frequencies](const SpectrumSettings &spectrum) {
            if (spectrum.searchResonance)
                return Json("auto");
            return spectrum.resonances_Hz.empty() ? Json("none")
                                                  : frequencies.write(spectrum.resonances_Hz);
        }};
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
            orNull(positiveNumber())),
        field("step_pa", DYNCAL_TEXT("RecipeLabel", "pressure step"), &S::step_Pa,
            orNull(positiveNumber())),
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
    };
}

Codec<ShockSettings> shockCodec()
{
    std::vector<Field<ShockSettings>> fields = conditionFields();
    for (const Field<ShockSettings> &tube : tubeFields())
        fields.push_back(tube);
    return object<ShockSettings>(std::move(fields));
}

Codec<WindowSettings> windowCodec()
{
    using S = WindowSettings;
    return object<S>({
        field("start", DYNCAL_TEXT("RecipeLabel", "start"), &S::start_s, start()),
        baseline(),
        windowEnd(),
        field("settle_s", DYNCAL_TEXT("RecipeLabel", "settle band"), &S::settle_s,
            orAuto(interval())),
        field("exclude_stretches", DYNCAL_TEXT("RecipeLabel", "stretches left out of the fit"),
            &S::excludeStretches, list(excludedStretch())),
    });
}

Codec<SpectrumSettings> spectrumCodec()
{
    using S = SpectrumSettings;
    return object<S>({
        field("taper", DYNCAL_TEXT("RecipeLabel", "window function"), &S::taper,
            choice<Taper>({{"rectangular", Taper::Rectangular}, {"hann", Taper::Hann}})),
        field("method", DYNCAL_TEXT("RecipeLabel", "estimator"), &S::method,
            choice<SpectrumMethod>(
                {{"periodogram", SpectrumMethod::Periodogram}, {"welch", SpectrumMethod::Welch}})),
        field("segment", DYNCAL_TEXT("RecipeLabel", "segment length"), &S::segment,
            orNull(whole(8, kMostSamples))),
        field("detrend", DYNCAL_TEXT("RecipeLabel", "trend taken off"), &S::detrend,
            choice<Detrend>(
                {{"none", Detrend::None}, {"mean", Detrend::Mean}, {"linear", Detrend::Linear}})),
        field("resonance_band_hz", DYNCAL_TEXT("RecipeLabel", "band of the search"),
            &S::resonanceBand_Hz, orNull(interval())),
        resonance(),
    });
}

} // namespace

std::vector<Field<Recipe>> measurementSections()
{
    return {
        field("shock", DYNCAL_TEXT("RecipeLabel", "reference step"), &Recipe::shock, shockCodec()),
        field("window", DYNCAL_TEXT("RecipeLabel", "window"), &Recipe::window, windowCodec()),
        field("remap", DYNCAL_TEXT("RecipeLabel", "remap to 0..1"), &Recipe::remap, boolean()),
        field(
            "spectrum", DYNCAL_TEXT("RecipeLabel", "spectrum"), &Recipe::spectrum, spectrumCodec()),
    };
}

} // namespace dyncal
